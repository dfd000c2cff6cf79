"""Builds cornell.glb: a room with a glass sphere, a mirror sphere and a block under a lamp.

    blender -b --factory-startup --python assets/cornell.py -- assets/cornell.glb

Metres; Blender's axes (z up). The room is 2 m wide, deep and high, open towards the camera.
"""

import math
import sys

import bpy

SPHERE_SEGMENTS, SPHERE_RINGS = 64, 32


def principled(name, color, **inputs):
    """A Principled BSDF; inputs are named as Blender names them, with _ for a space."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    shader = material.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*color, 1.0)
    for key, value in inputs.items():
        shader.inputs[key.replace("_", " ")].default_value = value
    return material


def matte(name, color):
    """Purely diffuse: no dielectric coat."""
    return principled(name, color, Specular=0.0, Roughness=1.0)


def add_polygons(name, vertices, polygons, materials):
    """polygons: (material index, corners), counter-clockwise from the front."""
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(vertices, [], [corners for _, corners in polygons])
    for material in materials:
        mesh.materials.append(material)
    for polygon, (material, _) in zip(mesh.polygons, polygons):
        polygon.material_index = material
    placed = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(placed)
    return placed


def add_room(white, red, green):
    vertices = [(x, y, z) for z in (0, 2) for y in (-1, 1) for x in (-1, 1)]
    polygons = [
        (0, (0, 1, 3, 2)),  # floor
        (0, (4, 6, 7, 5)),  # ceiling
        (0, (2, 3, 7, 6)),  # back
        (1, (0, 2, 6, 4)),  # left
        (2, (1, 5, 7, 3)),  # right
    ]
    add_polygons("Room", vertices, polygons, [white, red, green])


def add_block(material):
    """Turned about its upright axis; a unit cube with the rest in the object's transform."""
    vertices = [(x, y, z) for z in (0, 1) for y in (-0.5, 0.5) for x in (-0.5, 0.5)]
    sides = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6)]
    block = add_polygons("Block", vertices, [(0, corners) for corners in sides], [material])
    block.location = (0.48, 0.4, 0)
    block.rotation_euler = (0, 0, math.radians(24))
    block.scale = (0.5, 0.5, 1.0)


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
    sphere = add_polygons(name, sphere_vertices(radius), sphere_polygons(), [material])
    sphere.data.polygons.foreach_set("use_smooth", [True] * len(sphere.data.polygons))
    sphere.location = (x, y, radius)


def add_lamp():
    """Just below the ceiling; lights downwards only."""
    emission = {"Emission": (1.0, 0.86, 0.68, 1.0), "Emission_Strength": 16.0}
    material = principled("Lamp", (0, 0, 0), Specular=0.0, Roughness=1.0, **emission)
    material.use_backface_culling = True
    corners = [(-0.28, -0.22, 1.99), (-0.28, 0.22, 1.99), (0.28, 0.22, 1.99), (0.28, -0.22, 1.99)]
    add_polygons("Lamp", corners, [(0, (0, 1, 2, 3))], [material])


def add_camera():
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    camera.data.lens = 50.0
    camera.location = (0, -3.7, 1.0)
    camera.rotation_euler = (math.radians(90), 0, 0)
    bpy.context.collection.objects.link(camera)
    scene = bpy.context.scene
    scene.camera = camera
    scene.render.resolution_x = scene.render.resolution_y = 512


def main():
    output = sys.argv[sys.argv.index("--") + 1]
    bpy.ops.wm.read_factory_settings(use_empty=True)
    white = matte("White", (0.74, 0.74, 0.72))
    red = matte("Red", (0.6, 0.07, 0.05))
    green = matte("Green", (0.12, 0.46, 0.1))
    add_room(white, red, green)
    add_block(matte("Ochre", (0.72, 0.55, 0.3)))
    mirror = principled("Mirror", (0.95, 0.95, 0.95), Metallic=1.0, Roughness=0.0)
    glass = principled("Glass", (1, 1, 1), Transmission=1.0, Roughness=0.0, IOR=1.5)
    add_sphere("Mirror sphere", 0.4, -0.45, 0.3, mirror)
    add_sphere("Glass sphere", 0.32, 0.22, -0.42, glass)
    add_lamp()
    add_camera()
    bpy.ops.export_scene.gltf(
        filepath=output, export_format="GLB", export_cameras=True, export_lights=True)


main()
