"""Renders the bundled scene by Cycles, as glTF means it or as Blender does.

    blender -b --factory-startup --python bench/cycles_reference.py -- MODEL OUT.exr SAMPLES [SCENE.glb]

lambert: matt surfaces are Diffuse BSDFs, which is glTF's diffuse reflection; burley: they stay
Principled BSDFs, as a Blender user has them; glossy: lambert with a sphere of white metal of roughness
0.25, a block of 0.5 and frosted glass of 0.3, which is also written to SCENE.glb.
256x256, no clamping, 32 bounces.
"""

import os
import runpy
import sys
import tempfile
import time

import bpy
import numpy


BUNDLED = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "assets", "cornell.py")


def build_scene(script):
    """By a script of assets/, whose file is thrown away."""
    arguments = sys.argv[:]
    with tempfile.TemporaryDirectory() as folder:
        sys.argv = ["blender", "--", os.path.join(folder, "scene.glb")]
        runpy.run_path(script)
    sys.argv = arguments


def make_lambert(material):
    tree = material.node_tree
    principled = tree.nodes["Principled BSDF"]
    diffuse = tree.nodes.new("ShaderNodeBsdfDiffuse")
    diffuse.inputs["Color"].default_value = principled.inputs["Base Color"].default_value
    tree.links.new(diffuse.outputs[0], tree.nodes["Material Output"].inputs["Surface"])


def make_rough(material, roughness):
    material.node_tree.nodes["Principled BSDF"].inputs["Roughness"].default_value = roughness


def add_rough_surfaces():
    """White metals, which reflect all at every angle whatever the Fresnel term, and glass."""
    mirror, glass = bpy.data.materials["Mirror"], bpy.data.materials["Glass"]
    mirror.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = (1, 1, 1, 1)
    rough = mirror.copy()
    rough.name = "Rough"
    bpy.data.objects["Block"].data.materials[0] = rough
    for material, roughness in ((mirror, 0.25), (rough, 0.5), (glass, 0.3)):
        make_rough(material, roughness)


def make_single_scattering(material):
    """Principled BSDF to the node that has the lobe alone: facets by GGX, scattering once."""
    tree = material.node_tree
    principled = tree.nodes["Principled BSDF"]
    kind = "ShaderNodeBsdfGlass" if material.name == "Glass" else "ShaderNodeBsdfGlossy"
    node = tree.nodes.new(kind)
    node.distribution = "GGX"
    node.inputs["Color"].default_value = principled.inputs["Base Color"].default_value
    node.inputs["Roughness"].default_value = principled.inputs["Roughness"].default_value
    if material.name == "Glass":
        node.inputs["IOR"].default_value = principled.inputs["IOR"].default_value
    tree.links.new(node.outputs[0], tree.nodes["Material Output"].inputs["Surface"])


def shine_forwards_only(material):
    """Cycles lets both sides shine; glTF only the front of a single-sided material."""
    tree = material.node_tree
    strength = tree.nodes["Principled BSDF"].inputs["Emission Strength"]
    front = tree.nodes.new("ShaderNodeMath")
    front.operation = "SUBTRACT"
    front.inputs[0].default_value = 1.0
    tree.links.new(tree.nodes.new("ShaderNodeNewGeometry").outputs["Backfacing"], front.inputs[1])
    scaled = tree.nodes.new("ShaderNodeMath")
    scaled.operation = "MULTIPLY"
    scaled.inputs[0].default_value = strength.default_value
    tree.links.new(front.outputs[0], scaled.inputs[1])
    tree.links.new(scaled.outputs[0], strength)


def set_up_cycles(samples, output):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.resolution_x = scene.render.resolution_y = 256
    scene.render.filepath = output
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    cycles = scene.cycles
    cycles.samples = samples
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.blur_glossy = 0
    cycles.pixel_filter_type = "BOX"
    cycles.max_bounces = cycles.diffuse_bounces = 32
    cycles.glossy_bounces = cycles.transmission_bounces = 32


def write_pfm(rendered, path):
    """The image that Blender has written to a file."""
    image = bpy.data.images.load(rendered)
    image.colorspace_settings.name = "Linear"
    width, height = image.size
    numbers = numpy.array(image.pixels[:], dtype="<f4").reshape(height, width, 4)[:, :, :3]
    with open(path, "wb") as file:
        file.write(f"PF\n{width} {height}\n-1.0\n".encode())
        file.write(numbers.tobytes())


def render_timed(image, size, samples, seed, threads):
    """Writes the image, .pfm, and prints the processor's seconds that rendering it took.  threads: 0: all."""
    scene = bpy.context.scene
    with tempfile.TemporaryDirectory() as folder:
        rendered = os.path.join(folder, "image.exr")
        set_up_cycles(samples, rendered)
        scene.render.resolution_x, scene.render.resolution_y = size
        if threads > 0:
            scene.render.threads_mode, scene.render.threads = "FIXED", threads
        scene.cycles.device, scene.cycles.seed = "CPU", seed
        begun = time.process_time()
        bpy.ops.render.render(write_still=True)
        print(f"processor seconds: {time.process_time() - begun:.3f}")
        write_pfm(rendered, image)


def main():
    model, output, samples, *scene = sys.argv[sys.argv.index("--") + 1:]
    build_scene(BUNDLED)
    if model == "glossy":
        add_rough_surfaces()
        bpy.ops.export_scene.gltf(filepath=os.path.abspath(scene[0]), export_cameras=True)
    for material in bpy.data.materials:
        if material.name == "Lamp":
            shine_forwards_only(material)
        elif material.name in ("Glass", "Mirror", "Rough"):
            if model == "glossy":
                make_single_scattering(material)
        elif model != "burley":
            make_lambert(material)
    set_up_cycles(int(samples), os.path.abspath(output))
    bpy.ops.render.render(write_still=True)


if __name__ == "__main__":
    main()
