"""Renders a .glb by Cycles as it is imported, with an unclamped integrator that leaves nothing out.

    blender -b --factory-startup --python bench/cycles_import.py -- SCENE.glb OUT.pfm WIDTH HEIGHT \
        SAMPLES SEED THREADS

Lights and the camera's lens get the sizes that the file gives hipmap (docs/scene.md); a light without
one is a point, not the sphere of 25 cm that Blender's importer makes of it. Absorption is glTF's too, but
Blender's in a file that Blender wrote, as hipmap's --look auto has it.
Prints the processor's seconds that rendering took (of all threads, without import, with Cycles' own
start).
"""

import json
import math
import os
import struct
import sys

import bpy
import numpy

sys.path.append(os.path.dirname(os.path.abspath(__file__)))
import cycles_reference

numpy.bool = bool  # the importer of Debian's Blender still uses a name that Debian's numpy has dropped


def read_json(path):
    """The JSON of a .glb."""
    with open(path, "rb") as file:
        length = struct.unpack("<12xI4x", file.read(20))[0]
        return json.loads(file.read(length))


def sizes_by_node(path):
    """What the file gives hipmap for each node with a light or a camera, by the node's name."""
    gltf = read_json(path)
    lights = gltf.get("extensions", {}).get("KHR_lights_punctual", {}).get("lights", [])
    found = {}
    for node in gltf["nodes"]:
        part = {}
        punctual = node.get("extensions", {}).get("KHR_lights_punctual")
        if punctual:
            part = lights[punctual["light"]]
        elif "camera" in node:
            part = gltf["cameras"][node["camera"]]
        own = {}
        for owner in (part, node):
            extras = owner.get("extras", {}).get("hipmap", {})
            own.update(json.loads(extras) if isinstance(extras, str) else extras)
        found[node.get("name")] = own
    return found


def set_sizes(objects, sizes):
    """Radii of lights, angles of suns, and the lens of the camera."""
    for item in objects:
        own = sizes.get(item.name, {})
        if item.type == "LIGHT" and item.data.type == "SUN":
            item.data.angle = math.radians(own.get("angle_deg", 0))
        elif item.type == "LIGHT":
            item.data.shadow_soft_size = own.get("radius", 0)
        elif item.type == "CAMERA" and own.get("aperture_radius", 0) > 0:
            item.data.dof.use_dof = True
            item.data.dof.focus_distance = own["focus_distance"]
            item.data.dof.aperture_fstop = item.data.lens / 1000 / (2 * own["aperture_radius"])


def mend_absorption(node):
    """The importer's node absorbs (1 - colour) / distance where glTF means -ln(colour) / distance."""
    colour, density = node.inputs["Color"].default_value, node.inputs["Density"].default_value
    meant = [-math.log(max(c, 1e-6)) * density for c in colour[:3]]
    most = max(meant)
    if most > 0:
        node.inputs["Color"].default_value = [1 - m / most for m in meant] + [1]
        node.inputs["Density"].default_value = most


def import_scene(path):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=os.path.abspath(path))
    scene = bpy.context.scene
    set_sizes(scene.objects, sizes_by_node(path))
    by_blender = "Blender I/O" in read_json(path)["asset"].get("generator", "")
    for material in () if by_blender else bpy.data.materials:
        for node in material.node_tree.nodes if material.use_nodes else ():
            if node.type == "VOLUME_ABSORPTION":
                mend_absorption(node)
    scene.camera = next(item for item in scene.objects if item.type == "CAMERA")
    scene.world = bpy.data.worlds.new("none")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs["Strength"].default_value = 0
    scene.view_settings.view_transform = "Raw"


def main():
    path, image, width, height, samples, seed, threads = sys.argv[sys.argv.index("--") + 1:]
    import_scene(path)
    cycles_reference.render_timed(image, (int(width), int(height)), int(samples), int(seed),
                                  int(threads))


main()
