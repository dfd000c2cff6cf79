# SPDX-License-Identifier: GPL-3.0-or-later
"""The world: a plain colour, or an environment map that Cycles renders of its nodes."""

import os
from dataclasses import dataclass

import bpy

from .losses import label
from .node_digest import all_nodes, tree_digest
from .run import Child, ToolError, wait_for
from .volumes import medium_of

_BAKE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "bake_world.py")
_DEFAULT_WIDTH = 2048
_GREATEST_WIDTH = 4096
_SECONDS_TO_BAKE = 120
_PART = ".part.exr"  # of the name of a map under way


class WorldError(RuntimeError):
    """The environment map could not be made.  Its text is one line for the user."""


def _output(world):
    if world is None or not world.use_nodes:
        return None
    return next((node for node in world.node_tree.nodes
                 if node.bl_idname == "ShaderNodeOutputWorld" and node.is_active_output), None)


def _surface_node(world):
    output = _output(world)
    if output is None or not output.inputs["Surface"].is_linked:
        return None
    return output.inputs["Surface"].links[0].from_node


def _plain_colour(world):
    """The radiance of a world of one colour; None: its nodes must be rendered."""
    if world is None:
        return (0.0, 0.0, 0.0)
    if not world.use_nodes:
        return tuple(world.color)
    node = _surface_node(world)
    if node is None:
        return (0.0, 0.0, 0.0)
    if node.bl_idname != "ShaderNodeBackground" or any(s.is_linked for s in node.inputs):
        return None
    strength = node.inputs["Strength"].default_value
    return tuple(c * strength for c in node.inputs["Color"].default_value[:3])


def _map_width(world):
    """As wide as the widest image of the world, so that no detail of it is lost."""
    widths = [node.image.size[0] for node in all_nodes(world.node_tree)
              if node.bl_idname == "ShaderNodeTexEnvironment" and node.image]
    return min(max(widths, default=_DEFAULT_WIDTH), _GREATEST_WIDTH) or _DEFAULT_WIDTH


@dataclass(frozen=True)
class Bake:
    """An environment map to be made by a Blender of its own: a render cannot start another one in
    the same program."""

    world: str
    command: list
    blend: str  # holds the world; to be removed afterwards
    path: str

    def failed(self, why):
        """Returns the WorldError of a map that could not be made."""
        return WorldError(f"world '{self.world}': Blender could not render it to an environment "
                          f"map: {why}")


def prepare_bake(world, path):
    """Writes the world to a file, where Blender's data may be read.  Returns the Bake."""
    blend = path + ".blend"
    bpy.data.libraries.write(blend, {world}, path_remap="ABSOLUTE")
    command = [bpy.app.binary_path, "--background", "--factory-startup", "--python-exit-code", "1",
               "--python", _BAKE, "--", blend, path, str(_map_width(world))]
    return Bake(world.name, command, blend, path)


def bake_at_once(world, path, is_cancelled=lambda: False):
    """Makes the environment map of a world, and waits for it.  is_cancelled: called meanwhile.
    Throws WorldError or Cancelled."""
    bake = prepare_bake(world, path)
    try:
        child = Child(bake.command)
        code = wait_for(child, is_cancelled, _SECONDS_TO_BAKE)
    except ToolError as error:
        raise bake.failed(error) from error
    finally:
        for left in filter(os.path.exists, (bake.blend, path + _PART)):
            os.remove(left)
    if code != 0 or not os.path.isfile(path):
        raise bake.failed(child.last_error())


def _medium(world):
    """The medium around everything, None without one, and what is lost of it."""
    output = _output(world)
    return (None, []) if output is None else medium_of(output.inputs["Volume"])


def world_extras(world, folder, bake=bake_at_once):
    """Returns the custom property `hipmap` of a scene for its world (None: black).  Writes an
    environment map into `folder`, where the .glb is, if the world has more than one colour; a map
    that is there already is used again.  Throws WorldError."""
    colour = _plain_colour(world)
    if colour is not None:
        extras = {"world_color": [max(c, 0.0) for c in colour], "world_strength": 1.0}
    else:
        name = f"world_{tree_digest(world.node_tree)}.exr"
        path = os.path.join(folder, name)
        if not os.path.isfile(path):
            bake(world.original, path)
        extras = {"world_hdri": name, "world_strength": 1.0}
    medium, _ = _medium(world)
    return {**extras, "medium": medium} if medium else extras


def world_losses(world):
    """Yields what hipmap does not render of a world, one line each."""
    if world is None or not world.use_nodes:
        return
    for node in all_nodes(world.node_tree):
        if node.bl_idname == "ShaderNodeLightPath":
            yield (f"world '{world.name}': node {label(node)}: the camera and reflections see the "
                   "same world")
    for loss in _medium(world)[1]:
        yield f"world '{world.name}': {loss}"
