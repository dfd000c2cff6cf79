"""Renders one scene with all render passes by hipmap and by Cycles:

    blender --python passes_inside.py -- ADDON.zip OUT

Writes hipmap.exr and cycles.exr, multi-layer, layers.exr by `render --layers`, and border.exr,
where hipmap renders a part; baked.exr and baked_cycles.exr of nodes that hipmap cannot express, and
baked.json on them.
"""

import json
import os
import shutil
import sys

import bpy
from mathutils import Euler

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import install_addon

ARCHIVE, OUT = sys.argv[sys.argv.index("--") + 1:]
SWITCHES = ("use_pass_z", "use_pass_position", "use_pass_normal", "use_pass_object_index",
            "use_pass_material_index", "use_pass_diffuse_color")


def material(name, index, colour, metallic):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    made.pass_index = index
    inputs = made.node_tree.nodes["Principled BSDF"].inputs
    inputs["Base Color"].default_value = (*colour, 1)
    inputs["Metallic"].default_value = metallic
    inputs["Roughness"].default_value = 0.5
    return made


def add(make, index, of, **options):
    make(**options)
    item = bpy.context.object
    item.pass_index = index
    item.data.materials.append(of)
    return item


def build():
    """A floor at z = 0.5, a cube and a ball on it, and an instance of the cube."""
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    scene = bpy.context.scene
    mesh = bpy.ops.mesh
    add(mesh.primitive_plane_add, 7, material("Floor", 5, (0.8, 0.4, 0.2), 0), size=6,
        location=(0, 0, 0.5))
    cube = add(mesh.primitive_cube_add, 3, material("Part metal", 0, (0.5, 0.6, 0.7), 0.25),
               size=1, location=(-1, 0, 1), rotation=(0, 0, 0.4))
    twin = bpy.data.objects.new("Twin", cube.data)
    twin.pass_index, twin.location = 300, (0.5, 1.5, 1.2)
    scene.collection.objects.link(twin)
    add(mesh.primitive_uv_sphere_add, 0, material("Metal", 12, (0.9, 0.8, 0.1), 1), radius=0.6,
        location=(1.2, -0.4, 1.1))
    bpy.ops.object.shade_smooth()
    bpy.ops.object.camera_add(location=(0.5, -6, 3), rotation=Euler((1.2, 0.05, 0.1)))
    scene.camera = bpy.context.object
    scene.camera.data.shift_x = 0.05
    bpy.ops.object.light_add(type="SUN", location=(0, 0, 5))
    scene.render.resolution_x, scene.render.resolution_y = 48, 32
    return scene


def veined():
    """Noise and a ramp, by the coordinates that the object's box generates."""
    made = material("Veined", 1, (0, 0, 0), 0)
    tree = made.node_tree
    noise, ramp = tree.nodes.new("ShaderNodeTexNoise"), tree.nodes.new("ShaderNodeValToRGB")
    noise.inputs["Scale"].default_value = 2
    ramp.color_ramp.elements[0].position, ramp.color_ramp.elements[1].position = 0.4, 0.6
    ramp.color_ramp.elements[0].color = (0.8, 0.1, 0.05, 1)
    ramp.color_ramp.elements[1].color = (0.1, 0.2, 0.7, 1)
    tree.links.new(noise.outputs["Fac"], ramp.inputs["Fac"])
    for socket, output in (("Base Color", ramp.outputs["Color"]),
                           ("Roughness", noise.outputs["Fac"])):
        tree.links.new(output, tree.nodes["Principled BSDF"].inputs[socket])
    return made


def tiled():
    """A checker in a group, by a UV map that repeats."""
    group = bpy.data.node_groups.new("Tiles", "ShaderNodeTree")
    group.inputs.new("NodeSocketVector", "At")
    group.outputs.new("NodeSocketShader", "Shader")
    source, sink = group.nodes.new("NodeGroupInput"), group.nodes.new("NodeGroupOutput")
    checker = group.nodes.new("ShaderNodeTexChecker")
    shader = group.nodes.new("ShaderNodeBsdfDiffuse")
    checker.inputs["Color1"].default_value = (0.9, 0.7, 0.6, 1)
    checker.inputs["Color2"].default_value = (0.1, 0.3, 0.2, 1)
    checker.inputs["Scale"].default_value = 6
    group.links.new(source.outputs[0], checker.inputs["Vector"])
    group.links.new(checker.outputs["Color"], shader.inputs["Color"])
    group.links.new(shader.outputs[0], sink.inputs[0])
    made = material("Tiled", 2, (0, 0, 0), 0)
    tree = made.node_tree
    node, place = tree.nodes.new("ShaderNodeGroup"), tree.nodes.new("ShaderNodeTexCoord")
    node.node_tree = group
    tree.links.new(place.outputs["UV"], node.inputs[0])
    tree.links.new(node.outputs[0], tree.nodes["Material Output"].inputs["Surface"])
    return made


def build_baked(scene):
    """The scene with procedural materials; the cube has a modifier."""
    cube, floor = bpy.data.objects["Cube"], bpy.data.objects["Plane"]
    cube.data.materials[0], floor.data.materials[0] = veined(), tiled()
    cube.modifiers.new("Bevel", "BEVEL").width = 0.1
    for loop in floor.data.uv_layers[0].data:
        loop.uv = loop.uv * 1.5
    scene.hipmap.bake, scene.hipmap.bake_size = True, "512"


def counts():
    """How many things Blender's file has."""
    return [len(getattr(bpy.data, kind)) for kind in ("meshes", "materials", "images", "objects")]


def baked_files(folder):
    return sorted(name for name in os.listdir(folder) if name.startswith("baked"))


def baked(scene, folder):
    """Nodes are baked once, and again when they have changed."""
    build_baked(scene)
    before = counts()
    multilayer(scene, "baked")
    made = [baked_files(folder)]
    multilayer(scene, "baked")
    made.append(baked_files(folder))
    with open(os.path.join(OUT, "baked.json"), "w", encoding="utf-8") as file:
        json.dump({"made": made, "counts": [before, counts()]}, file)


def multilayer(scene, name):
    image = scene.render.image_settings
    image.file_format, image.color_depth, image.exr_codec = "OPEN_EXR_MULTILAYER", "32", "ZIP"
    scene.render.filepath = os.path.join(OUT, name + ".exr")
    bpy.ops.render.render(write_still=True)


def check_sockets(scene):
    """The compositor offers the passes before the first render."""
    scene.use_nodes = True
    node = next(one for one in scene.node_tree.nodes if one.type == "R_LAYERS")
    offered = {socket.name for socket in node.outputs if socket.enabled}
    scene.use_nodes = False
    wanted = {"Depth", "Normal", "IndexOB", "DiffCol", "Denoising Albedo", "Map ID", "Noise"}
    assert wanted <= offered, offered


install_addon.install(ARCHIVE, "")
the_scene = build()
view_layer = the_scene.view_layers[0]
view_layer.name = "Main.layer 1"
for switch in SWITCHES:
    setattr(view_layer, switch, True)
install_addon.set_up(OUT)
for switch in ("map_id", "noise", "error", "denoising_albedo"):
    setattr(view_layer.hipmap, switch, True)
check_sockets(the_scene)
multilayer(the_scene, "hipmap")
name = bpy.path.clean_name(f"{the_scene.name}_{view_layer.name}")
files = os.path.join(OUT, name)
shutil.copy(os.path.join(files, "layers.exr"), OUT)
render = the_scene.render
render.use_border, render.use_crop_to_border = True, False
render.border_min_x, render.border_max_x = 0.25, 0.75
render.border_min_y, render.border_max_y = 0, 0.5
multilayer(the_scene, "border")
render.use_border = False
render.engine = "CYCLES"
the_scene.cycles.samples, the_scene.cycles.filter_width = 1, 0.01
the_scene.cycles.use_adaptive_sampling = the_scene.cycles.use_denoising = False
multilayer(the_scene, "cycles")
render.engine = "HIPMAP"
baked(the_scene, files)
render.engine = "CYCLES"
the_scene.cycles.samples, the_scene.cycles.filter_width = 64, 1.5
multilayer(the_scene, "baked_cycles")
