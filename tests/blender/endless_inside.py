"""Renders until it is stopped, for processes_test.py:

    blender --python endless_inside.py -- ADDON.zip PROGRAMS SCENE.blend FOLDER
"""

import os
import sys

import bpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import install_addon

ARCHIVE, PROGRAMS, SCENE, FOLDER = sys.argv[sys.argv.index("--") + 1:]

install_addon.install(ARCHIVE, PROGRAMS)
bpy.ops.wm.open_mainfile(filepath=SCENE)
scene = install_addon.set_up(FOLDER, passes=1_000_000)
scene.render.resolution_x, scene.render.resolution_y = 480, 360
scene.hipmap.photons = 200_000
bpy.ops.render.render()
print("render returned", flush=True)
