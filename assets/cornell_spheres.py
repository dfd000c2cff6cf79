"""Builds cornell_spheres.glb: the Cornell box with a mirror and a glass sphere, each of 20,480
flat triangles.

    blender -b --factory-startup --python assets/cornell_spheres.py -- assets/cornell_spheres.glb
"""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

# pylint: disable=wrong-import-position
from cornell_box import add_camera, add_lamp, add_room
from modelling import GLASS_GAP, add_icosphere, build, glass, matte, mirror

RADIUS = 0.4
DIVISIONS = 5  # 20,480 triangles


def add_scene():
    add_room(matte("White", (0.74, 0.74, 0.72)))
    above = GLASS_GAP + RADIUS
    add_icosphere("Mirror sphere", (-0.45, 0.35, above), RADIUS, DIVISIONS, mirror())
    add_icosphere("Glass sphere", (0.45, -0.35, above), RADIUS, DIVISIONS, glass())
    add_lamp()
    add_camera()


build(add_scene, normals=False)
