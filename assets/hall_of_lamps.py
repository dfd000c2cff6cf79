"""Builds hall_of_lamps.glb: a long hall with 120 small glowing panels and 120 point lamps, by Python alone.

    python3 assets/hall_of_lamps.py FILE
"""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

# pylint: disable=wrong-import-position
from glb_writer import Glb, quad, sphere

LENGTH, WIDTH, HEIGHT = 30.0, 4.0, 3.0  # m
BAYS, PANELS, LAMPS = 40, (-1.2, 0.0, 1.2), (-1.9, 0.6, 1.9)
COLORS = ((1, 0.55, 0.25), (1, 0.85, 0.6), (0.6, 0.75, 1))


def add_hall(glb):
    wall = glb.material("Wall", (0.7, 0.68, 0.64))
    floor = glb.material("Floor", (0.45, 0.36, 0.28))
    x, y, z = WIDTH / 2, HEIGHT, -LENGTH
    glb.mesh("Floor", floor, quad((-x, 0, 0), (2 * x, 0, 0), (0, 0, z)))
    glb.mesh("Ceiling", wall, quad((-x, y, z), (2 * x, 0, 0), (0, 0, -z)))
    glb.mesh("Left", wall, quad((-x, 0, 0), (0, 0, z), (0, y, 0)))
    glb.mesh("Right", wall, quad((x, 0, z), (0, 0, -z), (0, y, 0)))
    glb.mesh("End", wall, quad((-x, 0, z), (2 * x, 0, 0), (0, y, 0)))
    for i in range(8):
        ball = sphere((-1 + 2 * (i % 2), 0.4, -2 - 3.5 * i), 0.4, 24, 12)
        glb.mesh(f"Ball {i}", wall, ball)


def joined(shapes):
    """One shape of several."""
    positions, normals, uvs, faces = [], [], [], []
    for shape in shapes:
        faces += [tuple(len(positions) + i for i in face) for face in shape[3]]
        positions += shape[0]
        normals += shape[1]
        uvs += shape[2]
    return positions, normals, uvs, faces


def middle_of_bay(bay, shift):
    return -LENGTH * (bay + shift) / BAYS


def add_panels(glb):
    for i, color in enumerate(COLORS):
        glowing = glb.material(f"Panel {i}", (0, 0, 0), emissiveFactor=color, extensions={
            "KHR_materials_emissive_strength": {"emissiveStrength": 12}})
        panels = [quad((x - 0.08, HEIGHT - 0.02, middle_of_bay(bay, 0.5) - 0.08), (0.16, 0, 0),
                       (0, 0, 0.16))
                  for bay in range(BAYS) for row, x in enumerate(PANELS) if (bay + row) % 3 == i]
        glb.mesh(f"Panels {i}", glowing, joined(panels))


def add_lamps(glb):
    lights = [{"type": "point", "color": list(color), "intensity": 683 * 0.1} for color in COLORS]
    glb.root["extensions"] = {"KHR_lights_punctual": {"lights": lights}}
    glb.root["extensionsUsed"].append("KHR_lights_punctual")
    for bay in range(BAYS):
        for row, x in enumerate(LAMPS):
            glb.node(f"Lamp {bay} {row}", translation=[x, 0.25 + 0.4 * row, middle_of_bay(bay, 0.25)],
                     extensions={"KHR_lights_punctual": {"light": (bay + row) % 3}})


def build(path):
    glb = Glb()
    add_hall(glb)
    add_panels(glb)
    add_lamps(glb)
    glb.root["cameras"] = [{"type": "perspective", "name": "Camera", "perspective": {
        "yfov": 0.85, "aspectRatio": 1.5, "znear": 0.01}}]
    glb.node("Camera", camera=0, translation=[0.3, 1.5, 1.0])
    glb.write(path)


if __name__ == "__main__":
    build(sys.argv[1])
