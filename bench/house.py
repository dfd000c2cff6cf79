#!/usr/bin/env python3
"""Writes a house of ten furnished rooms in one of which a ball moves, for bench/frames.py.

    bench/house.py FILE.glb [closed|open]

Each room has a light.  Doors are closed unless `open` is asked for, which leaves a doorway between neighbours.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "assets"))
from glb_writer import Glb, box, quad, sphere  # noqa: E402

SIDE, HEIGHT, WALL = 4.0, 2.6, 0.2
DOOR, LINTEL = 0.9, 2.0
ROOMS = 10


def joined(*shapes):
    """One shape of several."""
    positions, normals, uvs, faces = [], [], [], []
    for more in shapes:
        faces += [tuple(corner + len(positions) for corner in face) for face in more[3]]
        for to, part in zip((positions, normals, uvs), more):
            to += part
    return positions, normals, uvs, faces


def wall_across(x, z, into, door):
    """A wall across x that faces along x by the sign of `into`, with a doorway or without."""
    def panel(low, high, bottom, top):
        first = (x, bottom, high if into > 0 else low)
        return quad(first, (0, 0, (low - high) * into), (0, top - bottom, 0))
    half = SIDE / 2
    if not door:
        return panel(z - half, z + half, 0, HEIGHT)
    return joined(panel(z - half, z - DOOR / 2, 0, HEIGHT), panel(z + DOOR / 2, z + half, 0, HEIGHT),
                  panel(z - DOOR / 2, z + DOOR / 2, LINTEL, HEIGHT))


def doorway(x, z):
    """The floor, the sides and the top of a doorway through a wall whose near face is at x."""
    low, high = z - DOOR / 2, z + DOOR / 2
    return joined(quad((x, 0, high), (WALL, 0, 0), (0, 0, -DOOR)),
                  quad((x, LINTEL, low), (WALL, 0, 0), (0, 0, DOOR)),
                  quad((x, 0, low), (WALL, 0, 0), (0, LINTEL, 0)),
                  quad((x + WALL, 0, high), (-WALL, 0, 0), (0, LINTEL, 0)))


def room(glb, number, paint, lamp, wood, open_doors):
    x, half = number * (SIDE + WALL), SIDE / 2
    for name, shape in (
            ("Floor", quad((x - half, 0, half), (SIDE, 0, 0), (0, 0, -SIDE))),
            ("Ceiling", quad((x - half, HEIGHT, -half), (SIDE, 0, 0), (0, 0, SIDE))),
            ("Back", quad((x - half, 0, -half), (SIDE, 0, 0), (0, HEIGHT, 0))),
            ("Front", quad((x + half, 0, half), (-SIDE, 0, 0), (0, HEIGHT, 0))),
            ("Left", wall_across(x - half, 0, 1, open_doors and number > 0)),
            ("Right", wall_across(x + half, 0, -1, open_doors and number + 1 < ROOMS))):
        glb.mesh(f"{name} {number}", paint, shape)
    if open_doors and number + 1 < ROOMS:
        glb.mesh(f"Doorway {number}", paint, doorway(x + half, 0))
    glb.mesh(f"Lamp {number}", lamp, quad((x - 0.4, HEIGHT - 0.05, -0.4), (0.8, 0, 0), (0, 0, 0.8)))
    glb.mesh(f"Table {number}", wood, box((x - 0.6, 0.01, -1.6), (x + 0.6, 0.7, -0.9)))
    glb.mesh(f"Vase {number}", paint, sphere((x, 0.95, -1.25), 0.2))
    glb.mesh(f"Chest {number}", wood, box((x + 0.9, 0.01, 0.8), (x + 1.7, 0.5, 1.4)))


def main(path, doors="closed"):
    glb = Glb()
    paint = glb.material("Paint", (0.7, 0.7, 0.65))
    wood = glb.material("Wood", (0.5, 0.35, 0.2))
    lamp = glb.material("Lamp", (0, 0, 0), emissiveFactor=[1, 1, 1],
                        extensions={"KHR_materials_emissive_strength": {"emissiveStrength": 20}})
    for number in range(ROOMS):
        room(glb, number, paint, lamp, wood, doors == "open")
    glb.mesh("Ball", glb.material("Rubber", (0.8, 0.2, 0.2)), sphere((0, 0, 0), 0.2))
    camera = {"type": "perspective", "perspective": {"yfov": 0.9, "aspectRatio": 1.5, "znear": 0.01}}
    glb.root["cameras"] = [camera]
    glb.node("Camera", camera=0, translation=[0, 1.3, 1.9])
    glb.animate("Ball", translation=("LINEAR", (0, 1), ((-1.2, 0.5, 0.5), (0.8, 1.2, -0.2))))
    glb.write(path)


if __name__ == "__main__":
    main(*sys.argv[1:])
