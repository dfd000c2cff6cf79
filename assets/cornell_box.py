"""The room, lamp and camera of the Cornell boxes.

Metres; Blender's axes (z up).  The room is 2 m wide, deep and high, open towards the camera.
"""

import math

import bpy

from modelling import add_mesh, glowing, matte


def add_room(white):
    red = matte("Red", (0.6, 0.07, 0.05))
    green = matte("Green", (0.12, 0.46, 0.1))
    vertices = [(x, y, z) for z in (0, 2) for y in (-1, 1) for x in (-1, 1)]
    polygons = [
        (0, (0, 1, 3, 2)),  # floor
        (0, (4, 6, 7, 5)),  # ceiling
        (0, (2, 3, 7, 6)),  # back
        (1, (0, 2, 6, 4)),  # left
        (2, (1, 5, 7, 3)),  # right
    ]
    add_mesh("Room", vertices, polygons, [white, red, green])


def add_block(name, material, at, turned_deg, size):
    """Standing on the floor, turned about its upright axis; a unit cube with the rest in the object's
    transform."""
    vertices = [(x, y, z) for z in (0, 1) for y in (-0.5, 0.5) for x in (-0.5, 0.5)]
    sides = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6)]
    block = add_mesh(name, vertices, [(0, corners) for corners in sides], [material])
    block.location = (*at, 0)
    block.rotation_euler = (0, 0, math.radians(turned_deg))
    block.scale = size


def add_lamp():
    """Just below the ceiling; lights downwards only."""
    material = glowing("Lamp", (1.0, 0.86, 0.68), 16.0)
    corners = [(-0.28, -0.22, 1.99), (-0.28, 0.22, 1.99), (0.28, 0.22, 1.99), (0.28, -0.22, 1.99)]
    add_mesh("Lamp", corners, [(0, (0, 1, 2, 3))], [material])


def add_camera():
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    camera.data.lens = 50.0
    camera.location = (0, -3.7, 1.0)
    camera.rotation_euler = (math.radians(90), 0, 0)
    bpy.context.collection.objects.link(camera)
    scene = bpy.context.scene
    scene.camera = camera
    scene.render.resolution_x = scene.render.resolution_y = 512
