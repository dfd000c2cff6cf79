# SPDX-License-Identifier: GPL-3.0-or-later
"""Lights: KHR_lights_punctual, and the custom properties for what glTF lacks."""

import math

from .ies import ies_node, ies_problem, write_ies
from .losses import label
from .sockets import Unknown, follow

# The exporter's Standard mode, which hipmap takes by default: lumens of a watt.
_LUMENS_PER_WATT = 683
_KINDS = {"POINT": "point", "SPOT": "spot", "SUN": "directional"}
_DISCS = ("DISK", "ELLIPSE")
_WITH_HEIGHT = ("RECTANGLE", "ELLIPSE")

# A spread of 180 degrees is none.
_WHOLE_SPREAD_DEG = 179.9

# Cycles takes this many lumens for a watt of an IES file.
_LUMENS_PER_WATT_OF_IES = 177.83


def _emission_node(light):
    """The Emission node at the surface output of a light with nodes; None: there is none."""
    if not light.use_nodes or not light.node_tree:
        return None
    output = next((node for node in light.node_tree.nodes
                   if node.bl_idname == "ShaderNodeOutputLight" and node.is_active_output), None)
    if output is None or not output.inputs["Surface"].is_linked:
        return None
    node = output.inputs["Surface"].links[0].from_node
    return node if node.bl_idname == "ShaderNodeEmission" else None


def _plain_source(socket):
    """The Source of an input without an image; None: it is beyond hipmap."""
    try:
        source = follow(socket)
    except Unknown:
        return None
    return source if source.is_plain else None


def _radiant_colour(light):
    """Colour times power, three numbers: Cycles multiplies the light's own by its nodes'."""
    power = light.energy * 2 ** getattr(light, "exposure", 0)  # Blender 4.4 and later
    colour = [c * power for c in light.color]
    if getattr(light, "use_temperature", False):
        colour = [c * t for c, t in zip(colour, light.temperature_color)]
    emission = _emission_node(light)
    for socket in _factors(emission) if emission else ():
        source = _plain_source(socket)
        if source is not None:
            colour = [c * t for c, t in zip(colour, source.numbers())]
    return colour


def _factors(emission):
    """Inputs that multiply the colour and the power of a light.  A profile has a strength of its
    own."""
    profile = ies_node(emission)
    return emission.inputs["Color"], (profile or emission).inputs["Strength"]


def _profile(light):
    """The IES Texture that a light is rendered with; None: there is none."""
    emission = _emission_node(light)
    node = ies_node(emission) if emission else None
    return node if node and light.type == "POINT" and ies_problem(node) is None else None


def _split(colour):
    """A colour whose greatest channel is 1, and the factor it was divided by."""
    most = max(colour)
    return ([c / most for c in colour], most) if most > 0 else ([1.0, 1.0, 1.0], 0.0)


def punctual_light(light):
    """Returns the entry of KHR_lights_punctual for a point, spot or sun; None for an area light,
    which glTF lacks.  A negative power becomes 0."""
    if light.type not in _KINDS:
        return None
    colour, power = _split([max(c, 0.0) for c in _radiant_colour(light)])
    per_lumen = 1 if light.type == "SUN" else 4 * math.pi
    entry = {"name": light.name, "type": _KINDS[light.type], "color": colour,
             "intensity": power / per_lumen * _LUMENS_PER_WATT}
    if light.type == "SPOT":
        outer = 0.5 * light.spot_size
        entry["spot"] = {"innerConeAngle": outer * (1 - light.spot_blend), "outerConeAngle": outer}
    return entry


def light_extras(light, folder):
    """Returns the custom property `hipmap` of a light's object: its size, a photometric file, which
    is written to a folder, and all of an area light.  hipmap's area lights have the power pi area
    radiance, Cycles' 4 area radiance."""
    if light.type == "SUN":
        return {"angle_deg": math.degrees(light.angle)}
    colour, power = _split([max(c, 0.0) for c in _radiant_colour(light)])
    profile = _profile(light)
    if profile is not None:  # its colour is the light's
        return {"ies": write_ies(profile, folder),
                "ies_scale": power * _LUMENS_PER_WATT / _LUMENS_PER_WATT_OF_IES}
    if light.type != "AREA":
        return {"radius": light.shadow_soft_size}
    return {"area_power": power * math.pi / 4, "area_color": colour,
            "area_width": light.size,
            "area_height": light.size_y if light.shape in _WITH_HEIGHT else light.size,
            "area_shape": "disc" if light.shape in _DISCS else "rectangle",
            **_spread_extras(light)}


def _spread_extras(light):
    """The angle over which an area light emits, where that is less than its whole side."""
    degrees = math.degrees(getattr(light, "spread", math.pi))
    return {"area_spread_deg": degrees} if degrees < _WHOLE_SPREAD_DEG else {}


def _node_losses(light):
    if not light.use_nodes or not light.node_tree:
        return
    emission = _emission_node(light)
    if emission is None:
        yield "its nodes are not one Emission node: rendered without them"
        return
    profile = ies_node(emission)
    if profile is not None:
        yield from _profile_losses(light, profile)
    for name in ("Color", "Strength") if profile is None else ("Color",):
        if _plain_source(emission.inputs[name]) is None:
            node = emission.inputs[name].links[0].from_node
            yield f"node {label(node)} at the {name.lower()} of its Emission is not rendered"


def _profile_losses(light, node):
    problem = ies_problem(node)
    if light.type != "POINT":
        yield f"node {label(node)} is rendered on point lights alone"
    elif problem is not None:
        yield f"node {label(node)}: {problem}: rendered without it"
    elif light.shadow_soft_size > 0:
        yield f"its radius is not rendered beside node {label(node)}: its shadows are sharp"


def is_portal(light):
    """Whether a light is a portal: it emits nothing, and marks for Cycles an opening to the sky."""
    return getattr(getattr(light, "cycles", None), "is_portal", False)


def light_losses(light):
    """Yields what hipmap does not render of a light, one line each."""
    name = f"light '{light.name}': "
    for loss in _node_losses(light):
        yield name + loss
    if min(_radiant_colour(light)) < 0:
        yield name + "its power is negative: rendered as 0"
    if not getattr(light, "use_shadow", True) or \
            not getattr(getattr(light, "cycles", None), "cast_shadow", True):
        yield name + "it casts shadows, although its shadows are switched off"
