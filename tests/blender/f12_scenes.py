"""Eight small scenes with what Blender's own exporter, or glTF, leaves out.

    blender --python f12_scenes.py -- FOLDER [NAME...]
"""

import math
import os
import sys

import bpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import build_scene as build


def floor_and_camera(location=(0, -7, 4), tilt=1.1):
    build.add_mesh("plane", "Floor", build.matte("Floor"), size=20)
    build.set_size(48, 32)
    return build.add_camera(location, (tilt, 0, 0))


def modifiers():
    """Modifiers with other levels in renders, a hidden cutter, linked duplicates."""
    floor_and_camera()
    build.plain_world((0.3, 0.3, 0.4))
    red = build.matte("Red", (0.8, 0.1, 0.1), Roughness=0.4, Specular=0.5)
    row = build.add_mesh("cube", "Row", red, size=0.8, location=(-2, 0, 0.4))
    row.modifiers.new("Array", "ARRAY").count = 3
    row.modifiers.new("Bevel", "BEVEL").width = 0.1
    head = build.add_mesh("cube", "Rounded", red, size=1, location=(-2, 2, 1))
    subdivision = head.modifiers.new("Subdivision", "SUBSURF")
    subdivision.levels, subdivision.render_levels = 0, 2
    bpy.ops.object.shade_smooth()
    cut = build.add_mesh("cube", "Cut", build.matte("Blue", (0.1, 0.2, 0.8)), size=1,
                         location=(2, 0, 0.6))
    cutter = build.add_mesh("uv_sphere", "Cutter", None, radius=0.6, location=(2, -0.5, 1))
    cutter.hide_render = True
    boolean = cut.modifiers.new("Boolean", "BOOLEAN")
    boolean.object, boolean.operation = cutter, "DIFFERENCE"
    for index in range(2):
        build.add_object(f"Twin {index}", cut.data, (index, 3, 0.5), (0, 0, 0.3)).scale.x = -1
    build.add_light("Key", "POINT", 300, shadow_soft_size=0.3, location=(2, -3, 4))


def geometry_nodes(item, instance):
    """Instances of an object at the vertices of another."""
    tree = bpy.data.node_groups.new("Scatter", "GeometryNodeTree")
    tree.inputs.new("NodeSocketGeometry", "Geometry")
    tree.outputs.new("NodeSocketGeometry", "Geometry")
    source, sink = tree.nodes.new("NodeGroupInput"), tree.nodes.new("NodeGroupOutput")
    scatter = tree.nodes.new("GeometryNodeInstanceOnPoints")
    info = tree.nodes.new("GeometryNodeObjectInfo")
    info.inputs["Object"].default_value = instance
    scatter.inputs["Scale"].default_value = (0.5, 0.5, 1)
    tree.links.new(source.outputs[0], scatter.inputs["Points"])
    tree.links.new(info.outputs["Geometry"], scatter.inputs["Instance"])
    tree.links.new(scatter.outputs[0], sink.inputs[0])
    item.modifiers.new("Scatter", "NODES").node_group = tree


def particles(item, instance):
    """Instances of an object at particles."""
    system = item.modifiers.new("Particles", "PARTICLE_SYSTEM").particle_system.settings
    system.type, system.count, system.use_advanced_hair = "HAIR", 6, True
    system.render_type, system.instance_object = "OBJECT", instance
    system.particle_size, system.hair_length = 0.3, 1


def instances():
    """Geometry nodes, particles, and a collection with a light in it."""
    floor_and_camera()
    build.plain_world((0.2, 0.2, 0.2))
    stone = build.add_mesh("ico_sphere", "Stone", build.matte("Stone", (0.6, 0.5, 0.4)),
                           subdivisions=1, radius=0.5)
    geometry_nodes(build.add_mesh("plane", "Scatter", None, size=2, location=(-2, 1, 0.5)), stone)
    particles(build.add_mesh("plane", "Meadow", build.matte("Green", (0.2, 0.6, 0.2)), size=2,
                             location=(2, 1, 0.1)), stone)
    stone.hide_render = True
    group = bpy.data.collections.new("Lantern")
    box = bpy.data.objects.new("Box", bpy.data.objects["Floor"].data)
    bulb = bpy.data.lights.new("Bulb", "POINT")
    bulb.energy = 100
    lamp = bpy.data.objects.new("Lamp", bulb)
    box.scale, lamp.location = (0.02, 0.02, 1), (0, 0, 1)
    for item in (box, lamp):
        group.objects.link(item)
    for x in (-1, 1):
        empty = build.add_object(f"Lantern {x}", None, (x, -1, 0.5))
        empty.instance_type, empty.instance_collection = "COLLECTION", group


def lights():
    """Area lights of all shapes, a spot, a sun, and a lens."""
    camera = floor_and_camera()
    camera.data.dof.use_dof, camera.data.dof.focus_distance = True, 8
    camera.data.dof.aperture_fstop = 0.5
    for index, shape in enumerate(("SQUARE", "RECTANGLE", "DISK", "ELLIPSE")):
        build.add_light(shape.title(), "AREA", 40, shape=shape, size=1, size_y=0.4,
                        location=(index * 2 - 3, 0, 2), rotation=(0.2, 0, 0))
    build.add_light("Spot", "SPOT", 200, spot_size=0.8, shadow_soft_size=0.1, location=(0, 2, 4))
    build.add_light("Sun", "SUN", 0.5, angle=0.2, rotation=(0.6, 0.2, 0))
    build.add_mesh("cube", "Cube", build.matte("White"), size=1, location=(0, 1, 0.5))


def environment_image():
    """A sky that is brighter above and redder on one side, 64x32, linear."""
    image = bpy.data.images.new("Sky", 64, 32, float_buffer=True)
    pixels = []
    for y in range(32):
        for x in range(64):
            pixels += [0.2 + 80.0 * (18 <= x < 22 and 24 <= y < 26) / 8, 0.3 + y / 64, 0.4 + x / 64, 1]
    image.pixels = pixels
    image.pack()
    return image


def sky():
    """An environment map that is turned by nodes."""
    floor_and_camera()
    build.add_mesh("cube", "Cube", build.matte("White"), size=1.5, location=(0, 1, 0.75))
    tree = build.plain_world((0, 0, 0)).node_tree
    texture, mapping = tree.nodes.new("ShaderNodeTexEnvironment"), tree.nodes.new(
        "ShaderNodeMapping")
    coordinates = tree.nodes.new("ShaderNodeTexCoord")
    texture.image = environment_image()
    mapping.inputs["Rotation"].default_value = (0, 0.2, 1)
    tree.links.new(coordinates.outputs["Generated"], mapping.inputs["Vector"])
    tree.links.new(mapping.outputs[0], texture.inputs["Vector"])
    tree.links.new(texture.outputs[0], tree.nodes["Background"].inputs["Color"])


def checker():
    """An image with four colours, packed."""
    image = bpy.data.images.new("Checker", 4, 4)
    image.pixels = [c for y in range(4) for x in range(4)
                    for c in ((x % 2) * 0.8 + 0.1, (y % 2) * 0.7 + 0.1, 0.2 + 0.1 * x, 1)]
    image.pack()
    return image


def textured():
    """A Principled BSDF with an image that a Mapping node turns, tinted."""
    material = build.matte("Checker")
    tree = material.node_tree
    texture, mapping = tree.nodes.new("ShaderNodeTexImage"), tree.nodes.new("ShaderNodeMapping")
    mix, coordinates = tree.nodes.new("ShaderNodeMixRGB"), tree.nodes.new("ShaderNodeTexCoord")
    texture.image, texture.interpolation = checker(), "Closest"
    mapping.inputs["Rotation"].default_value = (0, 0, 0.5)
    mapping.inputs["Location"].default_value = (0.1, 0.3, 0)
    mapping.inputs["Scale"].default_value = (2, 1, 1)
    mix.blend_type, mix.inputs["Fac"].default_value = "MULTIPLY", 1
    mix.inputs["Color2"].default_value = (1, 0.8, 0.6, 1)
    tree.links.new(coordinates.outputs["UV"], mapping.inputs["Vector"])
    tree.links.new(mapping.outputs[0], texture.inputs["Vector"])
    tree.links.new(texture.outputs["Color"], mix.inputs["Color1"])
    tree.links.new(mix.outputs[0], tree.nodes["Principled BSDF"].inputs["Base Color"])
    return material


def text():
    """Text, a bevelled curve, a metaball, a texture, a shifted camera."""
    camera = floor_and_camera()
    camera.data.shift_x, camera.data.shift_y = 0.1, -0.05
    build.plain_world((0.5, 0.5, 0.5))
    letters = bpy.data.curves.new("Letters", "FONT")
    letters.body, letters.extrude, letters.size = "hip", 0.1, 1.5
    letters.materials.append(build.node_material("Ink", "ShaderNodeBsdfDiffuse",
                                                 Color=(0.7, 0.2, 0.1, 1)))
    build.add_object("Letters", letters, (-2, 0, 0), (math.pi / 2, 0, 0))
    bpy.ops.curve.primitive_bezier_circle_add(radius=1, location=(1.5, 1, 0.3))
    ring = bpy.context.object
    ring.data.bevel_depth = 0.2
    ring.data.materials.append(build.matte("Ring", (0.9, 0.6, 0.1), Metallic=1, Roughness=0.3))
    bpy.ops.object.metaball_add(type="BALL", radius=0.8, location=(2, -1.5, 0.4))
    build.add_mesh("plane", "Panel", textured(), size=2, location=(0, 3, 1),
                   rotation=(math.pi / 2, 0, 0))
    build.add_light("Key", "POINT", 300, shadow_soft_size=0.3, location=(2, -3, 4))


def with_volume(material, kind, **inputs):
    """Links a volume node to the output of a material."""
    tree = material.node_tree
    node = tree.nodes.new(kind)
    for key, value in inputs.items():
        node.inputs[key].default_value = value
    tree.links.new(node.outputs[0], tree.nodes["Material Output"].inputs["Volume"])
    return material


def leaf():
    """Half a leaf lets light pass: a Transparent BSDF mixed in."""
    material = build.matte("Leaf", (0.2, 0.6, 0.1))
    tree = material.node_tree
    mix, clear = tree.nodes.new("ShaderNodeMixShader"), tree.nodes.new("ShaderNodeBsdfTransparent")
    mix.inputs[0].default_value = 0.6
    tree.links.new(clear.outputs[0], mix.inputs[1])
    tree.links.new(tree.nodes["Principled BSDF"].outputs[0], mix.inputs[2])
    tree.links.new(mix.outputs[0], tree.nodes["Material Output"].inputs["Surface"])
    return material


def glass():
    """Glass with absorption, fog, an emitter, an orthographic camera."""
    camera = floor_and_camera()
    camera.data.type, camera.data.ortho_scale = "ORTHO", 8
    build.plain_world((0.3, 0.3, 0.3))
    ball = with_volume(build.node_material("Glass", "ShaderNodeBsdfGlass", IOR=1.45),
                       "ShaderNodeVolumeAbsorption", Color=(0.2, 0.6, 0.9, 1), Density=1.5)
    build.add_mesh("uv_sphere", "Ball", ball, radius=0.9, location=(-2, 0, 1))
    fog = build.node_material("Fog", "ShaderNodeVolumeScatter")
    tree = fog.node_tree
    scatter = next(node for node in tree.nodes if node.type == "VOLUME_SCATTER")
    scatter.inputs["Density"].default_value, scatter.inputs["Anisotropy"].default_value = 0.4, 0.3
    tree.links.remove(tree.nodes["Material Output"].inputs["Surface"].links[0])
    tree.links.new(scatter.outputs[0], tree.nodes["Material Output"].inputs["Volume"])
    build.add_mesh("cube", "Fog", fog, size=1.8, location=(0.5, 1, 1))
    build.add_mesh("plane", "Leaf", leaf(), size=1.5, location=(2.5, 0, 1), rotation=(0.5, 0.4, 0))
    build.add_mesh("plane", "Panel", build.node_material("Light", "ShaderNodeEmission",
                                                         Strength=20.0),
                   size=1, location=(0, -1, 4))


def moves(item, path, values, key=None):
    """Animates a property from frame 0 to frame 2, at a constant rate."""
    for frame, value in zip((0, 2), values):
        setattr(key or item, path, value)
        (key or item).keyframe_insert(path, frame=frame)
    owner = key.id_data if key else item
    for curve in owner.animation_data.action.fcurves:
        for point in curve.keyframe_points:
            point.interpolation = "LINEAR"


def motion():
    """Motion blur of a ball that emits, an instance that turns and a mesh that a shape key deforms."""
    floor_and_camera()
    build.plain_world((0.3, 0.3, 0.3))
    ball = build.add_mesh("uv_sphere", "Ball", build.node_material(
        "Light", "ShaderNodeEmission", Color=(1, 0.1, 0.1, 1), Strength=5.0), radius=0.4)
    moves(ball, "location", ((-2, 2, 1), (2, 2, 1)))
    blade = bpy.data.objects.new("Blade", build.add_mesh(
        "cube", "Still", build.matte("Blue", (0.1, 0.2, 0.8)), size=1, location=(0, -1, 0.2)).data)
    blade.scale = (1.5, 0.2, 0.2)
    group = bpy.data.collections.new("Propeller")
    group.objects.link(blade)
    empty = build.add_object("Hub", None, (-2, 0, 1))
    empty.instance_type, empty.instance_collection = "COLLECTION", group
    moves(empty, "rotation_euler", ((0, -2, 0), (0, 2, 0)))
    box = build.add_mesh("cube", "Box", build.matte("Green", (0.1, 0.7, 0.2)), size=1,
                         location=(2, 0, 0.5))
    box.shape_key_add(name="Basis")
    key = box.shape_key_add(name="Up")
    for vertex in key.data:
        vertex.co.z += vertex.co.z > 0
    moves(box, "value", (0, 1), key)
    build.add_light("Key", "POINT", 300, shadow_soft_size=0.3, location=(2, -3, 4))
    bpy.context.scene.frame_set(1)
    bpy.context.scene.render.use_motion_blur = True


def photometric_file():
    """A profile that is brighter to one side.  Its steps are small, because Cycles interpolates by
    cubics between them and hipmap linearly."""
    polar, azimuth = range(0, 91, 5), range(0, 361, 15)
    rows = [[900 * math.cos(math.radians(p)) ** 2 *
             (1 + 0.8 * math.sin(math.radians(p)) * math.cos(math.radians(a))) for p in polar]
            for a in azimuth]
    numbers = [polar, azimuth, *rows]
    return "\n".join(["IESNA:LM-63-2002", "TILT=NONE",
                      f"1 1000 1 {len(polar)} {len(azimuth)} 1 2 0 0 0", "1 1 10",
                      *(" ".join(f"{x:g}" for x in row) for row in numbers), ""])


def profile(light):
    """Links an IES Texture to a light."""
    text_of_profile = bpy.data.texts.new("downlight.ies")
    text_of_profile.write(photometric_file())
    light.use_nodes = True
    tree = light.node_tree
    node = tree.nodes.new("ShaderNodeTexIES")
    node.ies = text_of_profile
    node.inputs["Strength"].default_value = 0.5
    tree.links.new(node.outputs["Fac"], tree.nodes["Emission"].inputs["Strength"])


def volume_material(name, *shaders):
    """A material of a volume alone: of one node (kind, inputs), or two halves mixed."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.remove(tree.nodes["Principled BSDF"])
    nodes = []
    for kind, inputs in shaders:
        nodes.append(tree.nodes.new(kind))
        for key, value in inputs.items():
            nodes[-1].inputs[key].default_value = value
    if len(nodes) > 1:
        mix = tree.nodes.new("ShaderNodeMixShader")
        for socket, node in zip(mix.inputs[1:], nodes):
            tree.links.new(node.outputs[0], socket)
        nodes.append(mix)
    tree.links.new(nodes[-1].outputs[0], tree.nodes["Material Output"].inputs["Volume"])
    return material


def media():
    """A Principled Volume that is hot, two volumes mixed, and a light with an IES Texture."""
    floor_and_camera()
    build.plain_world((0.2, 0.2, 0.2))
    hot = volume_material("Hot", ("ShaderNodeVolumePrincipled", {
        "Color": (0.6, 0.4, 0.3, 1), "Density": 1.5, "Anisotropy": 0.4, "Blackbody Intensity": 1,
        "Temperature": 1600}))
    build.add_mesh("cube", "Fire", hot, size=1.6, location=(-1.5, 0, 0.9))
    mixed = volume_material(
        "Mixed", ("ShaderNodeVolumeAbsorption", {"Color": (0.2, 0.6, 0.9, 1), "Density": 3}),
        ("ShaderNodeVolumeScatter", {"Density": 2, "Anisotropy": -0.3}))
    build.add_mesh("uv_sphere", "Cloud", mixed, radius=0.9, location=(1.5, 0, 1))
    lamp = build.add_light("Downlight", "POINT", 40, shadow_soft_size=0, location=(0, -0.5, 3),
                           rotation=(0.2, 0, 0.5))
    profile(lamp.data)


SCENES = (modifiers, instances, lights, sky, text, glass, motion, media)


def main():
    folder, *names = sys.argv[sys.argv.index("--") + 1:]
    for make in SCENES:
        if not names or make.__name__ in names:
            build.empty_scene().frame_end = 3
            make()
            bpy.ops.wm.save_as_mainfile(filepath=os.path.join(folder, make.__name__ + ".blend"))


main()
