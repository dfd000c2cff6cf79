"""Builds scene 1, axis_aligned.glb: 149 triangles, all parallel or perpendicular to each other.

    blender -b --factory-startup --python experiments/scenes/axis_aligned.py -- OUT.glb

A dining corner with a mirror on the wall and a block of glass on the table, under two glowing
panels and a pendant lamp (a point light).  Metres; Blender's axes (z up).
"""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../assets"))
import modelling as m

LEFT, RIGHT, NEAR, FAR, CEILING = -2.2, 2.2, -2.6, 2.4, 2.6
LAMP = (-0.45, 0.3)  # x, y of the pendant, above the middle of the table
TABLE_TOP = 0.74


def add_room(white):
    floor = m.matte("Floor", (0.42, 0.29, 0.18))
    brick = m.matte("Brick", (0.55, 0.2, 0.12))
    sage = m.matte("Sage", (0.34, 0.46, 0.33))
    slate = m.matte("Slate", (0.22, 0.27, 0.33))
    m.add_room((LEFT, NEAR, 0), (RIGHT, FAR, CEILING), white,
               {"bottom": floor, "left": brick, "right": sage, "front": slate})


def add_panel(name, centre, size, glow, case):
    """A flat lamp under the ceiling that shines downwards."""
    low = [c - s / 2 for c, s in zip(centre, size)] + [CEILING - 0.06]
    high = [c + s / 2 for c, s in zip(centre, size)] + [CEILING]
    m.add_box(name, low, high, case, ["top"], {"bottom": glow})


def add_lamps(case):
    daylight = m.glowing("Daylight", (1, 0.95, 0.88), 16)
    warm = m.glowing("Warm", (1, 0.78, 0.5), 24)
    add_panel("Large panel", (0.75, 0.75), (1.3, 0.55), daylight, case)
    add_panel("Small panel", (-1.7, 1.3), (0.35, 0.35), warm, case)
    x, y = LAMP
    shade = m.matte("Shade", (0.75, 0.72, 0.62))
    m.add_box("Shade", (x - 0.2, y - 0.2, 1.52), (x + 0.2, y + 0.2, 1.74), shade, ["bottom"])
    m.add_box("Rod", (x - 0.012, y - 0.012, 1.74), (x + 0.012, y + 0.012, CEILING), shade,
              ["bottom", "top"])
    m.add_point_lamp("Bulb", (x, y, 1.6), 30, (1, 0.85, 0.65))


def add_table(wood):
    """Two boards carry the top; a block of glass stands on it."""
    x, y = LAMP
    m.add_box("Table top", (x - 0.8, y - 0.42, 0.7), (x + 0.8, y + 0.42, TABLE_TOP), wood)
    for name, at in (("Left board", x - 0.64), ("Right board", x + 0.58)):
        m.add_box(name, (at, y - 0.34, 0), (at + 0.06, y + 0.34, 0.7), wood, ["bottom", "top"])
    low = TABLE_TOP + m.GLASS_GAP
    m.add_box("Glass block", (x - 0.36, y - 0.2, low), (x - 0.12, y + 0.04, low + 0.3), m.glass())


def add_sideboard(white, blue):
    """Under the mirror, before the far wall."""
    m.add_box("Sideboard", (0.0, 1.95, 0), (1.6, FAR - 0.03, 0.72), blue, ["bottom"])
    m.add_box("Square vase", (1.22, 2.08, 0.72), (1.42, 2.28, 1.04), white, ["bottom", "top"])
    m.add_box("Mirror", (-0.1, FAR - 0.03, 1.0), (1.7, FAR, 2.0), white, ["back"],
              {"front": m.mirror()})


def add_shelf(wood):
    """On the left wall; each bracket is one triangle of sheet metal."""
    y0, y1, height = 0.6, 2.0, 1.4
    m.add_box("Shelf", (LEFT, y0, height), (LEFT + 0.26, y1, height + 0.035), wood, ["left"])
    steel = m.matte("Steel", (0.3, 0.3, 0.32))
    for i, y in enumerate((y0 + 0.15, (y0 + y1) / 2, y1 - 0.15)):
        corners = [(LEFT, y, height), (LEFT + 0.22, y, height), (LEFT, y, height - 0.2)]
        m.add_mesh(f"Bracket {i}", corners, [(0, (0, 1, 2))], [steel])


def add_scene():
    white = m.matte("White", (0.74, 0.73, 0.7))
    wood = m.matte("Oak", (0.62, 0.42, 0.22))
    blue = m.matte("Blue", (0.16, 0.27, 0.42))
    add_room(white)
    add_lamps(white)
    add_table(wood)
    add_sideboard(white, blue)
    add_shelf(wood)
    ochre = m.matte("Ochre", (0.68, 0.47, 0.14))
    m.add_box("Bench", (0.85, 0.05, 0), (1.3, 0.75, 0.44), ochre, ["bottom"])
    m.add_box("Paper basket", (-1.95, 1.0, 0), (-1.65, 1.3, 0.36), white, ["bottom", "top"])
    m.add_camera((1.25, -2.45, 1.5), (-0.3, 1.0, 0.98), 22)


m.build(add_scene)
