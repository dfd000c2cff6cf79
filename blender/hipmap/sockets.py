# SPDX-License-Identifier: GPL-3.0-or-later
"""What arrives at an input of a shader node: a number, a colour, an image or a colour layer."""

from dataclasses import dataclass, field, replace

import bpy
import numpy
from mathutils import Euler

from .adjust import adjustment, arithmetic, blackbody, is_adjustment
from .losses import label


@dataclass(frozen=True)
class Texture:
    """An image on a surface."""

    image: bpy.types.Image  # or a BakedImage
    channel: str = "COLOR"  # or R, G, B, A
    uv_name: str = None  # None: the UV map that renders use
    transform: tuple = None  # offset u, v; rotation; scale u, v: of a Mapping node
    wrap: str = "REPEAT"
    nearest: bool = False
    changes: tuple = ()  # functions of linear colours [n, 3], applied to every pixel in order


@dataclass(frozen=True)
class Place:
    """An input of a shader node, by names that another Blender finds it by."""

    groups: tuple  # names of the group nodes around the node
    node: str
    socket: str  # its identifier
    factor: float = 1.0  # of what arrives there


@dataclass(frozen=True)
class Source:
    """A value times a texture or a colour layer, where there is one."""

    value: tuple  # four numbers of a colour, one of a number
    texture: Texture = None
    colour_layer: str = None
    place: Place = field(default=None, compare=False)  # where it was read
    loss: str = field(default=None, compare=False)  # why it is not what Blender renders

    @property
    def is_plain(self):
        """Whether the value is all there is."""
        return self.texture is None and self.colour_layer is None

    def numbers(self):
        """The red, green and blue of a plain value."""
        return self.value[:3] if len(self.value) > 1 else self.value * 3


class Unknown(Exception):
    """A node that cannot be followed.  Its text names it."""


_WHITE = (1.0, 1.0, 1.0, 1.0)
_EXTENSIONS = {"REPEAT": "REPEAT", "EXTEND": "EXTEND", "MIRROR": "MIRROR"}


def _plain(socket):
    value = socket.default_value
    return Source(tuple(value) if hasattr(value, "__len__") else (float(value),))


def _uv_of(node, path):
    """The UV map and the transform of a texture node's vector."""
    vector, path = origin(node.inputs["Vector"], path)
    if vector is None:
        return None, None
    if vector.node.bl_idname == "ShaderNodeMapping":
        name, _ = _uv_of(vector.node, path)
        return name, _transform(vector.node)
    if vector.node.bl_idname == "ShaderNodeUVMap":
        return vector.node.uv_map or None, None
    if vector.node.bl_idname == "ShaderNodeTexCoord" and vector.name == "UV":
        return None, None
    raise Unknown(f"{label(vector.node)} (output {vector.name}) as the place of {label(node)}")


def _transform(node):
    """glTF turns and offsets textures with v downwards."""
    if node.vector_type != "POINT" or any(
            node.inputs[name].is_linked for name in ("Location", "Rotation", "Scale")):
        raise Unknown(label(node))
    rotation = Euler(node.inputs["Rotation"].default_value)
    if abs(rotation.x) > 1e-6 or abs(rotation.y) > 1e-6:
        raise Unknown(f"{label(node)} that turns about x or y")
    location, scale = node.inputs["Location"].default_value, node.inputs["Scale"].default_value
    return (location[0], location[1], rotation.z, scale[0], scale[1])


def _image(node, output, path):
    if node.image is None:
        raise Unknown(f"{label(node)} without an image")
    if node.image.source not in {"FILE", "GENERATED"} or node.projection != "FLAT":
        raise Unknown(f"{label(node)} that is no plain image")
    if node.extension not in _EXTENSIONS:
        raise Unknown(f"{label(node)} with the extension {node.extension.title()}")
    name, transform = _uv_of(node, path)
    is_alpha = output.name == "Alpha"
    texture = Texture(node.image, "A" if is_alpha else "COLOR", name, transform,
                      _EXTENSIONS[node.extension], node.interpolation == "Closest")
    return Source((1.0,) if is_alpha else _WHITE, texture)


def _times(a, b, node):
    if not a.is_plain and not b.is_plain:
        raise Unknown(f"{label(node)} of two textures")
    bearer, other = (b, a) if a.is_plain else (a, b)
    values = (other.value * 4)[:len(bearer.value)] if len(other.value) == 1 else other.value
    if len(bearer.value) == 1:
        values = values[:1]
    return replace(bearer, value=tuple(x * y for x, y in zip(bearer.value, values)))


def _mix_inputs(node):
    """Factor and both colours of a mix, of either of Blender's two nodes for it."""
    if node.bl_idname == "ShaderNodeMixRGB":
        return node.inputs["Fac"], node.inputs["Color1"], node.inputs["Color2"]
    if node.data_type != "RGBA":
        raise Unknown(label(node))
    colours = [socket for socket in node.inputs if socket.type == "RGBA"]
    return node.inputs[0], *colours


def _mix(node, path):
    factor, first, second = (follow(socket, path) for socket in _mix_inputs(node))
    if not factor.is_plain:
        raise Unknown(f"{label(node)} with a texture as its factor")
    t = factor.value[0]
    if node.blend_type == "MULTIPLY" and second.is_plain:
        tint = tuple(1 - t + t * c for c in second.value[:3]) + (1.0,)
        return _times(first, Source(tint), node)
    if node.blend_type == "MULTIPLY" and t == 1:
        return _times(first, second, node)
    if node.blend_type == "MIX" and t in (0, 1):
        return second if t == 1 else first
    if node.blend_type == "MIX" and second.is_plain:
        end = numpy.array(second.numbers())
        return _changed(first, lambda c: c + t * (end - c), node)
    if node.blend_type == "MIX" and first.is_plain:
        begin = numpy.array(first.numbers())
        return _changed(second, lambda c: begin + t * (c - begin), node)
    raise Unknown(label(node))


def _math(node, path):
    first, second = follow(node.inputs[0], path), follow(node.inputs[1], path)
    if node.operation == "MULTIPLY" and not node.use_clamp:
        return _times(first, second, node)
    change = arithmetic(node.operation, node.use_clamp, second.value[0])
    if change is None or not second.is_plain:
        raise Unknown(label(node))
    changed = _changed(first, change, node)
    return changed if changed.texture else Source(changed.value[:1])


_CHANNELS = "RGBA"


def _picked(channel):
    """Each pixel's channel as a grey colour."""
    at = _CHANNELS.index(channel)
    return lambda colours: numpy.repeat(colours[:, at:at + 1], 3, axis=1)


def _changed(source, change, node):
    """A source after a function of its colours."""
    if source.is_plain:
        colours = numpy.array([source.numbers()], float)
        return Source((*map(float, change(colours)[0]), 1.0))
    texture = source.texture
    if texture is None or texture.channel == "A":
        raise Unknown(label(node))
    changes = texture.changes
    if texture.channel != "COLOR":
        changes = (*changes, _picked(texture.channel))
    if any(c != 1 for c in source.value[:3]):
        factor = numpy.array(source.numbers())
        changes = (*changes, lambda colours: colours * factor)
    return Source(_WHITE, replace(texture, channel="COLOR", changes=(*changes, change)))


def _adjusted(node, path):
    def value(name):
        source = follow(node.inputs[name], path)
        if not source.is_plain:
            raise Unknown(f"{label(node)} with an image at {name}")
        return source.value[0]

    name, change = adjustment(node, value)
    return _changed(follow(node.inputs[name], path), change, node)


def _blackbody(node, path):
    temperature = follow(node.inputs["Temperature"], path)
    if not temperature.is_plain:
        raise Unknown(label(node))
    return Source((*blackbody(temperature.value[0]), 1.0))


def _separate(node, output, path):
    if getattr(node, "mode", "RGB") != "RGB":
        raise Unknown(label(node))
    source = follow(node.inputs[0], path)
    channel = {"R": 0, "Red": 0, "G": 1, "Green": 1, "B": 2, "Blue": 2}[output.name]
    if source.colour_layer is not None:
        raise Unknown(f"{label(node)} of a colour layer")
    if source.texture is None:
        return Source((source.numbers()[channel],))
    return Source((source.value[channel],), replace(source.texture, channel="RGB"[channel]))


def _layer(node, _output, _path):
    name = getattr(node, "layer_name", None) or getattr(node, "attribute_name", "")
    return Source(_WHITE, None, name)


def origin(socket, path):
    """Returns the output that a socket's link comes from, through reroutes and groups, and the
    groups around it; None: nothing is linked.  path: the group nodes around the socket."""
    while socket.is_linked:
        output = socket.links[0].from_socket
        node = output.node
        if node.bl_idname == "NodeReroute":
            socket = node.inputs[0]
        elif node.mute and _passed_through(output) is not None:
            socket = _passed_through(output)
        elif node.bl_idname == "ShaderNodeGroup" and node.node_tree:
            inner = next((x for x in node.node_tree.nodes if x.bl_idname == "NodeGroupOutput"
                          and x.is_active_output), None)
            if inner is None:
                return None, path
            socket = next(x for x in inner.inputs if x.identifier == output.identifier)
            path = (*path, node)
        elif node.bl_idname == "NodeGroupInput" and path:
            socket = next(x for x in path[-1].inputs if x.identifier == output.identifier)
            path = path[:-1]
        else:
            return output, path
    return None, path


def _passed_through(output):
    """The input that a muted node hands on to an output; None: there is none."""
    return next((link.from_socket for link in output.node.internal_links
                 if link.to_socket == output), None)


def _end(socket, path):
    """The unlinked socket whose value a socket has."""
    while socket.is_linked:
        node = socket.links[0].from_node
        output = socket.links[0].from_socket
        if node.bl_idname == "NodeReroute":
            socket = node.inputs[0]
        elif node.mute and _passed_through(output) is not None:
            socket = _passed_through(output)
        elif node.bl_idname == "NodeGroupInput":
            socket = next(x for x in path[-1].inputs if x.identifier == output.identifier)
            path = path[:-1]
        else:
            inner = next(x for x in node.node_tree.nodes if x.bl_idname == "NodeGroupOutput")
            socket = next(x for x in inner.inputs if x.identifier == output.identifier)
            path = (*path, node)
    return socket


_FOLLOWED = {
    "ShaderNodeTexImage": _image,
    "ShaderNodeMixRGB": lambda node, _, path: _mix(node, path),
    "ShaderNodeMix": lambda node, _, path: _mix(node, path),
    "ShaderNodeMath": lambda node, _, path: _math(node, path),
    "ShaderNodeBlackbody": lambda node, _, path: _blackbody(node, path),
    "ShaderNodeSeparateColor": _separate,
    "ShaderNodeSeparateRGB": _separate,
    "ShaderNodeVertexColor": _layer,
    "ShaderNodeRGB": lambda node, output, _: _plain(output),
    "ShaderNodeValue": lambda node, output, _: _plain(output),
}


def follow(socket, path=()):
    """Returns the Source of a socket.  Throws Unknown, naming the node that glTF lacks."""
    output, outer = origin(socket, path)
    if output is None:
        return _plain(_end(socket, path))
    node = output.node
    if node.mute:
        raise Unknown(f"{label(node)} that is muted")
    if is_adjustment(node):
        return _adjusted(node, outer)
    if node.bl_idname not in _FOLLOWED:
        raise Unknown(label(node))
    return _FOLLOWED[node.bl_idname](node, output, outer)
