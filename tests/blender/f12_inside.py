"""Everything that f12_test.py looks at, in one Blender:

    blender --python f12_inside.py -- ADDON.zip FOLDER_OF_SCENES OUT

The add-on's zip has the programs inside.
"""

import json
import os
import random
import sys

import bpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import install_addon
import preview_headless
from child_processes import children
from install_addon import render, set_up

ARCHIVE, SCENES, OUT = sys.argv[sys.argv.index("--") + 1:]
SCENES_BY_F12 = ("modifiers", "instances", "lights", "sky", "text", "glass", "motion", "media")
facts = {}


def out(name):
    return os.path.join(OUT, name)


def open_scene(name, folder, **options):
    bpy.ops.wm.open_mainfile(filepath=os.path.join(SCENES, name + ".blend"))
    return set_up(out(folder), **options)


def time_of_partition(folder):
    return os.stat(os.path.join(out(folder), "Scene_ViewLayer", "scene.hpm")).st_mtime_ns


def scenes():
    for name in SCENES_BY_F12:
        open_scene(name, name)
        render(out(name + ".f32"))


def motion():
    """A shutter that opens at the frame, and a world without motion; both end where they began."""
    scene = open_scene("motion", "motion_start", passes=1)
    scene.cycles.motion_blur_position = "START"
    render(out("motion_start.f32"))
    facts["frame_after_motion"] = scene.frame_current, scene.frame_subframe
    facts["ball_after_motion"] = bpy.data.objects["Ball"].location.x
    open_scene("modifiers", "motionless", passes=1).render.use_motion_blur = True
    render(out("motionless.f32"))


def volume():
    """A volume object, moved and scaled, and one that is turned."""
    scene = open_scene("modifiers", "volume", passes=1)
    cloud = os.path.join(os.path.dirname(os.path.abspath(__file__)), "cloud.vdb")
    old = os.path.join(out("volume"), "Scene_ViewLayer", "volume_old.vol")
    os.makedirs(os.path.dirname(old))
    with open(old, "wb"):
        pass
    for name, turn in (("Cloud", 0), ("Turned cloud", 0.5)):
        data = bpy.data.volumes.new(name)
        data.filepath = cloud
        item = bpy.data.objects.new(name, data)
        item.location, item.scale, item.rotation_euler = (0, 0, 0.5), (1, 2, 1), (0, 0, turn)
        scene.collection.objects.link(item)
    render(out("volume.f32"))
    facts["volume_of_another_frame"] = os.path.exists(old)


def again():
    """A scene three times: the second time light and camera have changed, the third time a face."""
    open_scene("glass", "again")
    render(out("first.f32"))
    made = [time_of_partition("again")]
    bpy.context.scene.world.node_tree.nodes["Background"].inputs["Strength"].default_value = 2
    bpy.data.objects["Camera"].location.x += 0.1
    render(out("again.f32"))
    made.append(time_of_partition("again"))
    bpy.data.objects["Ball"].location.z += 0.1
    render(out("moved.f32"))
    made.append(time_of_partition("again"))
    facts["partitions"] = made


def proceed():
    """Two passes, then two more that add to them; after a change of the scene, two from the start."""
    scene = open_scene("modifiers", "proceed")
    render(out("proceed_2.f32"))
    scene.hipmap.proceed = True
    render(out("proceed_4.f32"))
    scene.hipmap.seed = 1
    render(out("proceed_new.f32"))
    scene.hipmap.keep_passes = False
    render(out("proceed_none.f32"))
    facts["kept"] = os.path.exists(os.path.join(out("proceed"), "Scene_ViewLayer", "scene.state"))


def quote():
    """The button that lists costs, then two passes more."""
    scene = open_scene("modifiers", "quote")
    bpy.ops.render.hipmap_quote()
    facts["costs"] = sys.modules["hipmap.quote"]._costs["Scene"]
    notes = sys.modules["hipmap.job"].read_notes(os.path.join(out("quote"), "Scene_ViewLayer"))
    facts["quoted_passes"] = notes["passes"]["scene.state"]
    scene.hipmap.proceed = True
    render(out("quoted.f32"))


def border():
    scene = open_scene("text", "border")
    scene.render.use_border = True
    scene.render.border_min_x, scene.render.border_max_x = 0.25, 0.75
    scene.render.border_min_y, scene.render.border_max_y = 0.5, 1.0
    render(out("border.f32"))
    scene.render.use_crop_to_border = True
    render(out("crop.f32"))
    scene.render.resolution_percentage = 50
    scene.render.use_border = False
    render(out("half.f32"))


class SizeProbe(bpy.types.RenderEngine):
    """Compares the size of Blender's result with the add-on's."""

    bl_idname, bl_label = "SIZE_PROBE", "Size Probe"

    def render(self, depsgraph):
        result = self.begin_result(0, 0, 9999, 9999)  # cut to the size that it has
        pixels = len(result.layers[0].passes[0].rect)
        self.end_result(result)
        picture = sys.modules["hipmap.frame"].picture_of(depsgraph.scene.render)
        facts["sizes"].append((pixels, picture.part_width * picture.part_height))


def sizes():
    """Borders and percentages at random, as many pixels as Blender has."""
    facts["sizes"] = []
    bpy.utils.register_class(SizeProbe)
    scene = open_scene("text", "sizes")
    scene.render.engine = "SIZE_PROBE"
    scene.render.use_border = scene.render.use_crop_to_border = True
    chance = random.Random(1)
    for _ in range(60):
        scene.render.resolution_x, scene.render.resolution_y = (chance.randint(50, 900) for _ in "xy")
        scene.render.resolution_percentage = chance.choice((100, 57, 50, 33))
        scene.render.border_min_x, scene.render.border_min_y = (round(chance.uniform(0, 0.4), 2)
                                                                for _ in "xy")
        scene.render.border_max_x, scene.render.border_max_y = (round(chance.uniform(0.5, 1), 2)
                                                                for _ in "xy")
        bpy.ops.render.render()


def layers():
    """Two view layers, the second without the letters."""
    scene = open_scene("text", "layers")
    other = scene.view_layers.new("Other")
    hidden = bpy.data.collections.new("Hidden")
    scene.collection.children.link(hidden)
    letters = bpy.data.objects["Letters"]
    hidden.objects.link(letters)
    scene.collection.objects.unlink(letters)
    other.layer_collection.children["Hidden"].exclude = True
    render(out("layers.f32"))


def frames():
    scene = open_scene("modifiers", "frames")
    ball = bpy.data.objects["Row"]
    for frame, x in ((1, -2), (5, 0)):
        ball.location.x = x
        ball.keyframe_insert("location", frame=frame)
    scene.frame_end = 5
    scene.render.filepath = out("frame_")
    bpy.ops.render.render(animation=True)
    for frame in range(1, 6):
        install_addon.dump(out(f"frame_{frame:04}.exr"), out(f"frame_{frame}.f32"))


def flight():
    """An animation in which only the camera moves."""
    scene = open_scene("glass", "flight")  # without guides, which serve one camera
    camera = bpy.data.objects["Camera"]
    for frame, x in ((1, 0), (2, 0.5)):
        camera.location.x += x
        camera.keyframe_insert("location", frame=frame)
    scene.frame_end = 2
    scene.render.filepath = out("flight_")
    engine, requests = sys.modules["hipmap.engine"], []
    request = engine.request

    def request_verbosely(command):
        requests.append(request([*command, "--verbose"]))
        return requests[-1]

    engine.request = request_verbosely
    bpy.ops.render.render(animation=True)
    scene.hipmap.proceed = True
    for passes in (1, 1):  # each frame is continued alone
        scene.hipmap.passes = passes
        bpy.ops.render.render(animation=True)
    engine.request = request
    facts["flight"] = ["reused the photon maps" in " ".join(one.messages) for one in requests]
    facts["children_after_flight"] = len(children(os.getpid()))
    facts["states_of_flight"] = sorted(name for name in os.listdir(os.path.join(
        out("flight"), "Scene_ViewLayer")) if name.endswith(".state"))
    install_addon.dump(out("flight_0002.exr"), out("flight_2.f32"))


def failures():
    """What goes wrong is one line, and Blender goes on."""
    scene = open_scene("modifiers", "failures")
    lines = []
    for spoil in (lambda: setattr(bpy.data.objects["Camera"].data, "type", "PANO"),
                  lambda: setattr(scene, "camera", None)):
        spoil()
        try:
            bpy.ops.render.render()
            lines.append("rendered")
        except RuntimeError as error:
            lines.append(str(error))
    facts["failures"] = lines


def menu_and_button():
    """File > Export > hipmap, and the list of effects."""
    open_scene("lights", "lights")
    facts["export"] = list(bpy.ops.export_scene.hipmap(filepath=out("menu.glb")))
    bpy.ops.render.hipmap_effects()
    facts["effects"] = bpy.data.texts["hipmap effects"].as_string()


def preview():
    """The preview of the viewport, and its cameras."""
    facts["cameras"] = []
    for name in ("text", "glass", "lights"):
        scene = open_scene(name, "cameras")
        facts["cameras"].append(preview_headless.camera_pair())
        scene.render.use_border = True
        scene.render.border_min_x, scene.render.border_max_x = 0.25, 0.75
        scene.render.border_min_y, scene.render.border_max_y = 0.5, 1.0
        facts["cameras"].append(preview_headless.camera_pair())
    open_scene("sky", "preview")
    facts["preview"] = preview_headless.run(out("preview"))


def maps():
    """Colours of shared maps on a bevelled row, a cut cube with twins, a rounded cube."""
    open_scene("modifiers", "maps")
    plain = bpy.data.objects["Floor"].data
    plain.color_attributes.new("Paint", "BYTE_COLOR", "CORNER")
    bpy.data.objects["Cutter"].hide_set(True)  # the Boolean modifier still takes its faces
    facts["shown"] = list(bpy.ops.object.hipmap_show_maps())
    found = facts["maps"] = {}
    for item in bpy.data.objects:
        layer = item.data.color_attributes.get("hipmap Maps") if item.type == "MESH" else None
        if layer is None:
            continue
        assert item.data.color_attributes.active_color == layer
        assert "hipmap face" not in item.data.attributes
        faces = [[tuple(round(c, 3) for c in layer.data[i].color) for i in face.loop_indices]
                 for face in item.data.polygons]
        assert all(len(set(corners)) == 1 for corners in faces), item.name
        found[item.name] = len({corners[0] for corners in faces})
    render(out("maps.f32"))
    bpy.ops.object.hipmap_remove_maps()
    facts["left"] = [list(mesh.color_attributes.keys()) for mesh in bpy.data.meshes
                     if mesh.color_attributes]
    assert plain.color_attributes.active_color.name == "Paint"
    assert not any(key.startswith("hipmap") for mesh in bpy.data.meshes for key in mesh.keys())


install_addon.install(ARCHIVE, "")
scenes()
motion()
volume()
again()
proceed()
quote()
border()
sizes()
layers()
frames()
flight()
menu_and_button()
preview()
maps()
failures()
with open(out("facts.json"), "w", encoding="utf-8") as file:
    json.dump(facts, file)
sys.stdout.flush()
os._exit(0)  # Blender's own code is 1 as soon as an error was reported, here on purpose
