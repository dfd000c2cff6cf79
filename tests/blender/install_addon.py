"""Installs the add-on from its zip into the profile of this Blender, and renders with it."""

import os

import bpy
import numpy


def install(archive, programs):
    """As a user does: Install, tick the box, choose the folder of the programs."""
    bpy.ops.preferences.addon_install(filepath=archive)
    bpy.ops.preferences.addon_enable(module="hipmap")
    bpy.context.preferences.addons["hipmap"].preferences.programs = programs


def set_up(folder, passes=2):
    """Makes hipmap the engine of the open scene, with few samples; keeps its files in a folder."""
    scene = bpy.context.scene
    scene.render.engine = "HIPMAP"
    settings = scene.hipmap
    settings.stop_at, settings.passes = "PASSES", passes
    settings.photons, settings.folder = 5000, folder
    settings.threads = 2
    image = scene.render.image_settings
    image.file_format, image.color_depth, image.color_mode = "OPEN_EXR", "32", "RGBA"
    return scene


def dump(exr, path):
    """Writes the colours of an EXR as floats, row by row from the bottom, as in a .pfm."""
    image = bpy.data.images.load(exr)
    pixels = numpy.empty(image.size[0] * image.size[1] * 4, numpy.float32)
    image.pixels.foreach_get(pixels)
    pixels.reshape(-1, 4)[:, :3].tofile(path)
    bpy.data.images.remove(image)
    os.remove(exr)


def render(path):
    """F12; writes the result by `dump`."""
    scene = bpy.context.scene
    scene.render.filepath = path + ".exr"
    bpy.ops.render.render(write_still=True)
    dump(path + ".exr", path)
