"""Run by Blender: saves a linear image through a view transform.

    blender -b --python view_in_blender.py -- IMAGE.exr VIEW OUT.png
"""

import sys

import bpy

image, view, out = sys.argv[sys.argv.index("--") + 1:]
scene = bpy.context.scene
scene.view_settings.view_transform = view
scene.render.image_settings.file_format = "PNG"
scene.render.image_settings.color_mode = "RGB"
scene.render.image_settings.color_depth = "8"
scene.render.dither_intensity = 0
bpy.data.images.load(image).save_render(out, scene=scene)
