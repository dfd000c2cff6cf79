"""The viewport's preview without a viewport, for f12_inside.py, which has installed the add-on."""

import os
import sys
import time

import bpy

from child_processes import children


def _module(name):
    return sys.modules["hipmap." + name]


def _view(camera, depsgraph, size, **options):
    """The View of a camera that fills a region."""
    window = camera.calc_matrix_camera(depsgraph, x=size[0], y=size[1])
    view = camera.matrix_world.inverted()
    clip = camera.data.clip_start, camera.data.clip_end
    return _module("viewport_camera").make_view(window, view, clip, size, **options)


def camera_pair():
    """The camera of the open scene as the viewport and as F12 export it: numbers by name."""
    scene = bpy.context.scene
    depsgraph = bpy.context.evaluated_depsgraph_get()
    picture = _module("frame").picture_of(scene.render)
    cameras = _module("cameras")
    camera = scene.camera
    part = (0.0, 0.0, 1.0, 1.0)
    if scene.render.use_border:
        part = (scene.render.border_min_x, scene.render.border_min_y,
                scene.render.border_max_x, scene.render.border_max_y)
    view = _view(camera, depsgraph, (picture.width, picture.height), part=part)
    entry = cameras.gltf_camera(camera.data, picture)
    shift = {"shift_right": 0.0, "shift_up": 0.0, **cameras.shift_extras(camera.data, picture)}
    kind = entry["type"]
    return [{**view.camera()[kind], **dict(view.extras)}, {**entry[kind], **shift}]


def _until(holds, seconds=30):
    end = time.monotonic() + seconds
    while not holds():
        assert time.monotonic() < end, "nothing came"
        time.sleep(0.005)


def running_programs():
    """The number of programs that this Blender runs."""
    return len(children(os.getpid()))


def run(folder):
    """Renders the open scene as a viewport does.  Returns what there is to check."""
    os.makedirs(folder)
    scene = bpy.context.scene
    depsgraph = bpy.context.evaluated_depsgraph_get()
    preview_module, export = _module("preview"), _module("viewport_export").export_viewport
    programs = {name: _module("run").find_tool(name, "") for name in ("preprocess", "render")}
    preview = preview_module.Preview(folder, programs)
    scene.hipmap.preview_passes = 2
    first = export(depsgraph, folder)
    wish = preview_module.Wish(first, _view(scene.camera, depsgraph, (96, 64)))
    preview.show(wish)
    _until(lambda: preview.told.startswith("2 of 2"))
    preview.shown.pixels[:, :3].tofile(os.path.join(folder, "shown.f32"))
    facts = {"size": [preview.shown.width, preview.shown.height]}
    with open(os.path.join(folder, "scene.glb"), "rb") as file:
        content = file.read()
    with open(os.path.join(folder, "kept.glb"), "wb") as file:
        file.write(content)

    scene.hipmap.preview_passes = 10_000
    endless = export(depsgraph, folder)
    facts["same"] = [endless.same_picture(first), endless.same_picture(export(depsgraph, folder))]
    partition = os.path.join(folder, "scene.hpm")
    made = os.stat(partition).st_mtime_ns
    for step in range(1, 4):  # the camera moves while a picture is made
        scene.camera.location.x += 0.1
        bpy.context.view_layer.update()
        wish = preview_module.Wish(endless, _view(scene.camera, depsgraph, (96 + step, 64)))
        preview.show(wish)
        _until(lambda wish=wish: preview.is_of(wish))
    facts["partition_again"] = os.stat(partition).st_mtime_ns != made
    _until(lambda: running_programs() > 0)  # between the coarse picture and the next none runs
    facts["children"] = [running_programs()]
    began = time.monotonic()
    preview.close()
    _until(preview.has_ended)
    facts["seconds_to_end"] = time.monotonic() - began
    facts["children"].append(running_programs())
    return facts
