"""Builds sixty_rooms.glb: a house of sixty closed rooms, each with a lamp; the camera is in one.

    python3 assets/sixty_rooms.py OUT.glb
"""

import math
import os
import sys

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "bench", "scenes"))

# pylint: disable=wrong-import-position
from props import drinking_glass
from room_writer import Room
from solids import bevelled_box, joined, rectangle

SIDE, HIGH, WALL = 3.0, 2.5, 0.1  # m; of a room, and between rooms
ROWS, COLUMNS = 6, 10
SEEN = (2, 4)  # row and column of the camera's room
GAP = 2e-5  # faces must not coincide


def shell():
    """The inside of a room about the Y axis."""
    a, h = SIDE / 2, HIGH
    return joined([rectangle((-a, 0, a), (SIDE, 0, 0), (0, 0, -SIDE)),
                   rectangle((-a, h, -a), (SIDE, 0, 0), (0, 0, SIDE)),
                   rectangle((-a, 0, -a), (SIDE, 0, 0), (0, h, 0)),
                   rectangle((a, 0, a), (-SIDE, 0, 0), (0, h, 0)),
                   rectangle((a, 0, -a), (0, 0, SIDE), (0, h, 0)),
                   rectangle((-a, 0, a), (0, 0, -SIDE), (0, h, 0))])


def build(room):
    room.root["asset"]["generator"] = "hipmap assets/sixty_rooms.py"
    walls = [room.matte(f"Wall {i}", color) for i, color in enumerate(
        ((0.75, 0.72, 0.66), (0.7, 0.5, 0.42), (0.5, 0.62, 0.7)))]
    block = room.matte("Block", (0.6, 0.55, 0.4))
    glass = room.glass("Glass", 1.5)
    shells = [room.mesh_of(f"Shell {i}", [(wall, shell())]) for i, wall in enumerate(walls)]
    blocks = room.mesh_of("Block", [(block, bevelled_box(0.7, 0.6, 0.7, 0.02, 2))])
    tumbler = room.mesh_of("Tumbler", [(glass, drinking_glass(0.24, 0.09, 0.006, 48, 6)[0])], 40)
    step = SIDE + WALL
    for row in range(ROWS):
        for column in range(COLUMNS):
            x, z, name = column * step, row * step, f"{row} {column}"
            room.place(f"Room {name}", shells[(row + column) % 3], at=(x, 0, z))
            room.place(f"Block {name}", blocks, at=(x + 0.3, GAP, z - 0.5), turn=25)
            room.place(f"Tumbler {name}", tumbler, at=(x + 0.3, 0.6 + 2 * GAP, z - 0.5))
            room.point(f"Lamp {name}", (x - 0.5, 2.1, z - 0.3), 40, (1, 0.85, 0.65), 0.05)
    x, z = SEEN[1] * step, SEEN[0] * step
    room.camera((x - 0.5, 1.5, z + 1.4), (x + 0.25, 0.75, z - 0.6), math.radians(55))


if __name__ == "__main__":
    made = Room()
    build(made)
    made.write(sys.argv[1])
