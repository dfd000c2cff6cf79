"""A floor under every kind of light, with a lens, for stock_export_test.py:

    blender --python stock_export_scene.py -- OUT.blend CYCLES.exr
"""

import os
import sys

import bpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import build_scene as build


def add_lights():
    build.add_light("Square", "AREA", 100, size=1.5, color=(1, 0.5, 0.25), location=(-3, 0, 3))
    build.add_light("Rectangle", "AREA", 90, shape="RECTANGLE", size=1, size_y=2,
                    spread=1.2, location=(3, 0, 3))
    build.add_light("Disc", "AREA", 80, shape="DISK", size=1, location=(0, 2, 2))
    oval = build.add_light("Ellipse", "AREA", 70, shape="ELLIPSE", size=1, size_y=0.5,
                           location=(-1, -2, 2), rotation=(0.5, 0.2, 0.1))
    oval.scale = (2, 1, 1)
    build.add_light("Bulb", "POINT", 60, shadow_soft_size=0.12, location=(1, 1, 2))
    build.add_light("Sun", "SUN", 0.5, angle=0.1, location=(0, 0, 9), rotation=(0.5, 0, 0))
    nodes = build.add_light("Nodes", "SPOT", 50, spot_size=1.0, spot_blend=0.5, use_nodes=True,
                            color=(0.5, 1, 1), location=(-2, 2, 4))
    emission = nodes.data.node_tree.nodes["Emission"]
    emission.inputs["Color"].default_value = (1, 0.5, 1, 1)
    emission.inputs["Strength"].default_value = 2


def scatter_below():
    """Instances of geometry nodes where no light gets."""
    tree = bpy.data.node_groups.new("Scatter", "GeometryNodeTree")
    tree.outputs.new("NodeSocketGeometry", "Geometry")
    points, cube, scatter, sink = (tree.nodes.new(kind) for kind in (
        "GeometryNodeMeshLine", "GeometryNodeMeshCube", "GeometryNodeInstanceOnPoints",
        "NodeGroupOutput"))
    tree.links.new(points.outputs[0], scatter.inputs["Points"])
    tree.links.new(cube.outputs[0], scatter.inputs["Instance"])
    tree.links.new(scatter.outputs[0], sink.inputs[0])
    item = build.add_mesh("plane", "Pebbles", None, location=(0, 0, -20))
    item.modifiers.new("Scatter", "NODES").node_group = tree


def main():
    blend, image = sys.argv[sys.argv.index("--") + 1:]
    scene = build.empty_scene()
    build.set_size(64, 32)
    add_lights()
    floor = build.add_mesh("plane", "Floor", build.matte(), size=20)
    build.add_camera((9, 0, 9), (0.7, 0, 1.57)).name = "Not this one"
    camera = build.add_camera((0, -6, 5), (0.9, 0, 0))
    camera.data.dof.use_dof = True
    camera.data.dof.focus_distance = 4
    camera.data.dof.aperture_fstop = 1.4
    camera.data.dof.aperture_blades = 6
    build.sky_world()
    floor.modifiers.new("Grass", "PARTICLE_SYSTEM")
    hair = floor.particle_systems[0]
    hair.name = "Grass"
    hair.settings.type, hair.settings.render_type, hair.settings.count = "HAIR", "PATH", 0
    scatter_below()
    bpy.ops.wm.save_as_mainfile(filepath=blend)
    scene.render.engine = "CYCLES"
    scene.cycles.samples = 64
    scene.cycles.use_denoising = False
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.filepath = image
    bpy.ops.render.render(write_still=True)
    picture = bpy.data.images.load(image)
    pixels = picture.pixels[:]
    print("mean radiance:", *[sum(pixels[c::4]) / (len(pixels) // 4) for c in range(3)])


main()
