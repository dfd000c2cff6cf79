# SPDX-License-Identifier: GPL-3.0-or-later
"""Buttons that colour the faces of meshes by their shared photon maps, and remove the colours."""

import math
import os
import subprocess
import tempfile

import bpy
import numpy

from .geometry import MAP_COLOURS
from .glb_file import read_glb
from .properties import programs_folder
from .run import ToolError, find_tool
from .scene_export import SceneWriter

# Numbers of faces, which modifiers hand on to the faces that they make; 0: a face of no mesh.
_NUMBERS = "hipmap face"
_BEFORE = "hipmap_active_colour"  # custom property of a mesh: its active colours before

_FOREIGN_VOTE = 1e-9

_shading_before = {}  # by the pointer of a 3D viewport


class _NumberedWriter(SceneWriter):
    """Exports a scene, and tells which face of which mesh each triangle comes from."""

    def __init__(self, faces_of):
        """faces_of: the numbers of each mesh, a range by its full name."""
        super().__init__(folder="")
        self._faces_of = faces_of
        self._parts = []
        self._numbers_of = {}  # by the mesh's index
        self.numbers = []  # of the triangles in the order of the file
        self.weights = []  # of their votes

    def _write_mesh(self, item):
        self._parts = []
        index = super()._write_mesh(item)
        if index is not None:
            self._numbers_of[index] = numpy.concatenate(self._parts)
        return index

    def _write_part(self, arrays, slot, item):
        mesh = arrays.mesh
        attribute = mesh.attributes.get(_NUMBERS)
        polygons = numpy.empty(len(mesh.loop_triangles), numpy.int32)
        mesh.loop_triangles.foreach_get("polygon_index", polygons)
        polygons = polygons[arrays.slots == slot]
        numbers = numpy.zeros(len(mesh.polygons), numpy.int32)
        if attribute is not None and attribute.domain == "FACE":
            attribute.data.foreach_get("value", numbers)
        self._parts.append(numbers[polygons])
        return super()._write_part(arrays, slot, item)

    def _add_mesh(self, item, instance):
        nodes = self.glb.json.get("nodes", [])
        before = len(nodes)
        super()._add_mesh(item, instance)
        nodes = self.glb.json.get("nodes", [])
        if len(nodes) > before:
            numbers = self._numbers_of[nodes[-1]["mesh"]]
            own = self._faces_of.get(item.original.data.name_full, range(0))
            # A Boolean modifier has faces of its other object too, which count where no other do.
            foreign = (numbers < own.start) | (numbers >= own.stop)
            self.numbers.append(numbers)
            self.weights.append(numpy.where(foreign, _FOREIGN_VOTE, 1.0))


def _meshes(view_layer):
    """The meshes that may be coloured, each once."""
    found = {item.data.name_full: item.data for item in view_layer.objects
             if item.type == "MESH" and item.data.library is None and item.data.polygons}
    return list(found.values())


def _number_faces(meshes):
    """Gives every face a number of its own, from 1 on.  Returns the range of each mesh by its full
    name."""
    _forget_numbers(meshes)  # of an export that was killed
    first, faces_of = 1, {}
    for mesh in meshes:
        faces = range(first, first + len(mesh.polygons))
        mesh.attributes.new(_NUMBERS, "INT", "FACE").data.foreach_set(
            "value", numpy.array(faces, numpy.int32))
        faces_of[mesh.name_full] = faces
        first = faces.stop
    return faces_of


def _forget_numbers(meshes):
    for mesh in meshes:
        attribute = mesh.attributes.get(_NUMBERS)
        if attribute is not None:
            mesh.attributes.remove(attribute)


def _triangle_colours(context, writer):
    """The linear colour [triangles, 3] that `preprocess` gives the map of each triangle."""
    tool = find_tool("preprocess", programs_folder(context))
    angle = f"{round(math.degrees(context.scene.hipmap.angle), 4):g}"
    with tempfile.TemporaryDirectory(prefix="hipmap-", dir=bpy.app.tempdir) as folder:
        scene, partition, coloured = (os.path.join(folder, name)
                                      for name in ("scene.glb", "scene.hpm", "coloured.glb"))
        writer.glb.write(scene)
        done = subprocess.run([tool, scene, "-o", partition, "--coloured", coloured, "--angle",
                               angle], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, text=True, check=False)
        if done.returncode != 0:
            raise ToolError((done.stderr.strip().splitlines() or ["no message"])[-1])
        gltf, buffer = read_glb(coloured)
    view = gltf["bufferViews"][1]  # [3 corners of each triangle, 3]
    return numpy.frombuffer(buffer, numpy.float32, view["byteLength"] // 4,
                            view["byteOffset"]).reshape(-1, 9)[:, :3]


def face_colours(numbers, weights, colours, count):
    """Returns the colour [count + 1, 3] for which the triangles of each face vote; a face without
    triangles is black.  numbers [triangles]: of the faces, 0: none; weights [triangles]: of their
    votes."""
    kinds, kind = numpy.unique(colours, axis=0, return_inverse=True)
    pair, which = numpy.unique(numbers.astype(numpy.int64) * len(kinds) + kind.reshape(-1),
                               return_inverse=True)
    votes = numpy.bincount(which.reshape(-1), weights)
    pair = pair[numpy.argsort(votes, kind="stable")]  # the last one that is written stays
    out = numpy.zeros((count + 1, 3), numpy.float32)
    out[pair // len(kinds)] = kinds[pair % len(kinds)]
    return out


def _colour(mesh, colours):
    """Gives the faces of a mesh colours [faces, 3], linear."""
    _remove(mesh)
    layers = mesh.color_attributes
    active = layers.active_color
    mesh[_BEFORE] = active.name if active else ""
    starts, totals = (numpy.empty(len(mesh.polygons), numpy.int32) for _ in "ab")
    mesh.polygons.foreach_get("loop_start", starts)
    mesh.polygons.foreach_get("loop_total", totals)
    within = numpy.arange(totals.sum()) - numpy.repeat(numpy.cumsum(totals) - totals, totals)
    corners = numpy.ones((len(mesh.loops), 4), numpy.float32)
    corners[numpy.repeat(starts, totals) + within, :3] = numpy.repeat(colours, totals, axis=0)
    layer = layers.new(MAP_COLOURS, "BYTE_COLOR", "CORNER")
    layer.data.foreach_set("color", corners.ravel())
    layers.active_color = layer
    mesh.update()


def _remove(mesh):
    """Takes the colours of a mesh away.  Returns whether it had some."""
    layer = mesh.color_attributes.get(MAP_COLOURS)
    if layer is None:
        return False
    mesh.color_attributes.remove(layer)
    before = mesh.color_attributes.get(mesh.get(_BEFORE, ""))
    if before is not None:
        mesh.color_attributes.active_color = before
    if _BEFORE in mesh:
        del mesh[_BEFORE]
    mesh.update()
    return True


def _export(context, meshes):
    """Exports what the view layer shows.  Returns the writer, and the numbers of each mesh."""
    faces_of = _number_faces(meshes)
    try:
        context.view_layer.update()
        writer = _NumberedWriter(faces_of)
        for instance in context.evaluated_depsgraph_get().object_instances:
            if instance.show_self and instance.object.type != "LIGHT":
                writer.add(instance)
    finally:
        _forget_numbers(meshes)
    return writer, faces_of


def colour_maps(context):
    """Colours all meshes of the view layer.  Returns their number.  Throws ToolError."""
    meshes = _meshes(context.view_layer)
    writer, faces_of = _export(context, meshes)
    if not writer.numbers:
        raise ToolError("no mesh is visible: show one")
    numbers, weights = numpy.concatenate(writer.numbers), numpy.concatenate(writer.weights)
    triangles = _triangle_colours(context, writer)
    if len(triangles) != len(numbers):
        raise ToolError(f"hipmap found {len(triangles)} triangles of {len(numbers)}")
    colours = face_colours(numbers, weights, triangles, sum(map(len, faces_of.values())))
    for mesh in meshes:
        faces = faces_of[mesh.name_full]
        _colour(mesh, colours[faces.start:faces.stop])
    return len(meshes)


def _viewports(context):
    if context.screen is not None:
        for area in context.screen.areas:
            if area.type == "VIEW_3D":
                yield area.spaces[0]


def _show_colours(context):
    for space in _viewports(context):
        shading = space.shading
        _shading_before.setdefault(space.as_pointer(), (shading.type, shading.color_type))
        shading.type, shading.color_type = "SOLID", "VERTEX"


def _show_as_before(context):
    for space in _viewports(context):
        before = _shading_before.pop(space.as_pointer(), None)
        if before is not None:
            space.shading.type, space.shading.color_type = before


class _OverlayOperator:
    """What both operators need."""

    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        """Meshes in Edit Mode take no attributes."""
        return (context.mode == "OBJECT" and
                "color_attributes" in bpy.types.Mesh.bl_rna.properties)


class OBJECT_OT_hipmap_show_maps(_OverlayOperator, bpy.types.Operator):
    """Colours meshes by their shared maps."""

    bl_idname = "object.hipmap_show_maps"
    bl_label = "Show Photon Maps"
    bl_description = ("Give all meshes a color attribute with the colors of their shared photon maps, "
                      "and show it in the viewports. Faces of one color share photons")

    def execute(self, context):
        """Adds the colours."""
        try:
            meshes = colour_maps(context)
        except ToolError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        _show_colours(context)
        self.report({"INFO"}, f"colored {meshes} meshes")
        return {"FINISHED"}


class OBJECT_OT_hipmap_remove_maps(_OverlayOperator, bpy.types.Operator):
    """Removes the colours."""

    bl_idname = "object.hipmap_remove_maps"
    bl_label = "Remove Photon Map Colors"
    bl_description = "Remove the color attributes of shared photon maps from all meshes"

    def execute(self, context):
        """Removes the colours."""
        removed = sum([_remove(mesh) for mesh in bpy.data.meshes if mesh.library is None])
        _show_as_before(context)
        self.report({"INFO"}, f"removed the colors of {removed} meshes")
        return {"FINISHED"}


_CLASSES = (OBJECT_OT_hipmap_show_maps, OBJECT_OT_hipmap_remove_maps)


def register():
    """Adds the operators."""
    for operator in _CLASSES:
        bpy.utils.register_class(operator)


def unregister():
    """Removes the operators."""
    for operator in reversed(_CLASSES):
        bpy.utils.unregister_class(operator)
