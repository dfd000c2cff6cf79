"""Builds cornell.glb: a room with a glass sphere, a mirror sphere and a block under a lamp.

    blender -b --factory-startup --python assets/cornell.py -- assets/cornell.glb
"""

import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

# pylint: disable=wrong-import-position
from cornell_box import add_block, add_camera, add_lamp, add_room
from modelling import add_mesh, build, glass, matte, mirror

SPHERE_SEGMENTS, SPHERE_RINGS = 64, 32


def sphere_vertices(radius):
    """South pole, rings upwards, north pole."""
    vertices = [(0, 0, -radius)]
    for ring in range(1, SPHERE_RINGS):
        latitude = math.pi * (ring / SPHERE_RINGS - 0.5)
        across = radius * math.cos(latitude)
        for segment in range(SPHERE_SEGMENTS):
            angle = 2 * math.pi * segment / SPHERE_SEGMENTS
            z = radius * math.sin(latitude)
            vertices.append((across * math.cos(angle), across * math.sin(angle), z))
    return vertices + [(0, 0, radius)]


def sphere_polygons():
    def at(ring, segment):
        return 1 + (ring - 1) * SPHERE_SEGMENTS + segment % SPHERE_SEGMENTS

    last = SPHERE_RINGS - 1
    polygons = []
    for i in range(SPHERE_SEGMENTS):
        polygons.append((0, (0, at(1, i + 1), at(1, i))))
        polygons.append((0, (at(last, i), at(last, i + 1), at(last + 1, 0))))
        for ring in range(1, last):
            corners = at(ring, i), at(ring, i + 1), at(ring + 1, i + 1), at(ring + 1, i)
            polygons.append((0, corners))
    return polygons


def add_sphere(name, radius, x, y, material):
    """Smooth shaded, standing on the floor.  Blender's own spheres have faces in random order."""
    sphere = add_mesh(name, sphere_vertices(radius), sphere_polygons(), [material], smooth=True)
    sphere.location = (x, y, radius)


def add_scene():
    add_room(matte("White", (0.74, 0.74, 0.72)))
    add_block("Block", matte("Ochre", (0.72, 0.55, 0.3)), (0.48, 0.4), 24, (0.5, 0.5, 1.0))
    add_sphere("Mirror sphere", 0.4, -0.45, 0.3, mirror(color=(0.95, 0.95, 0.95)))
    add_sphere("Glass sphere", 0.32, 0.22, -0.42, glass())
    add_lamp()
    add_camera()


build(add_scene)
