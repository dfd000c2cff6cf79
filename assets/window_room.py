"""Builds window_room.glb: a room lit by sun and sky through one window, with a glass on a table.

    python3 assets/window_room.py OUT.glb
"""

import math
import os
import sys

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "bench", "scenes"))

# pylint: disable=wrong-import-position
from props import drinking_glass, filling, wall_with_hole
from room_writer import Room
from solids import bevelled_box, joined, rectangle

WIDE, HIGH, DEEP = 4.0, 2.7, 5.0  # m; x to the right, y up, the camera looks along -z
WINDOW = (1.6, 0.9, 3.2, 2.1)  # x0, y0, x1, y1 on the left wall, x from its far end
GAP = 2e-5  # between a table and what stands on it: faces must not coincide


def add_shell(room, wall, floor):
    x, z = WIDE / 2, DEEP
    room.add("Floor", floor, rectangle((-x, 0, 0), (WIDE, 0, 0), (0, 0, -z)))
    room.add("Ceiling", wall, rectangle((-x, HIGH, -z), (WIDE, 0, 0), (0, 0, z)))
    room.add("Far wall", wall, rectangle((-x, 0, -z), (WIDE, 0, 0), (0, HIGH, 0)))
    room.add("Near wall", wall, rectangle((x, 0, 0), (-WIDE, 0, 0), (0, HIGH, 0)))
    room.add("Right wall", wall, rectangle((x, 0, -z), (0, 0, z), (0, HIGH, 0)))
    left = wall_with_hole(DEEP, HIGH, WINDOW, 0.25).turned("y", 90).moved(-x, 0, 0)
    room.add("Left wall", wall, left)


def add_furniture(room, wood, shade):
    legs = [bevelled_box(0.06, 0.7, 0.06, 0.005, 1).moved(sx * 0.6, 0.0005, sz * 0.3)
            for sx in (-1, 1) for sz in (-1, 1)]
    top = bevelled_box(1.4, 0.04, 0.8, 0.008, 2).moved(0, 0.701, 0)
    room.add("Table", wood, joined(legs + [top]), at=(-0.4, 0, -2.6))
    room.add("Chest", shade, bevelled_box(0.5, 0.9, 1.4, 0.02, 2), at=(1.7, 0.0005, -3.6))


def add_glass(room):
    glass, water = room.glass("Glass", 1.5, priority=2), room.glass("Water", 1.333, priority=1)
    vessel, inside = drinking_glass(0.2, 0.07, 0.004, 64, 8)
    mesh = room.mesh_of("Tumbler", [(glass, vessel), (water, filling(inside, 0.13, 0.0008, 64))], 40)
    room.place("Tumbler", mesh, at=(-0.6, 0.741 + GAP, -2.5))


def build(room):
    room.root["asset"]["generator"] = "hipmap assets/window_room.py"
    wall = room.matte("Wall", (0.78, 0.76, 0.72))
    add_shell(room, wall, room.matte("Floor", (0.42, 0.3, 0.2)))
    room.add("Ground", room.matte("Ground", (0.3, 0.32, 0.22)),
             rectangle((-30, -0.4, 25), (60, 0, 0), (0, 0, -60)))
    add_furniture(room, room.matte("Wood", (0.55, 0.38, 0.22)), room.matte("Blue", (0.2, 0.3, 0.5)))
    add_glass(room)
    room.sun("Sun", (0.75, -0.62, -0.1), 12, (1, 0.93, 0.82), 0.53)
    room.world((0.55, 0.75, 1.0), 0.8)
    room.camera((0.7, 1.45, -0.25), (-0.5, 0.95, -3.0), math.radians(50))


if __name__ == "__main__":
    made = Room()
    build(made)
    made.write(sys.argv[1])
