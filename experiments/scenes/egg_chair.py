"""Builds scene 3, egg_chair.glb: 2,916 triangles; a curved egg chair in a room.

    blender -b --factory-startup --python experiments/scenes/egg_chair.py -- OUT.glb

A globe lamp and a panel under the ceiling, a tall mirror on the wall, a glass ball on a small
table.  Metres; Blender's axes (z up).
"""

import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "../../assets"), HERE]
import egg_parts as egg
import modelling as m

LEFT, RIGHT, NEAR, FAR, CEILING = -2.1, 2.1, -2.6, 2.1, 2.6
CHAIR = (-0.2, 0.1)  # x, y
FINENESS = egg.Fineness(segments=28, outside=8, inside=8, rim=9)


def add_lamps(white):
    daylight = m.glowing("Daylight", (1, 0.96, 0.9), 12)
    warm = m.glowing("Warm", (1, 0.82, 0.6), 14)
    m.add_box("Panel", (0.2, -1.0, CEILING - 0.06), (1.4, -0.4, CEILING), white, ["top"],
              {"bottom": daylight})
    x, y, low = -1.2, 1.2, 1.62
    m.add_turned("Globe", (x, y, low), *egg.ball(0.15, 12, 4), warm)
    cord = m.matte("Cord", (0.1, 0.1, 0.1))
    m.add_box("Cord", (x - 0.006, y - 0.006, low + 0.299), (x + 0.006, y + 0.006, CEILING), cord,
              ["bottom", "top"])


def add_side_table(white):
    m.add_box("Side table", (0.8, 0.35, 0), (1.3, 0.85, 0.46), white, ["bottom"])
    m.add_box("Book", (1.03, 0.4, 0.46), (1.2, 0.62, 0.49), m.matte("Red", (0.5, 0.07, 0.06)),
              ["bottom"])
    m.add_turned("Glass ball", (0.96, 0.68, 0.46 + m.GLASS_GAP), *egg.ball(0.12, 20, 11), m.glass())


def add_scene():
    white = m.matte("White", (0.76, 0.75, 0.72))
    floor = m.matte("Floor", (0.52, 0.38, 0.25))
    petrol = m.matte("Petrol", (0.1, 0.27, 0.33))
    m.add_room((LEFT, NEAR, 0), (RIGHT, FAR, CEILING), white,
               {"bottom": floor, "left": petrol, "front": m.matte("Sand", (0.6, 0.5, 0.36))},
               cell=0.57)
    add_lamps(white)
    egg.add_shell(m.matte("Shell", (0.78, 0.3, 0.06)), CHAIR, FINENESS)
    egg.add_cushion(m.matte("Cushion", (0.7, 0.66, 0.58)), CHAIR)
    egg.add_foot(m.mirror("Steel", (0.8, 0.8, 0.82)), CHAIR)
    add_side_table(white)
    frame = m.matte("Frame", (0.3, 0.2, 0.12))
    m.add_box("Mirror", (0.35, FAR - 0.03, 0.3), (1.35, FAR, 2.1), frame, ["back"],
              {"front": m.mirror()})
    m.add_camera((0.75, -2.35, 1.35), (0.0, 0.8, 0.88), 27)


m.build(add_scene)
