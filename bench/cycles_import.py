"""Renders a .glb by Cycles as it is imported, with an unclamped integrator that leaves nothing out.

    blender -b --factory-startup --python bench/cycles_import.py -- SCENE.glb OUT.pfm WIDTH HEIGHT \
        SAMPLES SEED THREADS

Prints the processor's seconds that rendering took (of all threads, without import, with Cycles' own
start).
"""

import os
import sys

import bpy
import numpy

sys.path.append(os.path.dirname(os.path.abspath(__file__)))
import cycles_reference

numpy.bool = bool  # the importer of Debian's Blender still uses a name that Debian's numpy has dropped


def import_scene(path):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=os.path.abspath(path))
    scene = bpy.context.scene
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
