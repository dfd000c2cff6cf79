"""Builds scene 3, egg_room.glb: 2,916 triangles; a curved egg chair and round furniture in a room with whole walls.

    blender -b --factory-startup --python experiments/scenes/egg_room.py -- OUT.glb

A globe lamp under the hood of the chair lights it from within, a panel under the ceiling the rest; an oval
mirror on the wall, a foot of polished steel, a glass ball on a table.  Metres; Blender's axes (z up).
"""

import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "../../assets"), HERE]
import egg_parts as egg
import modelling as m

LEFT, RIGHT, NEAR, FAR, CEILING = -1.7, 1.7, -2.2, 1.6, 2.4
CHAIR = (-0.1, 0.2)  # x, y
FINENESS = egg.Fineness(segments=28, outside=8, inside=13, rim=9)
GLOBE = (-0.06, 0.1, 0.93)  # its lowest point, under the hood


def add_lamps():
    m.add_mesh("Panel", [(0.5, -1.2, CEILING - 0.02), (1.1, -1.2, CEILING - 0.02),
                         (1.1, -0.7, CEILING - 0.02), (0.5, -0.7, CEILING - 0.02)],
               [(0, (0, 3, 2, 1))], [m.glowing("Daylight", (1, 0.96, 0.9), 1.2)])
    m.add_turned("Globe", GLOBE, *egg.ball(0.11, 12, 4), m.glowing("Warm", (1, 0.82, 0.6), 40))


def add_rug(material):
    """A ring about the foot of the chair."""
    profile = [(1.1, 0), (1.08, 0.012), *((1.08 - 0.25 * i, 0.012) for i in range(1, 4)),
               (0.32, 0.0)]
    m.add_turned("Rug", (*CHAIR, 0), profile, 16, material)


def add_round_furniture(white, red):
    """Each is one smooth surface: no edge has 90 degrees."""
    table = [(0.2, 0), (0.06, 0.08), (0.06, 0.4), (0.25, 0.45), (0.25, 0.47), (0.23, 0.485),
             (0.11, 0.485), (0, 0.485)]
    m.add_turned("Side table", (1.15, 0.35, 0), table, 16, white)
    m.add_turned("Glass ball", (1.15, 0.35, 0.485 + m.GLASS_GAP), *egg.ball(0.12, 17, 4), m.glass())
    stool = [(0.22, 0.012), (0.25, 0.12), (0.25, 0.26), (0.2, 0.33), (0.1, 0.35), (0, 0.35)]
    m.add_turned("Stool", (0.28, -0.45, 0), stool, 18, red)


def add_mirror(frame):
    """Oval, on the far wall."""
    middle, count = (0.75, 1.45), 18
    angles = [2 * math.pi * i / count for i in range(count)]
    ring = [(middle[0] + 0.42 * math.cos(a), middle[1] + 0.62 * math.sin(a)) for a in angles]
    corners = [(x, y, z) for y in (FAR, FAR - 0.03) for x, z in ring]
    sides = [(0, (i, (i + 1) % count, count + (i + 1) % count, count + i)) for i in range(count)]
    m.add_mesh("Mirror", corners, [*sides, (1, tuple(range(count, 2 * count)))], [frame, m.mirror()])


def add_scene():
    white = m.matte("White", (0.36, 0.35, 0.34))
    m.add_room((LEFT, NEAR, 0), (RIGHT, FAR, CEILING), white,
               {"bottom": m.matte("Floor", (0.34, 0.25, 0.17)), "left": m.matte("Petrol", (0.1, 0.27, 0.33)),
                "front": m.matte("Sand", (0.4, 0.34, 0.24))})
    steel = m.mirror("Steel", (0.8, 0.8, 0.82))
    add_lamps()
    egg.add_shell(m.matte("Shell", (0.82, 0.48, 0.2)), CHAIR, FINENESS)
    egg.add_cushion(m.matte("Cushion", (0.85, 0.8, 0.7)), CHAIR)
    egg.add_foot(steel, CHAIR)
    add_rug(m.matte("Rug", (0.55, 0.5, 0.42)))
    add_round_furniture(white, m.matte("Red", (0.55, 0.12, 0.1)))
    add_mirror(m.matte("Frame", (0.3, 0.2, 0.12)))
    m.add_camera((0.9, -2.1, 1.35), (0.0, 0.6, 0.8), 24)


m.build(add_scene)
