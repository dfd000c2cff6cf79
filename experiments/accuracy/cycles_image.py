"""Renders one of the bundled scenes by Cycles on one thread, matt surfaces as glTF means them.

    blender -b --factory-startup --python cycles_image.py -- SCENE.py IMAGE.pfm SAMPLES SIZE SEED

Prints the processor's seconds that rendering took.
"""

import os
import pathlib
import sys
import tempfile
import time

import bpy
import numpy

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "bench"))
import cycles_reference


def change_material(material):
    inputs = material.node_tree.nodes["Principled BSDF"].inputs
    if max(inputs["Emission"].default_value[:3]) * inputs["Emission Strength"].default_value > 0:
        cycles_reference.shine_forwards_only(material)
    elif inputs["Metallic"].default_value == 0 and inputs["Transmission"].default_value == 0:
        cycles_reference.make_lambert(material)


def write_pfm(rendered, path):
    image = bpy.data.images.load(rendered)
    image.colorspace_settings.name = "Linear"
    width, height = image.size
    numbers = numpy.array(image.pixels[:], dtype="<f4").reshape(height, width, 4)[:, :, :3]
    with open(path, "wb") as file:
        file.write(f"PF\n{width} {height}\n-1.0\n".encode())
        file.write(numbers.tobytes())


def main():
    script, image, samples, size, seed = sys.argv[sys.argv.index("--") + 1:]
    cycles_reference.build_scene(script)
    for material in bpy.data.materials:
        if material.node_tree is not None:
            change_material(material)
    with tempfile.TemporaryDirectory() as folder:
        rendered = os.path.join(folder, "image.exr")
        cycles_reference.set_up_cycles(int(samples), rendered)
        scene = bpy.context.scene
        scene.render.resolution_x = scene.render.resolution_y = int(size)
        scene.render.threads_mode, scene.render.threads = "FIXED", 1
        scene.cycles.device, scene.cycles.seed = "CPU", int(seed)
        begun = time.process_time()
        bpy.ops.render.render(write_still=True)
        print(f"processor seconds: {time.process_time() - begun:.3f}")
        write_pfm(rendered, image)


main()
