#!/usr/bin/env python3
"""Writes rooms of docs/candidates.md that were made after preprocess could predict candidates.

    held_back_rooms.py FOLDER

Each has coarse and fine surfaces, one kind of light, and some glass and metal.
"""

import os
import pathlib
import random
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../assets"))

# pylint: disable=wrong-import-position
from glb_writer import Glb, box, quad, sphere

SIZE, HEIGHT = 6.0, 3.0  # m
LIGHTS = ("panel", "points", "spot", "sun", "bulbs")


def grid(corner, right, up, parts):
    """A quad of parts x parts squares."""
    positions, normals, uvs, faces = [], [], [], []
    step = 1 / parts
    for i in range(parts):
        for j in range(parts):
            at = tuple(c + i * step * r + j * step * u for c, r, u in zip(corner, right, up))
            part = quad(at, [step * r for r in right], [step * u for u in up])
            faces += [tuple(len(positions) + k for k in face) for face in part[3]]
            positions += part[0]
            normals += part[1]
            uvs += part[2]
    return positions, normals, uvs, faces


def add_walls(glb, draw, is_open):
    side, up = SIZE / 2, HEIGHT
    walls = {"Floor": ((-side, 0, side), (SIZE, 0, 0), (0, 0, -SIZE)),
             "Left": ((-side, 0, side), (0, 0, -SIZE), (0, up, 0)),
             "Right": ((side, 0, -side), (0, 0, SIZE), (0, up, 0)),
             "Back": ((-side, 0, -side), (SIZE, 0, 0), (0, up, 0))}
    if not is_open:
        walls["Front"] = (side, 0, side), (-SIZE, 0, 0), (0, up, 0)
        walls["Ceiling"] = (-side, up, -side), (SIZE, 0, 0), (0, 0, SIZE)
    for name, wall in walls.items():
        paint = glb.material(name, [draw.uniform(0.3, 0.85) for _ in range(3)])
        glb.mesh(name, paint, grid(*wall, draw.choice((1, 1, 2, 5, 40))))


def materials(glb, draw):
    yield glb.material("Paint", [draw.uniform(0.2, 0.8) for _ in range(3)])
    yield glb.material("Glass", (1, 1, 1), base={"roughnessFactor": 0}, extensions={
        "KHR_materials_transmission": {"transmissionFactor": 1}, "KHR_materials_ior": {"ior": 1.5}})
    yield glb.material("Metal", (0.9, 0.8, 0.6), base={
        "metallicFactor": 1, "roughnessFactor": draw.choice((0, 0.2, 0.6))})
    yield glb.material("Lacquer", (0.3, 0.1, 0.1), base={"roughnessFactor": 0.2}, extensions={
        "KHR_materials_ior": {"ior": 1.5}})


def add_things(glb, draw):
    worn = list(materials(glb, draw))
    for i in range(draw.randint(6, 14)):
        x, z = (draw.uniform(-0.42, 0.42) * SIZE for _ in range(2))
        size = draw.uniform(0.15, 0.5)
        if draw.random() < 0.5:
            shape = sphere((x, size, z), size, *draw.choice(((12, 6), (48, 24))))
        else:
            shape = box((x - size, 0.001, z - size),
                        (x + size, draw.uniform(0.3, 1.6), z + draw.choice((0.03, 1)) * size))
        glb.mesh(f"Thing {i}", draw.choice(worn), shape)


def add_punctual(glb, kind, places, intensity):
    light = {"type": kind, "intensity": intensity, "color": [1, 0.9, 0.8]}
    if kind == "spot":
        light["spot"] = {"innerConeAngle": 0.3, "outerConeAngle": 0.6}
    glb.root["extensions"] = {"KHR_lights_punctual": {"lights": [light]}}
    glb.root["extensionsUsed"].append("KHR_lights_punctual")
    half = 0.5 ** 0.5
    for i, place in enumerate(places):  # they look down
        glb.node(f"{kind} {i}", translation=place, rotation=[-half, 0, 0, half],
                 extensions={"KHR_lights_punctual": {"light": 0}})


def add_lights(glb, draw, kind):
    places = [[draw.uniform(-2, 2), HEIGHT - 0.4, draw.uniform(-2, 2)] for _ in range(4)]
    glowing = {"emissiveFactor": (1, 1, 1), "extensions": {
        "KHR_materials_emissive_strength": {"emissiveStrength": 10}}}
    if kind == "panel":
        glb.mesh("Panel", glb.material("Panel", (0, 0, 0), **glowing),
                 quad((-0.5, HEIGHT - 0.01, -0.3), (1, 0, 0), (0, 0, 0.6)))
    elif kind == "bulbs":
        bulb = glb.material("Bulb", (0, 0, 0), **glowing)
        for i, place in enumerate(places):
            glb.mesh(f"Bulb {i}", bulb, sphere(place, 0.06, 12, 6))
    elif kind == "points":
        add_punctual(glb, "point", places, 2000)
    elif kind == "spot":
        add_punctual(glb, "spot", places[:2], 9000)
    else:
        add_punctual(glb, "directional", [[0, 5, 0]], 9000)


def build(path, kind, seed):
    draw = random.Random(seed)
    glb = Glb()
    add_walls(glb, draw, kind == "sun")
    add_things(glb, draw)
    add_lights(glb, draw, kind)
    glb.root["cameras"] = [{"type": "perspective", "name": "Camera", "perspective": {
        "yfov": 0.9, "aspectRatio": 1.5, "znear": 0.01}}]
    glb.node("Camera", camera=0, translation=[0.2, 1.5, SIZE / 2 - 0.05])
    glb.write(path)


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for number, light in enumerate(LIGHTS * 2):
        build(folder / f"held_{number}_{light}.glb", light, 1000 + number)
