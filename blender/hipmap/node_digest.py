# SPDX-License-Identifier: GPL-3.0-or-later
"""A hash of everything in a node tree that changes a picture."""

import hashlib
import os

import bpy

# Where a node stands and whether it is selected changes no picture.
_OF_THE_EDITOR = ("location", "select", "show_", "hide", "width", "height", "bl_")


def all_nodes(tree):
    """Yields the nodes of a tree, and those of the groups in it."""
    for node in tree.nodes:
        yield node
        if node.bl_idname == "ShaderNodeGroup" and node.node_tree:
            yield from all_nodes(node.node_tree)


def _values(thing):
    """The plain values of a node or socket."""
    for prop in thing.bl_rna.properties:
        if prop.type in {"BOOLEAN", "INT", "FLOAT", "STRING", "ENUM"}:
            value = getattr(thing, prop.identifier)
            yield prop.identifier, tuple(value) if hasattr(value, "__len__") else value


def _image_values(image):
    path = bpy.path.abspath(image.filepath)
    changed = os.path.getmtime(path) if os.path.isfile(path) else 0
    return path, changed, image.colorspace_settings.name, tuple(image.size), image.is_dirty


def _node_values(node):
    yield (node.bl_idname, node.mute, sorted(pair for pair in _values(node)
                                             if not pair[0].startswith(_OF_THE_EDITOR)))
    yield from (tuple(_values(socket)) for socket in node.inputs)
    if node.bl_idname in {"ShaderNodeRGB", "ShaderNodeValue"}:  # their value is at the output
        yield from (tuple(_values(socket)) for socket in node.outputs)
    if getattr(node, "image", None):
        yield _image_values(node.image)
    if hasattr(node, "color_ramp"):
        yield from ((stop.position, tuple(stop.color)) for stop in node.color_ramp.elements)
    if hasattr(node, "mapping") and hasattr(node.mapping, "curves"):
        yield from (tuple(point.location) for curve in node.mapping.curves
                    for point in curve.points)
    if getattr(node, "node_tree", None):
        yield from _link_values(node.node_tree)


def _link_values(tree):
    return [(link.from_node.name, link.from_socket.identifier, link.to_node.name,
             link.to_socket.identifier) for link in tree.links]


def tree_digest(tree):
    """Returns the hash of a node tree as text."""
    found = [value for node in all_nodes(tree) for value in _node_values(node)]
    return hashlib.sha256(repr(found + _link_values(tree)).encode()).hexdigest()[:16]
