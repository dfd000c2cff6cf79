"""Builds scene 2, hexagonal_room.glb: a hexagonal room of hexagonal prisms, three of glass, with three mirrors.

    blender -b --factory-startup --python experiments/scenes/hexagonal_room.py -- OUT.glb

A table with stools under a pendant lamp; a pane of light under the ceiling lights the rest.
Metres; Blender's axes (z up).
"""

import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../assets"))
import modelling as m

RADIUS, CEILING = 2.6, 2.6  # of the room, to a corner
TABLE = (-0.2, 0.35)  # x, y of its middle
TABLE_TOP = 0.74
MIDDLE_OF_WALL = RADIUS * math.cos(math.radians(30))


def hexagon(radius, z):
    angles = [math.radians(60 * i) for i in range(6)]
    return [(radius * math.cos(a), radius * math.sin(a), z) for a in angles]


def add_room(walls, floor, ceiling):
    """A prism seen from inside."""
    corners = hexagon(RADIUS, 0) + hexagon(RADIUS, CEILING)
    sides = [(0, (i, 6 + i, 6 + (i + 1) % 6, (i + 1) % 6)) for i in range(6)]
    m.add_mesh("Room", corners, [*sides, (1, tuple(range(6))), (2, tuple(range(11, 5, -1)))],
               [walls, floor, ceiling])


def add_lamps(case):
    """Two light primitives: a triangle in a hexagon under the ceiling, a bare bulb over the table."""
    daylight = m.glowing("Daylight", (1, 0.96, 0.9), 20)
    x, y, radius, low = 0.75, -0.5, 0.5, CEILING - 0.06
    m.add_prism("Ceiling lamp", (x, y, low), radius, 0.06, case, ["bottom", "top"])
    corners = [(x + cx, y + cy, z) for cx, cy, z in hexagon(radius, low)]
    m.add_mesh("Pane", corners, [(0, (4, 2, 0)), (1, (2, 1, 0)), (1, (4, 3, 2)), (1, (0, 5, 4))],
               [daylight, case])
    m.add_point_lamp("Bulb", (*TABLE, 1.5), 60, (1, 0.8, 0.55))


def add_table(wood, glass):
    x, y = TABLE
    m.add_prism("Table column", (x, y, 0), 0.12, 0.7, wood, ["bottom", "top"])
    m.add_prism("Table top", (x, y, 0.7), 0.66, TABLE_TOP - 0.7, wood)
    on_top = TABLE_TOP + m.GLASS_GAP
    m.add_prism("Glass vase", (x + 0.2, y - 0.12, on_top), 0.1, 0.32, glass, turn_deg=12)
    m.add_prism("Paperweight", (x - 0.16, y - 0.26, on_top), 0.09, 0.07, glass, turn_deg=25)


def add_stools():
    colours = {"Mustard": (0.7, 0.48, 0.1), "Blue": (0.14, 0.25, 0.5), "Leaf": (0.3, 0.45, 0.15)}
    for i, (name, colour) in enumerate(colours.items()):
        angle = math.radians((-130, -20, 165)[i])
        at = (TABLE[0] + 0.98 * math.cos(angle), TABLE[1] + 0.98 * math.sin(angle), 0)
        m.add_prism(f"Stool {name}", at, 0.22, 0.44, m.matte(name, colour), ["bottom"],
                    turn_deg=(10, 20, 0)[i])


def add_mirrors():
    """On the far wall: polished prisms laid on their backs, without the face at the wall."""
    polished = m.mirror()
    for name, x, z, radius in (("Large", -0.1, 1.62, 0.48), ("Upper", -0.85, 1.95, 0.26),
                               ("Lower", -0.85, 1.3, 0.26)):
        hung = m.add_prism(f"{name} mirror", (0, 0, 0), radius, 0.03, polished, ["bottom"])
        hung.location = (x, MIDDLE_OF_WALL, z)
        hung.rotation_euler = (math.radians(90), 0, 0)


def add_scene():
    white = m.matte("White", (0.5, 0.49, 0.47))
    wood = m.matte("Oak", (0.62, 0.43, 0.24))
    glass = m.glass()
    add_room(m.matte("Teal", (0.2, 0.33, 0.35)), m.matte("Floor", (0.4, 0.3, 0.22)), white)
    add_lamps(white)
    add_table(wood, glass)
    add_stools()
    add_mirrors()
    m.add_prism("Plinth", (1.35, 1.15, 0), 0.32, 0.4, white, ["bottom"])
    m.add_prism("Glass column", (1.35, 1.15, 0.4 + m.GLASS_GAP), 0.2, 0.95, glass, turn_deg=15)
    m.add_camera((0.9, -1.95, 1.5), (-0.05, 0.9, 0.9), 22)


m.build(add_scene)
