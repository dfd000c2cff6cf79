"""Parts of which the test scenes are built, inside Blender."""

import bpy


def empty_scene():
    """Throws everything away; returns the scene."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    return bpy.context.scene


def add_object(name, data, location=(0, 0, 0), rotation=(0, 0, 0)):
    item = bpy.data.objects.new(name, data)
    item.location = location
    item.rotation_euler = rotation
    bpy.context.scene.collection.objects.link(item)
    return item


def add_light(name, kind, energy, **properties):
    """Returns the object of a new light.  properties: of the light; location and rotation: of the
    object."""
    place = {key: properties.pop(key) for key in ("location", "rotation") if key in properties}
    light = bpy.data.lights.new(name, kind)
    light.energy = energy
    for key, value in properties.items():
        setattr(light, key, value)
    return add_object(name, light, **place)


def add_camera(location, rotation, **properties):
    """Returns the object of a new camera, which is the scene's."""
    camera = bpy.data.cameras.new("Camera")
    for key, value in properties.items():
        setattr(camera, key, value)
    item = add_object("Camera", camera, location, rotation)
    bpy.context.scene.camera = item
    return item


def matte(name="Matte", colour=(0.8, 0.8, 0.8), **inputs):
    """A material with a Principled BSDF without reflection, but for what inputs say."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    node = material.node_tree.nodes["Principled BSDF"]
    node.inputs["Base Color"].default_value = (*colour, 1)
    values = {"Specular": 0, "Roughness": 1, **{key.replace("_", " "): v for key, v in inputs.items()}}
    for key, value in values.items():
        node.inputs[key].default_value = value
    return material


def node_material(name, kind, **inputs):
    """A material of one shader node, such as "ShaderNodeBsdfGlass"."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.remove(tree.nodes["Principled BSDF"])
    node = tree.nodes.new(kind)
    for key, value in inputs.items():
        node.inputs[key].default_value = value
    tree.links.new(node.outputs[0], tree.nodes["Material Output"].inputs["Surface"])
    return material


def add_mesh(kind, name, material, **properties):
    """Adds a primitive mesh: "plane", "cube", "uv_sphere" and the like."""
    getattr(bpy.ops.mesh, f"primitive_{kind}_add")(**properties)
    item = bpy.context.object
    item.name = name
    if material is not None:
        item.data.materials.append(material)
    return item


def plain_world(colour, strength=1.0):
    """Gives the scene a world of one colour."""
    world = bpy.data.worlds.new("World")
    world.use_nodes = True
    background = world.node_tree.nodes["Background"]
    background.inputs["Color"].default_value = (*colour, 1)
    background.inputs["Strength"].default_value = strength
    bpy.context.scene.world = world
    return world


def sky_world():
    """Gives the scene a world with a sky and its sun."""
    world = plain_world((0, 0, 0), 0.2)
    tree = world.node_tree
    sky = tree.nodes.new("ShaderNodeTexSky")
    sky.sun_elevation, sky.sun_rotation, sky.sun_size = 0.5, 0.3, 0.1
    tree.links.new(sky.outputs[0], tree.nodes["Background"].inputs["Color"])
    return world


def set_size(width, height):
    render = bpy.context.scene.render
    render.resolution_x, render.resolution_y, render.resolution_percentage = width, height, 100
