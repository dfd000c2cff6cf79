"""Builds glass_globe.glb: a closed room whose only lamp is inside a hollow globe of glass.

    blender -b --factory-startup --python assets/glass_globe.py -- assets/glass_globe.glb
"""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

# pylint: disable=wrong-import-position
from modelling import (GLASS_GAP, add_box, add_camera, add_icosphere, add_room, build, glass,
                       glowing, matte)

OUTER, INNER, LAMP = 0.3, 0.27, 0.1  # radii, m
DIVISIONS = 5  # 20,480 triangles


def add_scene():
    white = matte("White", (0.74, 0.74, 0.72))
    add_room((-1, -1.5, 0), (1, 1, 2), white,
             {"left": matte("Red", (0.6, 0.07, 0.05)), "right": matte("Green", (0.12, 0.46, 0.1))})
    add_box("Table", (-0.4, -0.1, 0), (0.4, 0.7, 0.5), matte("Ochre", (0.72, 0.55, 0.3)),
            without=("bottom",))
    centre = (0, 0.3, 0.5 + GLASS_GAP + OUTER)
    clear = glass()
    add_icosphere("Globe, outside", centre, OUTER, DIVISIONS, clear)
    add_icosphere("Globe, inside", centre, INNER, DIVISIONS, clear, inward=True)
    add_icosphere("Lamp", centre, LAMP, 2, glowing("Lamp", (1.0, 0.86, 0.68), 60.0))
    add_camera((0, -1.4, 1.1), (0, 0.5, 0.85), 24.0, aspect=1)


build(add_scene, normals=False)
