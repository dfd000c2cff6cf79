"""Builds cornell_diffuse.glb: the Cornell box with two blocks, all of it matt.

    blender -b --factory-startup --python assets/cornell_diffuse.py -- assets/cornell_diffuse.glb
"""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

# pylint: disable=wrong-import-position
from cornell_box import add_block, add_camera, add_lamp, add_room
from modelling import build, matte


def add_scene():
    white = matte("White", (0.74, 0.74, 0.72))
    add_room(white)
    add_block("Tall block", white, (-0.34, 0.32), 18, (0.58, 0.58, 1.2))
    add_block("Low block", white, (0.36, -0.26), -17, (0.58, 0.58, 0.6))
    add_lamp()
    add_camera()


build(add_scene)
