# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender's own glTF exporter with the boxes that hipmap needs, and what that exporter drops."""

import os
import re
from collections import Counter
from dataclasses import replace

import bpy

from .cameras import camera_extras, camera_losses, shift_extras
from .frame import picture_of
from .glb_file import read_glb, write_glb
from .lights import is_portal, light_extras, light_losses, punctual_light
from .losses import mesh_losses, type_losses, without_repeats
from .world import world_extras, world_losses

_BOXES = {"export_format": "GLB", "export_cameras": True, "export_lights": True,
          "export_apply": True, "export_extras": True, "export_yup": True,
          "use_renderable": True, "use_active_scene": True,
          "export_import_convert_lighting_mode": "SPEC", "export_draco_mesh_compression_enable":
          False}


_WITH_FACES = ("MESH", "CURVE", "SURFACE", "FONT")
_NOT_EXPORTED = {"VOLUME": "volume objects", "META": "metaballs"}


def _boxes():
    """The boxes that this version of the exporter has."""
    known = bpy.ops.export_scene.gltf.get_rna_type().properties.keys()
    return {name: value for name, value in _BOXES.items() if name in known}


def _add_extras(owner, values):
    """Adds values to the custom property `hipmap`; the user's own of the same name stay."""
    if not values:
        return
    extras = owner.setdefault("extras", {})
    if isinstance(extras.get("hipmap"), str):
        return  # written by hand as text: the user decides
    extras["hipmap"] = {**values, **extras.get("hipmap", {})}


def _complete_light(gltf, node, light, folder):
    """Cycles multiplies the light's colour by its nodes'; the exporter takes one of them."""
    punctual = node.get("extensions", {}).get("KHR_lights_punctual")
    if punctual:
        entry = gltf["extensions"]["KHR_lights_punctual"]["lights"][punctual["light"]]
        entry.update(punctual_light(light))
    _add_extras(node, light_extras(light, folder))


def _whole_picture(scene):
    """The exporter knows no border."""
    picture = picture_of(scene.render)
    return replace(picture, left=0, bottom=0, part_width=picture.width,
                   part_height=picture.height)


def _complete_nodes(gltf, scene, folder):
    for node in gltf.get("nodes", []):
        item = scene.objects.get(node.get("name", ""))
        if item is None:
            continue
        if item.type == "LIGHT" and not is_portal(item.data):
            _complete_light(gltf, node, item.data, folder)
        elif item.type == "CAMERA" and "camera" in node:
            _add_extras(node, {**camera_extras(item, item.matrix_world),
                               **shift_extras(item.data, _whole_picture(scene))})


def _holds(gltf, index, name):
    """Whether a node or one below it has this name and a camera."""
    node = gltf["nodes"][index]
    if node.get("name") == name and "camera" in node:
        return True
    return any(_holds(gltf, child, name) for child in node.get("children", []))


def _put_first(gltf, camera):
    """hipmap takes the first camera of the file."""
    roots = gltf["scenes"][gltf.get("scene", 0)].get("nodes", [])
    roots.sort(key=lambda index: not _holds(gltf, index, camera.name))


def _nodes_by_object(gltf):
    """How many nodes with a mesh each object has in the file; Blender numbers names that are taken."""
    names = [node.get("name", "") for node in gltf.get("nodes", []) if "mesh" in node]
    return Counter(name if name in bpy.data.objects else re.sub(r"\.\d+$", "", name)
                   for name in names)


def _missing_instances(scene, gltf):
    """Yields a line for the instances of each object that the exporter left out: those of geometry
    nodes, and those of objects that are hidden in renders."""
    wanted, parents = Counter(), {}
    for instance in bpy.context.evaluated_depsgraph_get().object_instances:
        if not instance.is_instance or not instance.show_self or \
                instance.object.type not in _WITH_FACES or instance.parent.original.hide_render:
            continue
        name = instance.object.name
        wanted[name] += 1
        if instance.parent.original.instance_collection is None:
            parents.setdefault(instance.parent.name, {})[name] = None
    found = _nodes_by_object(gltf)
    for parent, names in parents.items():
        for name in names:
            if found[name] < wanted[name]:  # nodes give instances of a mesh the parent's name
                what = "of geometry nodes" if name == parent else f"of '{name}'"
                yield f"object '{parent}': its instances {what} are not exported; F12 renders them"


def losses_of(scene):
    """Returns what hipmap does not render of a scene's objects, camera and world, one line each."""
    lines = []
    for item in scene.objects:
        if item.hide_render:
            continue
        lines += type_losses(item)
        if item.type == "LIGHT":
            lines += light_losses(item.data)
        elif item.type == "MESH":
            lines += mesh_losses(item)
        elif item.type in _NOT_EXPORTED:
            lines.append(f"object '{item.name}': {_NOT_EXPORTED[item.type]} are not exported; F12 "
                         "renders them")
    if scene.camera is not None:
        lines += camera_losses(scene.camera)
    return without_repeats(lines + list(world_losses(scene.world)))


def export_scene(scene, path):
    """Writes the active scene to a .glb, by the stock exporter, with lights' sizes, area lights,
    the lens and the world.  Returns what hipmap does not render of them, one line each.  Throws
    WorldError if the world could not be rendered to an environment map."""
    path = os.path.abspath(path)
    bpy.ops.export_scene.gltf(filepath=path, **_boxes())
    gltf, buffer = read_glb(path)
    _complete_nodes(gltf, scene, os.path.dirname(path))
    if scene.camera is not None:
        _put_first(gltf, scene.camera)
    taken = gltf["scenes"][gltf.get("scene", 0)]
    _add_extras(taken, world_extras(scene.world, os.path.dirname(path)))
    gltf["asset"]["generator"] += " (completed by hipmap for Blender)"
    write_glb(path, gltf, buffer)
    return losses_of(scene) + list(_missing_instances(scene, gltf))
