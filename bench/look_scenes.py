"""Makes scenes that tell the looks of Blender and glTF apart, and exports them as a user would.

    blender -b --factory-startup --python bench/look_scenes.py -- FOLDER

Writes spots, coats, metals, lacquer, tinted_glass, sun, window, textures, coarse_textures and plaster
as .glb.
Metres; Blender's axes (z up).
"""

import math
import os
import sys

import bpy
import numpy

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.join(ROOT, "assets"))
from modelling import principled

numpy.bool = bool  # the exporter of Debian's Blender still uses a name that Debian's numpy has dropped

GREY = (0.6, 0.6, 0.6)


def material(name, colour=GREY, **inputs):
    return principled(name, colour, **inputs)


def put(made, place, surface):
    item = bpy.context.object
    item.location = place
    item.data.materials.append(surface)
    item.name = made
    return item


def plane(name, place, size, surface, turn=(0, 0, 0)):
    bpy.ops.mesh.primitive_plane_add(size=size)
    item = put(name, place, surface)
    item.rotation_euler = turn
    return item


def ball(name, place, radius, surface):
    bpy.ops.mesh.primitive_uv_sphere_add(radius=radius, segments=48, ring_count=24)
    bpy.ops.object.shade_smooth()
    return put(name, place, surface)


def box(name, place, size, surface):
    bpy.ops.mesh.primitive_cube_add(size=1)
    item = put(name, place, surface)
    item.scale = size
    return item


def light(name, kind, place, power, turn=(0, 0, 0), **values):
    data = bpy.data.lights.new(name, kind)
    data.energy = power
    for key, value in values.items():
        setattr(data, key, value)
    item = bpy.data.objects.new(name, data)
    item.location, item.rotation_euler = place, turn
    bpy.context.collection.objects.link(item)


def camera(place, turn):
    data = bpy.data.cameras.new("camera")
    item = bpy.data.objects.new("camera", data)
    item.location, item.rotation_euler = place, turn
    bpy.context.collection.objects.link(item)
    bpy.context.scene.camera = item


def studio(floor=None):
    """A floor and a back wall, seen from the front."""
    matte = material("matte", Roughness=0.9, Specular=0.0)
    plane("floor", (0, 0, 0), 8, floor or matte)
    plane("wall", (0, 3, 0), 8, matte, (math.pi / 2, 0, 0))
    camera((0, -6, 2), (math.radians(77), 0, 0))


def panel(power=8.0):
    shining = material("panel", (0, 0, 0), Specular=0.0, Emission=(1, 1, 1, 1),
                       Emission_Strength=power)
    plane("panel", (0, -1, 4), 2, shining)


def row(make):
    """Five balls of rising roughness."""
    for i, roughness in enumerate((0.05, 0.2, 0.4, 0.7, 1.0)):
        ball(f"ball {i}", (-2 + i, 0.5, 0.45), 0.45, make(f"ball {i}", roughness))


def spots():
    studio(material("floor", Roughness=0.8, Specular=0.0))
    for i, (blend, size) in enumerate(((0.0, 30), (0.15, 45), (0.5, 60), (1.0, 50))):
        light(f"spot {i}", "SPOT", (-2.2 + 1.5 * i, -0.5, 2.5), 60, (0.15 * i, 0, 0),
              spot_blend=blend, spot_size=math.radians(size))
    light("wide", "SPOT", (0, -2, 3.5), 80, (-0.2, 0.1, 0), spot_blend=0.7,
          spot_size=math.radians(150))


def coats():
    studio(material("floor", (0.3, 0.3, 0.35), Roughness=0.3))
    row(lambda name, roughness: material(name, (0.7, 0.15, 0.1), Roughness=roughness))
    panel()


def metals():
    studio()
    row(lambda name, roughness: material(name, (0.9, 0.6, 0.3), Metallic=1.0, Roughness=roughness))
    panel()


def lacquer():
    studio()
    row(lambda name, roughness: material(name, (0.1, 0.3, 0.6), Roughness=0.6, Clearcoat=1.0,
                                         Clearcoat_Roughness=roughness))
    panel()


def absorbing(name, colour, density):
    made = material(name, (1, 1, 1), Transmission=1.0, Roughness=0.0, IOR=1.45)
    tree = made.node_tree
    volume = tree.nodes.new("ShaderNodeVolumeAbsorption")
    volume.inputs["Color"].default_value = (*colour, 1)
    volume.inputs["Density"].default_value = density
    tree.links.new(volume.outputs[0], tree.nodes["Material Output"].inputs["Volume"])
    group = bpy.data.node_groups.new("glTF Material Output", "ShaderNodeTree")
    group.inputs.new("NodeSocketFloat", "Thickness")
    node = tree.nodes.new("ShaderNodeGroup")
    node.node_tree = group
    node.inputs["Thickness"].default_value = 1.0
    return made


def tinted_glass():
    studio()
    ball("green", (-1.6, 0.5, 0.6), 0.6, absorbing("green", (0.2, 0.8, 0.4), 1.5))
    ball("amber", (0, 0.5, 0.6), 0.6, absorbing("amber", (0.9, 0.5, 0.1), 3.0))
    ball("tinted", (1.6, 0.5, 0.6), 0.6, material("tinted", (0.8, 0.4, 0.4), Transmission=1.0,
                                                  Roughness=0.0, IOR=1.45))
    panel()


def sun():
    studio(material("floor", (0.5, 0.45, 0.3), Roughness=0.5))
    box("block", (-1, 0.5, 0.5), (1, 1, 1), material("block", (0.8, 0.8, 0.8), Roughness=0.5))
    ball("ball", (1, 0, 0.6), 0.6, material("ball", (0.2, 0.4, 0.8), Roughness=0.4))
    light("sun", "SUN", (0, 0, 5), 3, (0.7, 0.4, 0))


def window():
    """A room that the sun enters through a pane of solid glass; a panel lights it too."""
    plaster = material("plaster", (0.75, 0.72, 0.68), Roughness=0.8)
    plane("floor", (0, 0, 0), 4, material("floor", (0.4, 0.3, 0.2), Roughness=0.4))
    plane("back", (0, 2, 1.25), 4, plaster, (math.pi / 2, 0, 0))
    plane("left", (-2, 0, 2), 4, plaster, (0, math.pi / 2, 0))
    box("above", (2, 0, 2.3), (0.1, 4, 0.4), plaster)
    box("below", (2, 0, 0.4), (0.1, 4, 0.8), plaster)
    box("pane", (2, 0, 1.45), (0.02, 4, 1.3), material("pane", (1, 1, 1), Transmission=1.0,
                                                       Roughness=0.0, IOR=1.45))
    plane("ceiling", (0, 0, 2.5), 4, plaster)
    light("sun", "SUN", (4, 0, 4), 2, (0, 1.1, 0))
    light("lamp", "POINT", (-0.5, -0.5, 2.2), 40)
    camera((0.3, -5.2, 1.3), (math.radians(90), 0, 0))


def textured(name, colours, size):
    """A chequer of 8x8 fields of two colours, size x size pixels, packed into the file."""
    image = bpy.data.images.new(name, size, size)
    ramp = numpy.indices((size, size)).sum(axis=0) // (size // 8) % 2
    pixels = numpy.ones((size, size, 4), dtype=numpy.float32)
    pixels[:, :, :3] = numpy.array(colours, dtype=numpy.float32)[ramp]
    image.pixels = pixels.ravel()
    image.pack()
    made = material(name, Roughness=0.5)
    node = made.node_tree.nodes.new("ShaderNodeTexImage")
    node.image = image
    made.node_tree.links.new(node.outputs["Color"],
                             made.node_tree.nodes["Principled BSDF"].inputs["Base Color"])
    return made


def textures(size=512):
    studio(textured("chequer", ((0.8, 0.2, 0.1), (0.2, 0.2, 0.7)), size))
    ball("globe", (0, 0.5, 0.8), 0.8, textured("globe", ((0.9, 0.9, 0.9), (0.1, 0.4, 0.1)), size))
    light("lamp", "POINT", (1.5, -2, 3), 150)
    panel(3.0)


def coarse_textures():
    """Pixels of 12 cm: a quarter of the area lies between two colours, where filters differ."""
    textures(64)


def plaster():
    """A room of white plaster, open towards the camera: light meets many coated walls."""
    white = material("plaster", (0.85, 0.85, 0.85), Roughness=0.9)
    for name, place, turn in (("floor", (0, 0, 0), (0, 0, 0)), ("ceiling", (0, 0, 3), (0, 0, 0)),
                              ("back", (0, 1.5, 1.5), (math.pi / 2, 0, 0)),
                              ("left", (-1.5, 0, 1.5), (0, math.pi / 2, 0)),
                              ("right", (1.5, 0, 1.5), (0, math.pi / 2, 0))):
        plane(name, place, 3, white, turn)
    box("block", (-0.4, 0.3, 0.6), (0.8, 0.8, 1.2), white)
    light("lamp", "POINT", (0.6, -0.6, 2.2), 60)
    camera((0, -5, 1.5), (math.pi / 2, 0, 0))


def main():
    folder = sys.argv[sys.argv.index("--") + 1]
    os.makedirs(folder, exist_ok=True)
    for scene in (spots, coats, metals, lacquer, tinted_glass, sun, window, textures,
                  coarse_textures, plaster):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        bpy.context.scene.render.resolution_x, bpy.context.scene.render.resolution_y = 640, 480
        scene()
        bpy.ops.export_scene.gltf(filepath=os.path.join(os.path.abspath(folder),
                                                        scene.__name__ + ".glb"),
                                  export_cameras=True, export_lights=True, export_apply=True)


main()
