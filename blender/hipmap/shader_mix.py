# SPDX-License-Identifier: GPL-3.0-or-later
"""Two shaders that a node mixes or adds, as one Surface."""

from dataclasses import replace

import bpy

from .losses import label
from .mean_values import mean_fresnel
from .sockets import Source, Unknown, follow, origin

BLACK = Source((0.0, 0.0, 0.0, 1.0))
ONE, ZERO = Source((1.0,)), Source((0.0,))

# Burley's diffuse reflection is closest to Lambert's at this roughness.
_ROUGHNESS_OF_LAMBERT = Source((0.5,))

# Blender before 4 leaves the base whole under its reflection.
_BASE_STAYS_WHOLE = bpy.app.version < (4, 0, 0)


def mixed(first, second, factor, node, path):
    """Returns the Surface of a Mix Shader.  factor: a Source; path: of the node."""
    if factor.is_plain and factor.value[0] in (0, 1) and (
            not factor.loss or origin(factor_input(node), path)[0].node.type == "LIGHT_PATH"):
        chosen = second if factor.value[0] == 1 else first
        chosen.losses += [factor.loss] if factor.loss else []
        return chosen
    for make in (_cut_out, _coated, _partly_translucent):
        found = make(first, second, factor, node, path)
        if found is not None:
            return found
    greater = second if factor.value[0] >= 0.5 else first
    greater.losses = [*dict.fromkeys(first.losses + second.losses)] + [
        f"node {label(node)} cannot be expressed: the shader of greater weight is rendered alone"]
    return greater


def added(first, second, node):
    """Returns the Surface of an Add Shader."""
    for light, other in ((first, second), (second, first)):
        if light.base == BLACK and other.emission.value[:3] == (0, 0, 0):
            other.emission = light.emission
            other.losses = light.losses + other.losses
            return other
    first.losses += second.losses + [f"node {label(node)} cannot be expressed: its first shader "
                                     "is rendered alone"]
    return first


def factor_input(node):
    """Returns the factor's input of a Mix Shader."""
    return node.inputs[0]


def scaled(colour, factor):
    """Returns the Source of a colour times a factor."""
    place = colour.place and replace(colour.place, factor=colour.place.factor * factor)
    return replace(colour, value=(*(c * factor for c in colour.numbers()), 1.0), place=place)


def _is_invisible(surface):
    return surface.alpha == ZERO


def _cut_out(first, second, factor, _node, _path):
    """A shader mixed with a Transparent BSDF; None: neither is one."""
    if _is_invisible(first) and second.alpha == ONE:
        second.alpha, second.losses = factor, first.losses + second.losses
        return second
    if _is_invisible(second) and first.alpha == ONE and factor.is_plain:
        first.alpha = replace(factor, value=(1 - factor.value[0],), place=None, loss=None)
        first.losses += second.losses + ([factor.loss] if factor.loss else [])
        return first
    return None


def _is_diffuse(surface):
    """Whether a Surface has no reflection and lets no light pass straight on."""
    return surface.metallic == ZERO and surface.transmission == ZERO and surface.alpha == ONE \
        and surface.emission.value[:3] == (0, 0, 0) and surface.coat == ZERO


def _index_of_factor(node, path):
    """The index of refraction of a Mix Shader whose factor is Fresnel's; None: it is another one."""
    output, outer = origin(factor_input(node), path)
    if output is None or output.name not in ("Fac", "Fresnel"):
        return None
    name = {"ShaderNodeFresnel": "IOR", "ShaderNodeLayerWeight": "Blend"}.get(
        output.node.bl_idname)
    if name is None or (name == "Blend" and output.name != "Fresnel"):
        return None
    try:
        source = follow(output.node.inputs[name], outer)
    except Unknown:
        return None
    if not source.is_plain:
        return None
    value = source.value[0]
    return max(value, 1.0) if name == "IOR" else 1 / max(1 - value, 1e-3)


def _coated(first, second, _factor, node, path):
    """A Glossy BSDF that Fresnel's equations put over a diffuse or a refracting shader: one
    material with a reflection of that index; None: it is something else."""
    index = _index_of_factor(node, path)
    if index is None or second.kind != "GLOSSY" or not second.base.is_plain or second.base.loss:
        return None
    losses = first.losses + second.losses
    if first.kind == "REFRACTION":
        first.losses = [loss for loss in losses if loss != first.refraction_loss]
        return first
    if not _is_diffuse(first) or any(first.specular):
        return None
    first.specular, first.ior = second.base.numbers(), index
    first.roughness, first.is_lambert, first.losses = second.roughness, False, losses
    if _BASE_STAYS_WHOLE:
        first.base = scaled(first.base, 1 - mean_fresnel(index))
    return first


def _partly_translucent(first, second, factor, _node, _path):
    """A shader that reflects, mixed with a Translucent BSDF; None: neither is one."""
    if not factor.is_plain or factor.loss:
        return None
    share = factor.value[0]
    front, back = first, second
    if first.diffuse_transmission == 1:
        front, back, share = second, first, 1 - share
    if back.diffuse_transmission != 1 or front.diffuse_transmission > 0 or not _is_diffuse(front):
        return None
    front.diffuse_transmission, front.transmitted = share, back.transmitted
    front.specular = tuple(c * (1 - share) for c in front.specular)
    if front.is_lambert:
        front.is_lambert, front.roughness = False, _ROUGHNESS_OF_LAMBERT
    front.losses += back.losses
    return front
