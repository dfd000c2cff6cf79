"""Builds wide_plane.glb: glass and metal on a plane a kilometre wide, below sun and sky.

    python3 assets/wide_plane.py OUT.glb
"""

import math
import os
import sys

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "bench", "scenes"))

# pylint: disable=wrong-import-position
from props import wine_glass
from room_writer import Room
from solids import bevelled_box, circle, lathe, rectangle, tube

GAP = 2e-5  # m; faces must not coincide


def ball(radius, segments):
    angles = [math.pi * (i / segments - 0.5) for i in range(segments + 1)]
    profile = [(0 if i in (0, segments) else radius * math.cos(a), radius * (1 + math.sin(a)))
               for i, a in enumerate(angles)]
    return lathe(profile, 2 * segments)


def build(room):
    room.root["asset"]["generator"] = "hipmap assets/wide_plane.py"
    room.add("Plane", room.matte("Sand", (0.55, 0.47, 0.36)),
             rectangle((-500, 0, 500), (1000, 0, 0), (0, 0, -1000)))
    glass = room.glass("Glass", 1.5)
    room.add("Ball", glass, ball(0.12, 40), at=(-0.2, GAP, 0.05))
    room.add("Wine glass", glass, wine_glass(0.32, 0.08, 0.004, 64, 8)[0], at=(0.12, GAP, -0.12))
    room.add("Ring", room.metal("Brass", (0.91, 0.7, 0.34), 0.05),
             tube(circle(0.16, 96, 0.03 + GAP), 0.03, 32, closed=True), at=(0.2, 0, 0.25))
    room.add("Block", room.matte("Red", (0.65, 0.12, 0.08)), bevelled_box(0.2, 0.25, 0.2, 0.01, 2),
             at=(-0.45, GAP, -0.3), turn=30)
    room.sun("Sun", (-0.5, -0.55, -0.45), 10, (1, 0.94, 0.84), 5)
    room.world((0.5, 0.7, 1.0), 0.5)
    room.camera((0.35, 0.75, 1.6), (-0.02, 0.1, 0.0), math.radians(32))


if __name__ == "__main__":
    made = Room()
    build(made)
    made.write(sys.argv[1])
