"""Renders one of the bundled scenes by Cycles on one thread, matt surfaces as glTF means them.

    blender -b --factory-startup --python cycles_image.py -- SCENE.py IMAGE.pfm SAMPLES SIZE SEED

Prints the processor's seconds that rendering took.
"""

import pathlib
import sys

import bpy

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "bench"))
import cycles_reference


def change_material(material):
    inputs = material.node_tree.nodes["Principled BSDF"].inputs
    if max(inputs["Emission"].default_value[:3]) * inputs["Emission Strength"].default_value > 0:
        cycles_reference.shine_forwards_only(material)
    elif inputs["Metallic"].default_value == 0 and inputs["Transmission"].default_value == 0:
        cycles_reference.make_lambert(material)


def main():
    script, image, samples, size, seed = sys.argv[sys.argv.index("--") + 1:]
    cycles_reference.build_scene(script)
    for material in bpy.data.materials:
        if material.node_tree is not None:
            change_material(material)
    cycles_reference.render_timed(image, (int(size), int(size)), int(samples), int(seed), 1)


main()
