"""Builds scene 2, hexagonal.glb: a room of hexagonal prisms, three of glass, with three mirrors.

    blender -b --factory-startup --python experiments/scenes/hexagonal.py -- OUT.glb

A table with stools under a pendant lamp; a pane of light under the ceiling lights the rest.
Metres; Blender's axes (z up).
"""

import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../assets"))
import modelling as m

LEFT, RIGHT, NEAR, FAR, CEILING = -2.3, 2.3, -2.6, 2.3, 2.7
TABLE = (-0.2, 0.25)  # x, y of its middle
RUG, TABLE_TOP = 0.015, 0.74  # heights


def add_room(white):
    floor = m.matte("Floor", (0.5, 0.4, 0.3))
    teal = m.matte("Teal", (0.1, 0.33, 0.35))
    rose = m.matte("Rose", (0.6, 0.33, 0.28))
    m.add_room((LEFT, NEAR, 0), (RIGHT, FAR, CEILING), white,
               {"bottom": floor, "left": teal, "front": rose})


def add_lamps(case):
    """Two light primitives: a triangle in a hexagon under the ceiling, a bulb in a pendant."""
    daylight = m.glowing("Daylight", (1, 0.96, 0.9), 28)
    x, y, radius, low = 0.85, 1.0, 0.5, CEILING - 0.06
    m.add_prism("Ceiling lamp", (x, y, low), radius, 0.06, case, ["bottom", "top"])
    angles = [math.radians(60 * i) for i in range(6)]
    corners = [(x + radius * math.cos(a), y + radius * math.sin(a), low) for a in angles]
    m.add_mesh("Pane", corners, [(0, (4, 2, 0)), (1, (2, 1, 0)), (1, (4, 3, 2)), (1, (0, 5, 4))],
               [daylight, case])
    shade = m.matte("Shade", (0.16, 0.16, 0.17))
    m.add_prism("Pendant", (*TABLE, 1.62), 0.17, 0.16, shade, ["bottom"])
    m.add_prism("Rod", (*TABLE, 1.78), 0.012, CEILING - 1.78, shade, ["bottom", "top"])
    m.add_point_lamp("Bulb", (*TABLE, 1.66), 24, (1, 0.8, 0.55))


def add_table(wood, glass):
    x, y = TABLE
    m.add_prism("Table foot", (x, y, RUG), 0.36, 0.03, wood, ["bottom"])
    m.add_prism("Table column", (x, y, RUG + 0.03), 0.1, 0.7 - RUG - 0.03, wood, ["bottom", "top"])
    m.add_prism("Table top", (x, y, 0.7), 0.66, TABLE_TOP - 0.7, wood)
    on_top = TABLE_TOP + m.GLASS_GAP
    m.add_prism("Glass vase", (x + 0.2, y - 0.12, on_top), 0.1, 0.32, glass, turn_deg=12)
    m.add_prism("Paperweight", (x - 0.16, y - 0.26, on_top), 0.09, 0.07, glass, turn_deg=25)
    red = m.matte("Red", (0.6, 0.08, 0.06))
    m.add_prism("Box", (x - 0.2, y + 0.16, TABLE_TOP), 0.12, 0.16, red, ["bottom"], turn_deg=40)


def add_stools():
    colours = {"Mustard": (0.7, 0.48, 0.1), "Blue": (0.14, 0.25, 0.5), "Leaf": (0.3, 0.45, 0.15)}
    for i, (name, colour) in enumerate(colours.items()):
        angle = math.radians((-150, -40, 75)[i])
        at = (TABLE[0] + 0.98 * math.cos(angle), TABLE[1] + 0.98 * math.sin(angle), RUG)
        m.add_prism(f"Stool {name}", at, 0.22, 0.44, m.matte(name, colour), ["bottom"],
                    turn_deg=(10, 20, 0)[i])


def add_mirrors(case):
    """On the far wall: prisms laid on their backs, without the face at the wall."""
    polished = m.mirror()
    for name, x, z, radius in (("Large", -0.2, 1.62, 0.52), ("Upper", -1.2, 1.95, 0.3),
                               ("Lower", -1.2, 1.3, 0.3)):
        hung = m.add_prism(f"{name} mirror", (0, 0, 0), radius, 0.03, case, ["bottom"],
                           {"top": polished})
        hung.location = (x, FAR, z)
        hung.rotation_euler = (math.radians(90), 0, 0)


def add_scene():
    white = m.matte("White", (0.75, 0.74, 0.71))
    wood = m.matte("Oak", (0.62, 0.43, 0.24))
    glass = m.glass()
    add_room(white)
    add_lamps(white)
    rug = m.matte("Rug", (0.52, 0.47, 0.42))
    m.add_prism("Rug", (*TABLE, 0), 1.45, RUG, rug, ["bottom"])
    add_table(wood, glass)
    add_stools()
    add_mirrors(wood)
    m.add_prism("Plinth", (1.5, 1.45, 0), 0.32, 0.4, white, ["bottom"])
    m.add_prism("Glass column", (1.5, 1.45, 0.4 + m.GLASS_GAP), 0.2, 0.95, glass, turn_deg=15)
    m.add_camera((1.2, -2.35, 1.5), (-0.05, 0.9, 0.9), 25)


m.build(add_scene)
