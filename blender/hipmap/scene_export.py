# SPDX-License-Identifier: GPL-3.0-or-later
"""The evaluated scene as a .glb: what a render of Blender shows, with modifiers and instances."""

import functools
import hashlib
import os
from dataclasses import dataclass, field

import bpy

from .bakes import NodeBaker
from .cameras import camera_extras, camera_losses, gltf_camera, shift_extras
from .geometry import MeshArrays, in_gltf_axes
from .glb_file import GlbBuilder
from .lights import is_portal, light_extras, light_losses, punctual_light
from .losses import mesh_losses, type_losses, without_repeats
from .materials import MaterialWriter
from .motion import MotionWriter, Shutter, collect_motion, instance_key, motion_losses
from .properties import find_program
from .volume_objects import NotRendered, remove_other_volumes, write_volume
from .world import bake_at_once, world_extras, world_losses

# From 3.0 on the mesh of a curve or a text is an instance of its own.
_WITH_MESH = ({"MESH", "META"} if bpy.app.version >= (3, 0, 0) else
              {"MESH", "CURVE", "SURFACE", "FONT", "META"})


class SceneError(RuntimeError):
    """The scene cannot be rendered.  Its text is one line for the user."""


@dataclass
class ExportedScene:
    """A .glb that was written."""

    path: str
    geometry: str  # a hash of all faces: equal ones have the same partition
    triangles: int
    moves: bool = False  # whether the file has an animation, of the time that the shutter is open
    numbers: dict = field(default_factory=dict)  # pass indices of its objects and materials, by pass
    losses: list = field(default_factory=list)


def generator():
    """Returns the asset's generator.  Materials have the terms of Blender's own exporter, so the
    file names it first: hipmap then takes the reflection models of that Blender."""
    version = ".".join(map(str, bpy.app.version))
    return f"Khronos glTF Blender I/O v{version} (its terms; written by hipmap for Blender)"


def matrix_numbers(to_world):
    """Returns the matrix of a glTF node, 16 numbers column by column, for one of Blender."""
    return [x for column in in_gltf_axes(to_world).transposed() for x in column]


class SceneWriter:
    """One export under way."""

    def __init__(self, folder, motion=None):
        """folder: of the files beside the .glb; motion: a MotionWriter that follows everything,
        None: nothing moves."""
        self.folder = folder
        self.glb = GlbBuilder(generator())
        self.motion = motion
        self.materials = MaterialWriter(self.glb)
        self.losses = []
        self.is_cancelled = lambda: False  # called while another Blender bakes the world
        self.bakes = {}  # BakedMeshes by the keys of meshes
        self.meshes = {}  # key -> index, or None for a mesh without faces
        self.hash = hashlib.sha256()
        self.triangles_of = {}
        self.triangles = 0
        self.object_numbers = []

    def add(self, instance):
        """Adds one instance of the evaluated scene."""
        item = instance.object
        if item.type == "LIGHT":
            self._add_light(item, instance)
        elif item.type in _WITH_MESH:
            self._add_mesh(item, instance)
        elif item.type == "VOLUME":
            self._add_volume(item, instance)
        else:
            self.losses += type_losses(item)

    def _add_mesh(self, item, instance):
        key = _mesh_key(item)
        if key not in self.meshes:
            self.meshes[key] = self._write_mesh(item)
            self.losses += mesh_losses(item)
        mesh = self.meshes[key]
        if mesh is None:
            return
        matrix = matrix_numbers(instance.matrix_world)
        self.triangles += self.triangles_of[mesh]
        self.object_numbers.append(item.pass_index)
        self.hash.update(repr((mesh, matrix)).encode())
        node = self.glb.add_root({"name": item.name, "mesh": mesh, "matrix": matrix})
        if self.motion:
            self.motion.follow(instance_key(instance), item, instance.matrix_world, node, mesh)

    def _add_volume(self, item, instance):
        material = item.active_material
        try:
            volume = write_volume(self.glb, item, instance.matrix_world, self.folder, find_program)
        except NotRendered as why:
            self.losses.append(f"object '{item.name}': the volume is not rendered: {why}")
            return
        self.losses += [f"object '{item.name}': {loss}" for loss in volume.losses]
        self.materials.numbers.append(material.pass_index if material else 0)
        self.object_numbers.append(item.pass_index)
        numbers = [x for column in volume.matrix.transposed() for x in column]
        self.triangles += 12
        self.hash.update(volume.geometry + repr(numbers).encode())
        self.glb.add_root({"name": item.name, "mesh": volume.mesh, "matrix": numbers})

    def _write_mesh(self, item):
        mesh = item.to_mesh()
        if mesh is None:
            return None
        try:
            arrays = MeshArrays(mesh, self.bakes.get(_mesh_key(item)))
            written = [self._write_part(arrays, slot, item) for slot in arrays.used_slots()]
        finally:
            item.to_mesh_clear()
        if not written:
            return None
        entry = {"name": item.data.name, "primitives": [primitive for primitive, _ in written]}
        index = self.glb.add("meshes", entry)
        if self.motion:
            self.motion.follow_shape(index, item, entry, arrays.counts,
                                     [part for _, part in written])
        self.triangles_of[index] = len(arrays.corners)
        return index

    def _write_part(self, arrays, slot, item):
        """The primitive of a material slot, and its Part."""
        material = self.materials.write(_material(item, arrays.mesh, slot), arrays.baked)
        part = arrays.part(slot, material.uv_names, material.colour_layer)
        self.hash.update(part.positions.tobytes())
        self.hash.update(part.indices.tobytes())
        self.hash.update(part.normals.tobytes())
        attributes = {"POSITION": self.glb.add_array(part.positions, bounds=True),
                      "NORMAL": self.glb.add_array(part.normals)}
        for index, uv in enumerate(part.uvs):
            attributes[f"TEXCOORD_{index}"] = self.glb.add_array(uv)
        if len(part.uvs) < len(material.uv_names):
            missing = material.uv_names[len(part.uvs)] or "UVMap"
            self.losses.append(f"object '{item.name}': it lacks the UV map '{missing}' of its "
                               "material")
        if part.colours is not None:
            attributes["COLOR_0"] = self.glb.add_array(part.colours)
        return {"attributes": attributes, "indices": self.glb.add_array(part.indices),
                "material": material.index}, part

    def _add_light(self, item, instance):
        light = item.data
        if is_portal(light):
            return
        entry = punctual_light(light)
        node = {"name": item.name, "matrix": matrix_numbers(instance.matrix_world),
                "extras": {"hipmap": light_extras(light, self.folder)}}
        if entry is not None:
            self.glb.use_extension("KHR_lights_punctual")
            lights = self.glb.json.setdefault("extensions", {}).setdefault(
                "KHR_lights_punctual", {"lights": []})["lights"]
            lights.append(entry)
            node["extensions"] = {"KHR_lights_punctual": {"light": len(lights) - 1}}
        index = self.glb.add_root(node)
        if self.motion:
            self.motion.follow(instance_key(instance), item, instance.matrix_world, index)
        self.losses += light_losses(light)
        if getattr(item, "visible_camera", False):
            self.losses.append(f"light '{item.name}': the camera does not see it, although its ray "
                               "visibility says so")

    def add_camera(self, item, picture):
        """Adds the scene's camera for a Picture.  Throws SceneError if hipmap has no such camera."""
        entry = gltf_camera(item.data, picture)
        if entry is None:
            raise SceneError(f"camera '{item.name}': hipmap renders no panoramic cameras; set its "
                             "type to Perspective or Orthographic")
        extras = {**camera_extras(item, item.matrix_world), **shift_extras(item.data, picture)}
        node = self.glb.add_root({
            "name": item.name, "camera": self.glb.add("cameras", entry),
            "matrix": matrix_numbers(item.matrix_world), "extras": {"hipmap": extras}})
        if self.motion:
            self.motion.follow(None, item, item.matrix_world, node)
        self.losses += camera_losses(item)

    def add_world(self, world, bake=None):
        """Adds the world and its medium.  bake: as in world_extras; None: bakes at once."""
        at_once = functools.partial(bake_at_once, is_cancelled=self.is_cancelled)
        extras = world_extras(world, self.folder, bake or at_once)
        self.losses += world_losses(world)
        self.glb.json["scenes"][0]["extras"] = {"hipmap": extras}


def _scene_losses(scene, picture):
    if scene.render.film_transparent:
        yield "a transparent film is not rendered: the world is behind everything"
    if picture.pixel_aspect != 1:
        yield "pixels are square: the aspect of pixels is not rendered"


def _materials(item, mesh):
    slots = [slot.material for slot in item.material_slots]
    return slots or list(mesh.materials)


def _material(item, mesh, slot):
    materials = _materials(item, mesh)
    if not materials:
        return None
    return materials[min(slot, len(materials) - 1)]  # as Blender takes a slot that is not there


def _mesh_key(item):
    """Equal for objects that have the same triangles and materials."""
    owner = item.data if item.type == "MESH" else item.original
    materials = tuple(m.name_full if m else None for m in _materials(item, item.data))
    return owner.as_pointer(), materials


def _baked_meshes(depsgraph, folder, engine):
    """BakedMeshes by the keys of meshes: of all materials with nodes that glTF lacks."""
    settings = depsgraph.scene.hipmap
    if not settings.bake:
        return {}
    baker = NodeBaker(folder, int(settings.bake_size), engine.test_break)
    for instance in depsgraph.object_instances:
        item = instance.object
        if instance.show_self and item.type in _WITH_MESH:
            baker.add(_mesh_key(item), item, _materials(item, item.data))
    return baker.finish()


def export_depsgraph(depsgraph, path, picture, engine=None):
    """Writes the evaluated scene to a .glb, and beside it an environment map if the world has
    nodes, and photometric files of lights.  Returns the ExportedScene.  picture: what the camera
    shows.  engine: the RenderEngine whose depsgraph it is, which is evaluated at other frames; with
    it the file holds what moves while the shutter is open, and baked nodes, as the scene's settings
    say.  Throws SceneError, WorldError, ToolError or Cancelled.  Cost: linear in the triangles of
    distinct meshes, 1 s for a million; with motion blur also six times what Blender takes for a
    frame, and what baking takes."""
    scene = depsgraph.scene
    if scene.camera is None:
        raise SceneError("the scene has no camera: add one, and make it the active camera")
    folder = os.path.dirname(path)
    if engine is None or not scene.render.use_motion_blur:
        writer = SceneWriter(folder)
        if engine is not None:
            writer.is_cancelled = engine.test_break
            writer.bakes = _baked_meshes(depsgraph, folder, engine)
        return _export(depsgraph, path, picture, writer, lambda writer: None)
    shutter = Shutter(scene, engine.frame_set)
    camera = scene.camera.original
    motion = MotionWriter(scene.original)

    def add_motion(writer):
        collect_motion(shutter, depsgraph, motion, camera)
        writer.losses += [*motion_losses(scene)]
        moved = motion.write(writer.glb)
        writer.losses += motion.losses
        return moved

    try:
        shutter.set_moment(0)
        writer = SceneWriter(folder, motion)
        writer.is_cancelled = engine.test_break
        writer.bakes = _baked_meshes(depsgraph, folder, engine)
        return _export(depsgraph, path, picture, writer, add_motion)
    finally:
        shutter.set_back()


def _export(depsgraph, path, picture, writer, add_motion):
    """Writes the file.  add_motion: called when all else is in the file; returns a text of what
    moves, None: nothing."""
    scene = depsgraph.scene
    writer.losses += _scene_losses(scene, picture)
    writer.add_camera(scene.camera.evaluated_get(depsgraph), picture)
    for instance in depsgraph.object_instances:
        if instance.show_self:
            writer.add(instance)
    writer.add_world(scene.world)
    moved = add_motion(writer)
    writer.hash.update((moved or "").encode())
    writer.glb.write(path)
    remove_other_volumes(writer.folder, writer.glb.json)
    numbers = {"IndexOB": writer.object_numbers, "IndexMA": writer.materials.numbers}
    return ExportedScene(path, writer.hash.hexdigest(), writer.triangles, moved is not None,
                         numbers, without_repeats(writer.losses + writer.materials.losses))
