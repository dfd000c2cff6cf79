#!/usr/bin/env python3
"""Writes a room of many faces in which one ball of few moves, or the camera, for bench/frames.py.

    bench/moving_room.py FILE.glb [STATUES [ball|camera]]

Each statue has 40,000 faces; there are 9 unless another number is asked for.
"""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "assets"))
from glb_writer import Glb, quad, sphere  # noqa: E402

SIDE = 10.0


def statue():
    """A closed surface with bumps and hollows, 1.2 m high, about its middle."""
    positions, normals, uvs, faces = sphere((0, 0, 0), 1.0, 200, 101)
    bumped = []
    for x, y, z in positions:
        turn = math.atan2(x, z)
        r = 0.4 + 0.06 * math.sin(9 * turn) * math.sin(11 * y) * (1 - y * y)
        bumped.append((r * x, 1.5 * r * y, r * z))
    return bumped, normals, uvs, faces


def main(path, statues="9", mover="ball"):
    glb = Glb()
    wall = glb.material("Plaster", (0.7, 0.7, 0.7))
    half = SIDE / 2
    for name, corner, right, up in (
            ("Floor", (-half, 0, half), (SIDE, 0, 0), (0, 0, -SIDE)),
            ("Ceiling", (-half, 4, -half), (SIDE, 0, 0), (0, 0, SIDE)),
            ("Back", (-half, 0, -half), (SIDE, 0, 0), (0, 4, 0)),
            ("Left", (-half, 0, half), (0, 0, -SIDE), (0, 4, 0)),
            ("Right", (half, 0, -half), (0, 0, SIDE), (0, 4, 0))):
        glb.mesh(name, wall, quad(corner, right, up))
    lamp = glb.material("Lamp", (0, 0, 0), emissiveFactor=[1, 1, 1],
                        extensions={"KHR_materials_emissive_strength": {"emissiveStrength": 20}})
    glb.mesh("Lamp", lamp, quad((-1, 3.9, -1), (2, 0, 0), (0, 0, 2)))
    glb.mesh("Statue 1", glb.material("Marble", (0.8, 0.75, 0.7)), statue())
    mesh = len(glb.root["meshes"]) - 1
    count = int(statues)
    across = math.ceil(math.sqrt(count))
    place = [(i % across + 0.5 - across / 2) * (SIDE - 2) / across for i in range(count)]
    depth = [(i // across + 0.5 - across / 2) * (SIDE - 2) / across for i in range(count)]
    glb.root["nodes"][-1]["translation"] = [place[0], 0.65, depth[0]]
    for i in range(1, count):
        glb.node(f"Statue {i + 1}", mesh=mesh, translation=[place[i], 0.65, depth[i]])
    glb.mesh("Ball", glb.material("Rubber", (0.8, 0.2, 0.2)), sphere((0, 0, 0), 0.25))
    camera = {"type": "perspective", "perspective": {"yfov": 0.8, "aspectRatio": 1.5, "znear": 0.1}}
    glb.root["cameras"] = [camera]
    glb.node("Camera", camera=0, translation=[0, 2.2, 9])
    ways = {"ball": ((-4.4, 2, 4.4), (4.4, 0.25, 4.4)), "camera": ((0, 2.2, 9), (2, 1.5, 7))}
    glb.animate(mover.capitalize(), translation=("LINEAR", (0, 1), ways[mover]))
    glb.write(path)


if __name__ == "__main__":
    main(*sys.argv[1:])
