"""Colours after nodes that change them, by Cycles and by the add-on:

    blender --python adjust_inside.py -- BLENDER_FOLDER OUT.exr
"""

import json
import os
import sys

import bpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import build_scene as build

FOLDER, IMAGE = sys.argv[sys.argv.index("--") + 1:]
sys.path.insert(0, FOLDER)
from hipmap import sockets

COLOUR = (0.6, 0.3, 0.2, 1)


def add_node(tree, kind, **inputs):
    node = tree.nodes.new("ShaderNode" + kind)
    for name, value in inputs.items():
        node.inputs[name].default_value = value
    return node


def nodes_of(tree):
    for kelvin in (1500.0, 3000.0, 6500.0, 12000.0):
        yield add_node(tree, "Blackbody", Temperature=kelvin)
    yield add_node(tree, "HueSaturation", Hue=0.7, Saturation=1.3, Value=0.8, Fac=0.9, Color=COLOUR)
    yield add_node(tree, "HueSaturation", Hue=0.1, Saturation=0.4, Value=2, Color=(0.1, 0.1, 0.7, 1))
    yield add_node(tree, "Gamma", Gamma=2.2, Color=COLOUR)
    yield add_node(tree, "BrightContrast", Bright=0.1, Contrast=0.3, Color=COLOUR)
    yield add_node(tree, "Invert", Fac=0.7, Color=COLOUR)
    ramp = add_node(tree, "ValToRGB", Fac=0.35)
    ramp.color_ramp.elements[0].color = (1, 0, 0.2, 1)
    yield ramp
    yield add_node(tree, "MixRGB", Fac=0.3, Color1=(0.1, 0.5, 0.9, 1), Color2=(0.9, 0.2, 0.1, 1))
    for operation in ("ADD", "SUBTRACT", "MULTIPLY", "POWER", "MINIMUM", "MAXIMUM"):
        node = add_node(tree, "Math")
        node.operation = operation
        node.inputs[0].default_value, node.inputs[1].default_value = 0.8, 0.3
        yield node


def by_cycles():
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(IMAGE)
    pixel = list(image.pixels[:3])
    bpy.data.images.remove(image)
    return pixel


def main():
    scene = build.empty_scene()
    build.set_size(4, 4)
    build.add_camera((0, 0, 5), (0, 0, 0))
    scene.render.engine, scene.render.filepath = "CYCLES", IMAGE
    scene.cycles.samples, scene.cycles.use_denoising = 1, False
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    material = build.node_material("Emitter", "ShaderNodeEmission", Strength=1.0)
    build.add_mesh("plane", "Plane", material, size=50)
    tree = material.node_tree
    colour = next(node for node in tree.nodes if node.type == "EMISSION").inputs["Color"]
    found = []
    for node in list(nodes_of(tree)):
        tree.links.new(node.outputs[0], colour)
        found.append((node.bl_idname, by_cycles(), sockets.follow(colour).numbers()))
    print("colours:", json.dumps(found))


main()
