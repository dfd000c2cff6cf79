# SPDX-License-Identifier: GPL-3.0-or-later
"""Renders the one world of a .blend to an environment map, inside a Blender of its own:

    blender --background --factory-startup --python bake_world.py -- FILE.blend OUT.exr WIDTH
"""

import math
import os
import sys

import bpy

# The disc of a sky's sun covers few pixels: more samples of each find its power.
_SAMPLES_OF_SUN = 16


def load_world(path):
    """Returns the first world of a .blend."""
    with bpy.data.libraries.load(path) as (source, target):
        target.worlds = source.worlds[:1]
    return target.worlds[0]


def panorama_camera(scene):
    """Adds a camera that sees all directions, the middle of its picture towards +X."""
    camera = bpy.data.cameras.new("panorama")
    camera.type = "PANO"
    owner = camera if hasattr(camera, "panorama_type") else camera.cycles
    owner.panorama_type = "EQUIRECTANGULAR"
    item = bpy.data.objects.new("panorama", camera)
    item.rotation_euler = (math.pi / 2, 0, -math.pi / 2)
    scene.collection.objects.link(item)
    return item


def shows_a_sun(tree):
    """Whether a node tree or a group in it has a sky with the disc of its sun."""
    return any(getattr(node, "sun_disc", False) or
               (getattr(node, "node_tree", None) and shows_a_sun(node.node_tree))
               for node in tree.nodes)


def set_up(scene, width):
    """Sets Cycles to render the mean of the world over each pixel, linear."""
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = _SAMPLES_OF_SUN if shows_a_sun(scene.world.node_tree) else 1
    scene.cycles.use_denoising = False
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.pixel_filter_type = "BOX"
    scene.cycles.filter_width = 1.0
    scene.cycles.sample_clamp_indirect = 0
    scene.render.use_compositing = False
    scene.render.use_sequencer = False
    scene.render.resolution_x = width
    scene.render.resolution_y = width // 2
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.image_settings.color_mode = "RGB"


def remove_volume(tree):
    """Unlinks the world's volume, which has no end in Cycles and would hide the sky."""
    for node in tree.nodes:
        if node.bl_idname == "ShaderNodeOutputWorld":
            for link in node.inputs["Volume"].links:
                tree.links.remove(link)


def main():
    """Renders what the command line names."""
    blend, image, width = sys.argv[sys.argv.index("--") + 1:]
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.world = load_world(blend)
    remove_volume(scene.world.node_tree)
    scene.camera = panorama_camera(scene)
    set_up(scene, int(width))
    scene.render.filepath = image + ".part.exr"
    bpy.ops.render.render(write_still=True)
    os.replace(image + ".part.exr", image)


main()
