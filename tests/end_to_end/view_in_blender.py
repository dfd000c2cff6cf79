"""Run by Blender: saves linear images through view transforms.

    blender -b --python view_in_blender.py -- [IMAGE.exr VIEW OUT.png]...
"""

import sys

import bpy

words = sys.argv[sys.argv.index("--") + 1:]
scene = bpy.context.scene
scene.render.image_settings.file_format = "PNG"
scene.render.image_settings.color_mode = "RGB"
scene.render.image_settings.color_depth = "8"
scene.render.dither_intensity = 0
for image, view, out in zip(*[iter(words)] * 3):
    scene.view_settings.view_transform = view
    bpy.data.images.load(image).save_render(out, scene=scene)
