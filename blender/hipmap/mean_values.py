# SPDX-License-Identifier: GPL-3.0-or-later
"""What nodes that hipmap cannot follow give on average over a surface."""

import numpy

from .adjust import adjustment, arithmetic, grey, is_adjustment
from .sockets import Unknown, follow, origin

# Means of Blender's textures with their default inputs.
_TEXTURES = {"ShaderNodeTex" + kind: value for kind, value in {
    "Noise": 0.5, "Musgrave": 0.1, "Voronoi": 0.5, "Wave": 0.5, "Magic": 0.5, "Gradient": 0.5,
    "WhiteNoise": 0.5}.items()}
_MORTAR = 0.25  # the share of the surface between bricks

# Values of a texture lie mostly here, so a ramp shows this part of its colours.
_PART_OF_RAMP = numpy.linspace(0.25, 0.75, 64)


class NoMean(Exception):
    """A node of which nothing is known."""


def mean_of(socket, path=()):
    """Returns the mean of what arrives at an input, three numbers; None: nothing is known of it."""
    try:
        return tuple(float(c) for c in _mean(socket, path))
    except (NoMean, Unknown):
        return None


def luminance(colour):
    """Returns what a number's input makes of a colour."""
    return float(grey(numpy.array([colour]))[0, 0])


def mean_fresnel(index):
    """Returns the mean reflectance of a dielectric under even light, by its index of refraction."""
    n = max(index, 1e-5)
    cosine = (numpy.arange(256) + 0.5) / 256
    root = numpy.sqrt(numpy.maximum(n * n - 1 + cosine * cosine, 0))
    across = (cosine - root) / (cosine + root)
    along = (n * n * cosine - root) / (n * n * cosine + root)
    return float(((across ** 2 + along ** 2) * cosine).sum() / cosine.sum() / 2)


def _mean(socket, path):
    try:
        source = follow(socket, path)
    except Unknown:
        source = None
    if source is not None:
        if not source.is_plain:
            raise NoMean
        return numpy.array(source.numbers())
    output, outer = origin(socket, path)
    return _mean_of_node(output.node, output, outer)


def _mean_of_node(node, output, path):
    if node.mute:
        raise NoMean
    if node.bl_idname in _TEXTURES:
        return numpy.full(3, _TEXTURES[node.bl_idname])
    if is_adjustment(node):
        return _adjusted(node, path)
    if node.bl_idname not in _NODES:
        raise NoMean
    return _NODES[node.bl_idname](node, output, path)


def _adjusted(node, path):
    name, change = adjustment(node, lambda other: _mean(node.inputs[other], path)[0])
    if node.bl_idname == "ShaderNodeValToRGB":
        return change(_PART_OF_RAMP[:, None].repeat(3, axis=1)).mean(axis=0)
    return change(_mean(node.inputs[name], path)[None])[0]


def _checker(node, output, path):
    if output.name == "Fac":
        return numpy.full(3, 0.5)
    return (_mean(node.inputs["Color1"], path) + _mean(node.inputs["Color2"], path)) / 2


def _bricks(node, output, path):
    if output.name == "Fac":
        return numpy.full(3, _MORTAR)
    bricks = (_mean(node.inputs["Color1"], path) + _mean(node.inputs["Color2"], path)) / 2
    return bricks + _MORTAR * (_mean(node.inputs["Mortar"], path) - bricks)


def _mix(node, output, path):
    if node.bl_idname == "ShaderNodeMix" and node.data_type != "RGBA":
        raise NoMean
    first, second = (_mean(socket, path) for socket in
                     [x for x in node.inputs if x.type == "RGBA"][:2])
    factor = min(max(_mean(node.inputs[0], path)[0], 0), 1)
    blended = {"MIX": second, "MULTIPLY": first * second, "ADD": first + second}
    return first + factor * (blended.get(node.blend_type, first) - first)


def _math(node, output, path):
    second = _mean(node.inputs[1], path)[0]
    change = arithmetic(node.operation, node.use_clamp, second)
    if change is None:
        raise NoMean
    return change(_mean(node.inputs[0], path)[None])[0]


def _layer_weight(node, output, path):
    blend = min(max(_mean(node.inputs["Blend"], path)[0], 0), 1 - 1e-5)
    if output.name == "Fresnel":
        return numpy.full(3, mean_fresnel(1 / (1 - blend)))
    exponent = 2 * blend if blend < 0.5 else 0.5 / (1 - blend)
    return numpy.full(3, 1 - 2 / (2 + exponent))


def _fresnel(node, output, path):
    return numpy.full(3, mean_fresnel(_mean(node.inputs["IOR"], path)[0]))


_NODES = {
    "ShaderNodeTexChecker": _checker, "ShaderNodeTexBrick": _bricks,
    "ShaderNodeMixRGB": _mix, "ShaderNodeMix": _mix, "ShaderNodeMath": _math,
    "ShaderNodeLayerWeight": _layer_weight, "ShaderNodeFresnel": _fresnel,
    "ShaderNodeLightPath": lambda node, output, _: numpy.full(3, output.name == "Is Camera Ray"),
    "ShaderNodeAmbientOcclusion": lambda node, _, path: _mean(node.inputs["Color"], path),
    "ShaderNodeRGBCurve": lambda node, _, path: _mean(node.inputs["Color"], path),
    "ShaderNodeObjectInfo": lambda node, output, _: _random(output),
    "ShaderNodeParticleInfo": lambda node, output, _: _random(output),
}


def _random(output):
    if output.name != "Random":
        raise NoMean
    return numpy.full(3, 0.5)
