# SPDX-License-Identifier: GPL-3.0-or-later
"""Bakes nodes of materials to images, inside a Blender of its own:

    blender --background --factory-startup --python bake_nodes.py -- MATERIALS.blend OUT.npz...

OUT.npz.in holds a mesh and what to bake of it.  bakes.py writes it, and reads OUT.npz.
"""

import json
import math
import os
import sys

import bpy
import numpy
from mathutils import Matrix

_SAMPLES = 4
_MARGIN = 4  # pixels around the faces
_ISLAND_ANGLE = math.radians(66)
_UV = "hipmap baked"
_TARGET = "hipmap target"


def load_materials(path):
    """Returns the materials of a .blend by their names there."""
    with bpy.data.libraries.load(path) as (source, target):
        names = list(source.materials)
        target.materials = list(names)
    return dict(zip(names, target.materials))


def make_mesh(arrays, known):
    """Returns the mesh with its UV maps and colour layers."""
    mesh = bpy.data.meshes.new("mesh")
    mesh.vertices.add(len(arrays["positions"]) // 3)
    mesh.loops.add(len(arrays["corners"]))
    mesh.polygons.add(len(arrays["starts"]))
    mesh.vertices.foreach_set("co", arrays["positions"])
    mesh.loops.foreach_set("vertex_index", arrays["corners"])
    mesh.polygons.foreach_set("loop_start", arrays["starts"])
    mesh.polygons.foreach_set("loop_total", arrays["counts"])
    mesh.polygons.foreach_set("material_index", arrays["slots"])
    mesh.polygons.foreach_set("use_smooth", arrays["smooth"])
    mesh.update(calc_edges=True)
    for index, (kind, name, told) in enumerate(known["layers"]):
        values = arrays[f"layer_{index}"]
        if kind == "uv":
            layer = mesh.uv_layers.new(name=name, do_init=False)
            layer.data.foreach_set("uv", values)
            layer.active_render = bool(told)
        else:
            layer = mesh.color_attributes.new(name, "FLOAT_COLOR", told)
            layer.data.foreach_set("color", values)
    if "space" in known:
        mesh.use_auto_texspace = False
        mesh.texspace_location, mesh.texspace_size = known["space"]
    return mesh


def make_object(arrays, known):
    """Returns the object, alone in the scene, selected, with a UV map without overlaps."""
    for item in list(bpy.data.objects):
        bpy.data.objects.remove(item)
    item = bpy.data.objects.new(known["name"], make_mesh(arrays, known))
    item.matrix_world = Matrix(known["matrix"])
    item.pass_index, item.color = known["pass"], known["colour"]
    bpy.context.scene.collection.objects.link(item)
    bpy.context.view_layer.objects.active = item
    item.select_set(True)
    layer = item.data.uv_layers.new(name=_UV)
    item.data.uv_layers.active = layer
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.uv.smart_project(angle_limit=_ISLAND_ANGLE, island_margin=0.5 * _MARGIN / known["size"])
    bpy.ops.object.mode_set(mode="OBJECT")
    return item


def _new_output(tree):
    """Adds an output to a group.  Returns its name."""
    if hasattr(tree, "interface"):  # Blender 4
        return tree.interface.new_socket(_TARGET, in_out="OUTPUT",
                                         socket_type="NodeSocketColor").identifier
    return tree.outputs.new("NodeSocketColor", _TARGET).identifier


def _by_identifier(sockets, identifier):
    return next(socket for socket in sockets if socket.identifier == identifier)


def _exposed(tree, groups, node, identifier):
    """The output in a tree with what arrives at an input of a node in the groups in it."""
    if groups:
        outer = tree.nodes[groups[0]]
        inner = _exposed(outer.node_tree, groups[1:], node, identifier)
        name = _new_output(outer.node_tree)
        sink = next(x for x in outer.node_tree.nodes if x.bl_idname == "NodeGroupOutput"
                    and x.is_active_output)
        outer.node_tree.links.new(inner, _by_identifier(sink.inputs, name))
        return _by_identifier(outer.outputs, name)
    socket = _by_identifier(tree.nodes[node].inputs, identifier)
    output = socket.links[0].from_socket
    if socket.type != "VALUE" or output.type == "VALUE":
        return output
    number = tree.nodes.new("ShaderNodeMath")  # Blender turns a colour into a number
    number.operation, number.inputs[1].default_value = "ADD", 0
    tree.links.new(output, number.inputs[0])
    return number.outputs[0]


def shown(material, request):
    """Returns a copy of a material that emits what is to be baked; its normals need no change."""
    copy = material.copy()
    if request["term"] == "normal":
        return copy
    tree = copy.node_tree
    emission = tree.nodes.new("ShaderNodeEmission")
    tree.links.new(_exposed(tree, request["groups"], request["node"], request["socket"]),
                   emission.inputs["Color"])
    tree.links.new(emission.outputs[0], tree.get_output_node("CYCLES").inputs["Surface"])
    return copy


def dark():
    """Returns a material for the other faces."""
    material = bpy.data.materials.new("dark")
    material.use_nodes = True
    material.node_tree.nodes.clear()
    return material


def bake(item, slots, material, request, size):
    """Returns [size, size, 4]: what a request asks for.  slots: the material slot of each face."""
    image = bpy.data.images.new(_TARGET, size, size, float_buffer=True, is_data=True)
    item.data.materials.clear()
    for slot in range(slots.max() + 1):
        made = shown(material, request) if slot == request["slot"] else dark()
        node = made.node_tree.nodes.new("ShaderNodeTexImage")
        node.image = image
        made.node_tree.nodes.active = node
        item.data.materials.append(made)
    item.data.polygons.foreach_set("material_index", slots)  # that clear() has set to 0
    bpy.ops.object.bake(type="NORMAL" if request["term"] == "normal" else "EMIT",
                        uv_layer=_UV, margin=_MARGIN, use_clear=True)
    pixels = numpy.empty(size * size * 4, numpy.float32)
    image.pixels.foreach_get(pixels)
    bpy.data.images.remove(image)
    return pixels.reshape(size, size, 4)


def bake_file(path, materials):
    """Bakes what a file asks for, and writes the images beside it."""
    with numpy.load(path + ".in") as file:
        arrays = {name: file[name] for name in file.files if name != "known"}
        known = json.loads(file["known"].tobytes())
    item = make_object(arrays, known)
    out = {}
    for index, request in enumerate(known["requests"]):
        material = materials[known["names"][request["material"]]]
        image = bake(item, arrays["slots"], material, request, known["size"])
        out[f"image_{index}"] = image.astype(numpy.float16)
    uvs = numpy.empty(len(item.data.loops) * 2, numpy.float32)
    item.data.uv_layers[_UV].data.foreach_get("uv", uvs)
    requests = numpy.frombuffer(json.dumps(known["requests"]).encode(), "u1")
    with open(path + ".part", "wb") as file:
        numpy.savez(file, requests=requests, uvs=uvs, **out)
    os.replace(path + ".part", path)


def main():
    """Bakes what the command line names."""
    blend, *paths = sys.argv[sys.argv.index("--") + 1:]
    bpy.ops.wm.read_factory_settings(use_empty=True)
    materials = load_materials(blend)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device, scene.cycles.samples = "CPU", _SAMPLES
    scene.cycles.use_denoising = scene.cycles.use_adaptive_sampling = False
    for path in paths:
        bake_file(path, materials)


main()
