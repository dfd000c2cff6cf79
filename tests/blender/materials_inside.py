"""Materials of many nodes on one cube each, exported by the add-on:

    blender --python materials_inside.py -- BLENDER_FOLDER OUT.glb
"""

import json
import os
import sys
import time

import bpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import build_scene as build

FOLDER, OUT = sys.argv[sys.argv.index("--") + 1:]
sys.path.insert(0, FOLDER)
from hipmap import frame, scene_export
from hipmap import world as world_export
from hipmap.run import Cancelled


def image(name, colour, colour_space="sRGB"):
    made = bpy.data.images.new(name, 2, 2)
    made.colorspace_settings.name = colour_space
    made.pixels = list(colour) * 4
    made.pack()
    return made


def image_node(tree, picture):
    node = tree.nodes.new("ShaderNodeTexImage")
    node.image = picture
    return node


def link(material, name, output):
    tree = material.node_tree
    tree.links.new(output, tree.nodes["Principled BSDF"].inputs[name])


def with_image(name, socket, picture, output="Color"):
    material = build.matte(name)
    link(material, socket, image_node(material.node_tree, picture).outputs[output])
    return material


def noisy():
    material = build.matte("Noisy", (0.1, 0.2, 0.3))
    tree = material.node_tree
    link(material, "Base Color", tree.nodes.new("ShaderNodeTexNoise").outputs["Color"])
    link(material, "Normal", tree.nodes.new("ShaderNodeBump").outputs[0])
    tree.nodes["Principled BSDF"].inputs["Subsurface"].default_value = 0.5
    return material


def packed():
    """Roughness and metal in two channels of one image, as texture libraries sell them."""
    material = build.matte("Packed")
    tree = material.node_tree
    separate = tree.nodes.new("ShaderNodeSeparateColor")
    node = image_node(tree, image("ORM", (0, 0.25, 0.75, 1), "Non-Color"))
    tree.links.new(node.outputs["Color"], separate.inputs[0])
    link(material, "Roughness", separate.outputs["Green"])
    link(material, "Metallic", separate.outputs["Blue"])
    return material


def two_images():
    material = build.matte("Two images")
    tree = material.node_tree
    for socket, value in (("Roughness", 0.5), ("Metallic", 1.0)):
        picture = image(socket, (value, value, value, 1), "Non-Color")
        link(material, socket, image_node(tree, picture).outputs["Color"])
    return material


def grouped():
    """The colour comes into a group from outside, and out again."""
    group = bpy.data.node_groups.new("Tint", "ShaderNodeTree")
    group.inputs.new("NodeSocketColor", "In")
    group.outputs.new("NodeSocketColor", "Out")
    source, sink = group.nodes.new("NodeGroupInput"), group.nodes.new("NodeGroupOutput")
    mix = group.nodes.new("ShaderNodeMixRGB")
    mix.blend_type, mix.inputs["Fac"].default_value = "MULTIPLY", 1
    mix.inputs["Color2"].default_value = (0.5, 0.5, 0.5, 1)
    group.links.new(source.outputs[0], mix.inputs["Color1"])
    group.links.new(mix.outputs[0], sink.inputs[0])
    material = build.matte("Grouped")
    node = material.node_tree.nodes.new("ShaderNodeGroup")
    node.node_tree = group
    node.inputs[0].default_value = (0.8, 0.4, 0.2, 1)
    link(material, "Base Color", node.outputs[0])
    return material


def painted(cube):
    layer = cube.data.color_attributes.new("Paint", "BYTE_COLOR", "CORNER")
    for value in layer.data:
        value.color = (0.2, 0.4, 0.6, 1)
    material = build.matte("Painted")
    node = material.node_tree.nodes.new("ShaderNodeVertexColor")
    node.layer_name = "Paint"
    for socket in ("Base Color", "Roughness"):
        link(material, socket, node.outputs[0])
    return material


def adjusted(name, socket, picture, node):
    material = build.matte(name)
    tree = material.node_tree
    change = tree.nodes.new(node)
    into = "Fac" if node == "ShaderNodeValToRGB" else "Color"
    tree.links.new(image_node(tree, picture).outputs["Color"], change.inputs[into])
    link(material, socket, change.outputs[0])
    return material, change


def inverted():
    return adjusted("Inverted", "Base Color", image("Orange", (1, 0.25, 0, 1)),
                    "ShaderNodeInvert")[0]


def ramp():
    material, node = adjusted("Ramp", "Roughness", image("Grey", (0.25,) * 3 + (1,), "Non-Color"),
                              "ShaderNodeValToRGB")
    node.color_ramp.elements[0].color, node.color_ramp.elements[1].color = (1,) * 4, (0, 0, 0, 1)
    return material


def grey_number():
    """A number where a colour is meant, for base and emission."""
    material = build.matte("Grey number")
    node = material.node_tree.nodes.new("ShaderNodeValue")
    node.outputs[0].default_value = 0.4
    for socket in ("Base Color", "Emission"):
        link(material, socket, node.outputs[0])
    return material


def paper():
    material = build.node_material("Paper", "ShaderNodeBsdfTranslucent")
    tree = material.node_tree
    node = next(x for x in tree.nodes if x.type == "BSDF_TRANSLUCENT")
    tree.links.new(image_node(tree, image("Print", (0.5, 0.6, 0.7, 1))).outputs["Color"],
                   node.inputs["Color"])
    return material


def mixed(name, factor, first, second):
    """A Mix Shader of two nodes (kind, inputs).  factor: a number, or (kind, output)."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.remove(tree.nodes["Principled BSDF"])
    mix = tree.nodes.new("ShaderNodeMixShader")
    for socket, (kind, inputs) in zip(mix.inputs[1:], (first, second)):
        node = tree.nodes.new("ShaderNodeBsdf" + kind)
        for key, value in inputs.items():
            node.inputs[key].default_value = value
        tree.links.new(node.outputs[0], socket)
    if isinstance(factor, float):
        mix.inputs[0].default_value = factor
    else:
        tree.links.new(tree.nodes.new("ShaderNode" + factor[0]).outputs[factor[1]], mix.inputs[0])
    tree.links.new(mix.outputs[0], tree.nodes["Material Output"].inputs["Surface"])
    return material


def mixtures():
    grey, glossy = ("Diffuse", {"Color": (0.5, 0.5, 0.5, 1)}), ("Glossy", {"Roughness": 0.1})
    yield mixed("Plastic", ("Fresnel", "Fac"), grey, glossy)
    yield mixed("Weighted", ("LayerWeight", "Fresnel"), grey, glossy)
    yield mixed("Facing", ("LayerWeight", "Facing"), grey, glossy)
    yield mixed("Two parts of glass", ("Fresnel", "Fac"), ("Refraction", {"IOR": 1.3}), glossy)
    yield mixed("Curtain", 0.25, grey, ("Translucent", {"Color": (0.2, 0.4, 0.6, 1)}))
    yield mixed("Without shadow", ("LightPath", "Is Shadow Ray"), ("Glass", {}),
                ("Transparent", {}))
    muted = mixed("Muted", 0.5, grey, glossy)
    muted.node_tree.nodes["Mix Shader"].mute = True
    yield muted
    yield build.matte("Skin tone", (0.8, 0.2, 0), Subsurface=0.25, Subsurface_Color=(0.4, 0.6, 0, 1))


def unlinked():
    material = bpy.data.materials.new("No nodes")
    material.use_nodes = False
    material.diffuse_color = (0.3, 0.2, 0.1, 0.5)
    return material


def volume(name, nodes, mix=None):
    """A material of a volume alone: one node (kind, inputs), or more joined by a node of kind
    `mix`."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.remove(tree.nodes["Principled BSDF"])
    made = []
    for kind, inputs in nodes:
        made.append(tree.nodes.new("ShaderNode" + kind))
        for key, value in inputs.items():
            made[-1].inputs[key].default_value = value
    if mix:
        joined = tree.nodes.new("ShaderNode" + mix)
        for socket, node in zip(joined.inputs[-2:], made):
            tree.links.new(node.outputs[0], socket)
        made.append(joined)
    tree.links.new(made[-1].outputs[0], tree.nodes["Material Output"].inputs["Volume"])
    return material


def patchy():
    """A density that varies."""
    material = volume("Patchy", [("VolumeScatter", {})])
    tree = material.node_tree
    tree.links.new(tree.nodes.new("ShaderNodeTexNoise").outputs["Fac"],
                   tree.nodes["Volume Scatter"].inputs["Density"])
    return material


def volumes():
    white = (1, 1, 1, 1)
    yield volume("Mist", [("VolumeAbsorption", {"Color": (0.5, 0.5, 0.5, 1), "Density": 4}),
                          ("VolumeScatter", {"Color": white, "Density": 2, "Anisotropy": 0.3})],
                 "MixShader")
    yield volume("Two ways", [("VolumeScatter", {"Color": white, "Anisotropy": g})
                              for g in (0.6, -0.2)], "AddShader")
    yield volume("Ember", [("VolumePrincipled", {"Color": (0, 0, 0, 1), "Temperature": 1000,
                                                 "Blackbody Intensity": 1})])
    yield patchy()


def with_profile(kind, text):
    """A light with an IES Texture."""
    light = build.add_light("Profile " + kind.title(), kind, 10, shadow_soft_size=0).data
    light.use_nodes = True
    tree = light.node_tree
    node = tree.nodes.new("ShaderNodeTexIES")
    node.ies = text
    node.inputs["Strength"].default_value = 2
    tree.links.new(node.outputs[0], tree.nodes["Emission"].inputs["Strength"])


def profiles():
    text = bpy.data.texts.new("even.ies")
    text.write("IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 2 1 1 2 0 0 0\n1 1 10\n0 180\n0\n100 100\n")
    with_profile("POINT", text)
    with_profile("SPOT", text)
    build.add_light("No file", "POINT", 10).data.use_nodes = True
    tree = bpy.data.lights["No file"].node_tree
    node = tree.nodes.new("ShaderNodeTexIES")
    node.mode, node.filepath = "EXTERNAL", "//missing.ies"
    tree.links.new(node.outputs[0], tree.nodes["Emission"].inputs["Strength"])


def smoking(item):
    item.modifiers.new("Fluid", "FLUID").fluid_type = "DOMAIN"


def hairy():
    ball = build.add_mesh("uv_sphere", "Hairy", build.matte("Skin"), radius=0.2, location=(0, 4, 0))
    ball.modifiers.new("Hair", "PARTICLE_SYSTEM").particle_system.settings.type = "HAIR"


def show_foggy_sky():
    """Prints the greatest value of the environment map of a world with a sky and a volume."""
    world = build.plain_world((0, 0, 0), 2)
    tree = world.node_tree
    picture = tree.nodes.new("ShaderNodeTexEnvironment")
    picture.image = image("Sky", (0.9, 0.9, 0.9, 1), "Non-Color")
    tree.links.new(picture.outputs[0], tree.nodes["Background"].inputs["Color"])
    tree.links.new(tree.nodes.new("ShaderNodeVolumeScatter").outputs[0],
                   tree.nodes["World Output"].inputs["Volume"])
    began = time.monotonic()
    try:
        world_export.bake_at_once(world, OUT + ".exr", lambda: True)
    except Cancelled:
        print("cancelled after:", time.monotonic() - began)
    extras = world_export.world_extras(world, os.path.dirname(OUT))
    sky = bpy.data.images.load(os.path.join(os.path.dirname(OUT), extras["world_hdri"]))
    print("sky:", json.dumps([max(sky.pixels), *extras["medium"]["scattering"]]))


def main():
    build.empty_scene()
    build.add_camera((0, -9, 2), (1.4, 0, 0)).data.dof.use_dof = False
    build.add_light("Narrow", "AREA", 10, spread=0.5)
    red = (1, 0.25, 0, 1)
    makers = [noisy, packed, two_images, grouped, unlinked, inverted, ramp, grey_number,
              paper,
              lambda: with_image("Image", "Base Color", image("Red", red)),
              lambda: with_image("Linear", "Base Color", image("Flat", (0.5, 0.5, 0.5, 1),
                                                               "Non-Color")),
              lambda: with_image("Cut out", "Alpha", image("Mask", (1, 1, 1, 0.5)), "Alpha"),
              lambda: build.node_material("Velvet", "ShaderNodeBsdfVelvet",
                                          Color=(0.1, 0.2, 0.3, 1))]
    for x, make in enumerate(makers):
        build.add_mesh("cube", f"Cube {x}", make(), size=0.8, location=(x - 4, 0, 0))
    cube = build.add_mesh("cube", "Painted cube", None, size=0.8, location=(0, 2, 0))
    cube.data.materials.append(painted(cube))
    for x, material in enumerate(mixtures()):
        build.add_mesh("cube", f"Mixture {x}", material, size=0.8, location=(x - 4, 6, 0))
    for x, material in enumerate(volumes()):
        build.add_mesh("cube", f"Volume {x}", material, size=0.8, location=(x - 4, -2, 0))
    smoking(bpy.data.objects["Volume 0"])
    hairy()
    profiles()
    world = build.plain_world((0.1, 0.2, 0.3))
    tree = world.node_tree
    fog = tree.nodes.new("ShaderNodeVolumeScatter")
    fog.inputs["Density"].default_value = 0.02
    tree.links.new(fog.outputs[0], tree.nodes["World Output"].inputs["Volume"])
    exported = scene_export.export_depsgraph(bpy.context.evaluated_depsgraph_get(), OUT,
                                             frame.picture_of(bpy.context.scene.render))
    print("losses:", json.dumps(exported.losses))
    show_foggy_sky()


main()
