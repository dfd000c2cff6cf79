# SPDX-License-Identifier: GPL-3.0-or-later
"""The shader nodes of a material as one Surface: the terms of glTF's material."""

from dataclasses import dataclass, field, replace

from .losses import label
from .mean_values import luminance, mean_of
from .shader_mix import BLACK, ONE, ZERO, added, factor_input, mixed, scaled
from .sockets import Place, Source, Unknown, follow, origin

# What a texture can give, if need be one that Cycles bakes.
TERMS = ("base", "metallic", "roughness", "emission", "alpha", "coat", "coat_roughness",
         "transmitted")

# glTF has colour layers for the base colour alone.
_WITH_COLOUR_LAYER = ("Base Color", "Color")


# Inputs of a Principled BSDF, and what they are for.
_REFUSED = {"Anisotropic": "anisotropy", "Transmission Roughness": "roughness of transmission",
            "Thin Film Thickness": "thin film"}


@dataclass
class Surface:
    """Every term is a Source; numbers are floats.  The losses of the Sources in TERMS and of the
    normal are not in `losses`: a bake may make up for them."""

    base: Source = Source((0.8, 0.8, 0.8, 1.0))
    metallic: Source = ZERO
    roughness: Source = ONE
    specular: tuple = (0.0, 0.0, 0.0)  # factor of the reflection that the ior has head-on
    ior: float = 1.5
    transmission: Source = ZERO
    diffuse_transmission: float = 0.0
    transmitted: Source = BLACK  # colour of the diffuse transmission
    emission: Source = BLACK
    alpha: Source = ONE
    coat: Source = ZERO
    coat_roughness: Source = ZERO
    sheen: tuple = (0.0, 0.0, 0.0)
    sheen_roughness: float = 0.0
    is_lambert: bool = False  # diffuse alone, the same at every roughness
    refraction_loss: str = None  # of `losses`: a Refraction BSDF does not reflect
    normal: object = None  # a Texture
    normal_loss: str = None
    normal_scale: float = 1.0
    kind: str = ""  # GLOSSY or REFRACTION: made of such a node alone
    losses: list = field(default_factory=list)


class _Reader:
    """Reads the inputs of a shader node; what it cannot follow it names and takes as unlinked."""

    def __init__(self, node, path, losses):
        self.node, self.path, self.losses = node, path, losses

    def socket(self, *names):
        """The first input of these names that the node has; Blender 4 renamed many."""
        return next((self.node.inputs[name] for name in names if name in self.node.inputs), None)

    def _place(self, socket):
        return Place(tuple(group.name for group in self.path), self.node.name, socket.identifier)

    def term(self, *names, default=0.0):
        """The Source at an input, which carries its loss; `default` where the node has no such
        input."""
        socket = self.socket(*names)
        if socket is None:
            return Source((default,))
        try:
            source = follow(socket, self.path)
            if source.colour_layer is None or names[0] in _WITH_COLOUR_LAYER:
                return replace(source, place=self._place(socket))
            raise Unknown("'Color Attribute'")
        except Unknown as unknown:
            return self._instead(socket, f"node {unknown} at {socket.name} cannot be expressed")

    def _instead(self, socket, loss):
        """What stands for nodes that hipmap cannot follow: their mean, or the input's own value."""
        own = socket.default_value
        own = tuple(own) if hasattr(own, "__len__") else (float(own),)
        mean = mean_of(socket, self.path)
        if mean is None:
            return Source(own, place=self._place(socket),
                          loss=loss + ": rendered with the input's own value")
        value = (*mean, 1.0) if len(own) > 1 else (luminance(mean),)
        is_ray = origin(socket, self.path)[0].node.bl_idname == "ShaderNodeLightPath"
        return Source(value, place=self._place(socket), loss=loss + (
            ": rendered as for the camera" if is_ray else ": rendered as its mean"))

    def source(self, *names, default=0.0):
        """The Source at an input whose loss nothing can make up for."""
        source = self.term(*names, default=default)
        if source.loss:
            self.losses.append(source.loss)
        return source

    def number(self, *names, default=0.0):
        """A plain number; of a texture its factor, and the loss of the texture is named."""
        source = self.source(*names, default=default)
        if not source.is_plain:
            self.losses.append(f"an image at {names[0]} cannot be expressed: rendered with the "
                               "input's own value")
            return float(self.socket(*names).default_value)
        return source.value[0]

    def refuse(self, name, what):
        """Names an input that is in use and not rendered."""
        socket = self.socket(name)
        if socket is not None and (socket.is_linked or socket.default_value > 0):
            self.losses.append(what)


def _begin(node, path, **terms):
    """A Surface of these terms, and the reader of the node that it is made of."""
    surface = Surface(**terms)
    return surface, _Reader(node, path, surface.losses)


def _emission(reader, strength_name):
    colour = reader.term("Emission Color", "Emission", "Color", default=0.0)
    return replace(scaled(colour, reader.number(strength_name)), colour_layer=None)


def _read_normal(reader, surface):
    socket = reader.socket("Normal")
    output, path = origin(socket, reader.path) if socket is not None else (None, ())
    if output is None:
        return
    node = output.node
    if node.bl_idname != "ShaderNodeNormalMap" or node.space != "TANGENT":
        surface.normal_loss = (f"node {label(node)} at Normal cannot be expressed: rendered with "
                               "the mesh's own normals")
        return
    inner = _Reader(node, path, surface.losses)
    surface.normal = inner.source("Color").texture
    surface.normal_scale = inner.number("Strength")


def _specular(reader, surface, transmission):
    """Factor of the head-on reflection, so that it is as in Blender."""
    if reader.socket("Specular IOR Level") is not None:  # Blender 4: relative to the ior
        level = 2 * reader.number("Specular IOR Level")
        tint = reader.source("Specular Tint").numbers()
        return tuple(level * c for c in tint)
    level, tint = reader.number("Specular"), reader.number("Specular Tint")
    base = surface.base.numbers()
    light = 0.3 * base[0] + 0.6 * base[1] + 0.1 * base[2]
    tinted = [1 - tint + tint * (c / light if light > 0 else 0) for c in base]
    # 8 % at 1, whatever the ior, which glTF's factor is relative to.
    head_on = ((surface.ior - 1) / (surface.ior + 1)) ** 2
    opaque = 0.08 * level / head_on if head_on > 0 else 1
    return tuple(((1 - transmission) * opaque + transmission) * c for c in tinted)


def _principled(node, path):
    surface, reader = _begin(node, path)
    surface.base = reader.term("Base Color")
    _mix_subsurface(reader, surface)
    surface.metallic = reader.term("Metallic")
    surface.roughness = reader.term("Roughness")
    surface.transmission = reader.source("Transmission Weight", "Transmission")
    transmits = surface.transmission.value[0]
    if transmits > 0 or reader.socket("Specular IOR Level") is not None:
        surface.ior = reader.number("IOR", default=1.5)
    surface.specular = _specular(reader, surface, transmits)
    surface.emission = _emission(reader, "Emission Strength")
    surface.alpha = reader.term("Alpha", default=1.0)
    surface.coat = reader.term("Coat Weight", "Clearcoat")
    surface.coat_roughness = reader.term("Coat Roughness", "Clearcoat Roughness")
    _read_sheen(reader, surface)
    _read_normal(reader, surface)
    for name in ("Subsurface", "Subsurface Weight"):
        reader.refuse(name, "its subsurface scattering is rendered as diffuse")
    for name, what in _REFUSED.items():
        reader.refuse(name, f"its {what} is not rendered")
    return surface


def _mix_subsurface(reader, surface):
    """Blender 3 mixes a colour of its own into the base by the weight of the scattering."""
    if reader.socket("Subsurface Color") is None or surface.base.loss or not surface.base.is_plain:
        return
    below = reader.term("Subsurface Color")
    weight = min(max(reader.number("Subsurface"), 0), 1)
    if weight > 0 and below.is_plain and not below.loss:
        surface.base = replace(surface.base, value=(*(
            a + weight * (b - a) for a, b in zip(surface.base.numbers(), below.numbers())), 1.0))


def _read_sheen(reader, surface):
    if reader.socket("Sheen Weight") is None:
        reader.refuse("Sheen", "its sheen is not rendered")
        return
    weight = reader.number("Sheen Weight")
    surface.sheen = tuple(weight * c for c in reader.source("Sheen Tint").numbers())
    surface.sheen_roughness = reader.number("Sheen Roughness")


def _diffuse(node, path):
    surface, reader = _begin(node, path, is_lambert=True)
    surface.base = reader.term("Color")
    reader.refuse("Roughness", "the roughness of its Diffuse BSDF is not rendered")
    _read_normal(reader, surface)
    return surface


def _glossy(node, path):
    surface, reader = _begin(node, path, metallic=ONE, specular=(1.0, 1.0, 1.0), kind="GLOSSY")
    surface.base = reader.term("Color")
    surface.roughness = reader.term("Roughness")
    reader.refuse("Anisotropy", "its anisotropy is not rendered")
    _read_normal(reader, surface)
    return surface


def _glass(node, path):
    surface, reader = _begin(node, path, transmission=ONE, specular=(1.0, 1.0, 1.0))
    surface.base = reader.term("Color")
    surface.roughness = reader.term("Roughness")
    surface.ior = reader.number("IOR")
    _read_normal(reader, surface)
    if node.bl_idname == "ShaderNodeBsdfRefraction":
        surface.kind = "REFRACTION"
        surface.refraction_loss = f"node {label(node)} is rendered as glass, which reflects too"
        surface.losses.append(surface.refraction_loss)
    return surface


def _translucent(node, path):
    surface = Surface(diffuse_transmission=1.0)
    surface.transmitted = _Reader(node, path, surface.losses).term("Color")
    surface.base = replace(surface.transmitted, place=None, loss=None)
    return surface


def _transparent(node, path):
    surface = Surface(alpha=ZERO)
    colour = _Reader(node, path, surface.losses).source("Color")
    if not colour.is_plain or min(colour.value) < 1:
        surface.losses.append(f"the colour of node {label(node)} is not rendered")
    return surface


def _light(node, path):
    surface = Surface(base=BLACK)
    surface.emission = _emission(_Reader(node, path, surface.losses), "Strength")
    return surface


def _mix(node, path):
    first, second = (_read(socket, path) for socket in node.inputs[1:3])
    factor = _Reader(node, path, []).term(factor_input(node).name)
    return mixed(first, second, factor, node, path)


def _add(node, path):
    return added(*(_read(socket, path) for socket in node.inputs[:2]), node)


def _unknown(node, path):
    surface = Surface(is_lambert=True)
    if "Color" in node.inputs:
        surface.base = _Reader(node, path, surface.losses).term("Color")
    surface.losses.append(f"node {label(node)} cannot be expressed: rendered as diffuse")
    return surface


_READERS = {
    "ShaderNodeBsdfPrincipled": _principled, "ShaderNodeBsdfDiffuse": _diffuse,
    "ShaderNodeBsdfGlossy": _glossy, "ShaderNodeBsdfAnisotropic": _glossy,
    "ShaderNodeBsdfGlass": _glass, "ShaderNodeBsdfRefraction": _glass,
    "ShaderNodeBsdfTranslucent": _translucent, "ShaderNodeBsdfTransparent": _transparent,
    "ShaderNodeEmission": _light, "ShaderNodeMixShader": _mix, "ShaderNodeAddShader": _add,
}


def _read(socket, path):
    output, outer = origin(socket, path)
    if output is None or output.node.mute:
        return Surface(base=BLACK)
    return _READERS.get(output.node.bl_idname, _unknown)(output.node, outer)


def material_output(material):
    """Returns the output node that Cycles takes; None: there is none."""
    tree = material.node_tree
    return tree.get_output_node("CYCLES") if material.use_nodes and tree else None


def surface_of(material):
    """Returns the Surface of a material; None: it has a volume and no surface.  A material without
    nodes is diffuse, as Cycles renders it."""
    if not material.use_nodes:
        return Surface(base=Source((*material.diffuse_color[:3], 1.0)), is_lambert=True)
    output = material_output(material)
    if output is None:
        return Surface(base=BLACK)
    if not output.inputs["Surface"].is_linked and output.inputs["Volume"].is_linked:
        return None
    surface = _read(output.inputs["Surface"], ())
    if output.inputs["Displacement"].is_linked:
        surface.losses.append("its displacement is not rendered")
    return surface
