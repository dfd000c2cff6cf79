"""A 3D viewport and a button in a real window with Blender's first scene, step by step:

    blender --python preview_window.py -- ADDON.zip OUT

Writes facts.json and the window as window.png.
"""

import json
import os
import sys
import time
import traceback

import bpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import install_addon
from preview_headless import running_programs

ARCHIVE, OUT = sys.argv[sys.argv.index("--") + 1:]
facts = {}


def viewports():
    return list(sys.modules["hipmap.viewport"]._live)


def preview():
    live = viewports()
    return live[0]._preview if live else None


def area():
    return next(one for one in bpy.context.window_manager.windows[0].screen.areas
                if one.type == "VIEW_3D")


def show(**changes):
    for name, value in changes.items():
        setattr(area().spaces[0].shading, name, value)


def picture():
    """The picture that is drawn; None: not yet that of the latest view and scene."""
    one = preview()
    if one is None or viewports()[0]._changed is not None:
        return None
    return one.shown if one.shown is not None and one.is_of(one._wish) else None


def steps():
    """Yields conditions to wait for."""
    show(type="RENDERED")
    yield lambda: picture() is not None and viewports()[0]._drawn is picture()
    first = picture()
    facts["mean"] = first.pixels.mean(axis=0).tolist()
    facts["part"] = [first.width, first.height]
    area().spaces[0].region_3d.view_perspective = "CAMERA"
    yield lambda: picture() is not None and picture().wish.view != first.wish.view
    seen = picture()
    facts["scene_exported_again"] = seen.wish.scene is not first.wish.scene
    bpy.data.objects["Light"].data.energy *= 4
    yield lambda: picture() is not None and picture().wish.scene is not seen.wish.scene
    facts["brighter"] = float(picture().pixels[:, :3].mean() / seen.pixels[:, :3].mean())
    yield lambda: preview().told.startswith("2 of 2") and viewports()[0]._drawn is picture()
    bpy.ops.screen.screenshot(filepath=os.path.join(OUT, "window.png"))
    bpy.context.scene.hipmap.preview_passes = 50_000
    bpy.context.scene.update_tag()  # as a change by hand does
    # Between the coarse picture and the next no program runs.
    yield lambda: " of 50000 " in preview().told and running_programs() > 0
    facts["children"] = [running_programs()]
    ending = preview()
    show(type="SOLID")
    yield lambda: not viewports() and ending.has_ended()
    facts["children"].append(running_programs())
    scene = bpy.context.scene
    scene.render.resolution_x, scene.render.resolution_y = 48, 32
    quote = sys.modules["hipmap.quote"]
    with bpy.context.temp_override(window=bpy.context.window_manager.windows[0]):
        facts["quote"] = list(bpy.ops.render.hipmap_quote("INVOKE_DEFAULT"))
    facts["asked"] = [quote.is_asked()]
    yield lambda: not quote.is_asked()
    facts["asked"].append(quote.is_asked())
    facts["costs"] = quote._costs["Scene"]


def run():
    """A timer that goes through the steps."""
    global waiting
    if time.monotonic() - began > 25:
        print("nothing came after", facts, flush=True)
        os._exit(1)
    try:
        if waiting():
            waiting = next(todo)
    except StopIteration:
        with open(os.path.join(OUT, "facts.json"), "w", encoding="utf-8") as file:
            json.dump(facts, file)
        os._exit(0)
    except BaseException:
        traceback.print_exc()
        sys.stderr.flush()
        os._exit(1)
    return 0.02


began = time.monotonic()
install_addon.install(ARCHIVE, "")
bpy.context.preferences.view.show_splash = False
install_addon.set_up(OUT).hipmap.preview_passes = 2
todo = steps()
waiting = lambda: True
bpy.app.timers.register(run, first_interval=0.2)
