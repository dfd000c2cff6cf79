# SPDX-License-Identifier: GPL-3.0-or-later
"""A button that lists the effects of the scene that was rendered last, with reasons and costs."""

import os
import subprocess

import bpy

from .job import folder_of, read_notes, render_frame_options
from .properties import programs_folder
from .run import ToolError, find_tool
from .scene_export import SceneError

_TEXT = "hipmap effects"


def explain(render, folder):
    """Returns what `render --explain` prints about the scene in a folder.  Throws ToolError."""
    scene, partition = (os.path.join(folder, name) for name in ("scene.glb", "scene.hpm"))
    notes = read_notes(folder)
    if not os.path.isfile(scene) or not notes.get("partition"):
        raise ToolError("nothing has been rendered yet: press F12 first")
    done = subprocess.run([render, scene, partition, "--explain",
                           *render_frame_options(notes["moves"])], stdin=subprocess.DEVNULL,
                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                          check=False)
    if done.returncode != 0:
        raise ToolError(done.stderr.strip().splitlines()[-1])
    return done.stderr


class RENDER_OT_hipmap_effects(bpy.types.Operator):
    """List the effects of the scene that was rendered last, with reasons and costs, as a text"""

    bl_idname = "render.hipmap_effects"
    bl_label = "List Effects"

    def execute(self, context):
        """Writes the list to a text of Blender."""
        try:
            folder = folder_of(context.scene, context.view_layer)
            listed = explain(find_tool("render", programs_folder(context)), folder)
        except (SceneError, ToolError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        text = bpy.data.texts.get(_TEXT) or bpy.data.texts.new(_TEXT)
        text.from_string(listed)
        self.report({"INFO"}, f"see the text '{_TEXT}' in the Text Editor")
        return {"FINISHED"}


def register():
    """Adds the operator."""
    bpy.utils.register_class(RENDER_OT_hipmap_effects)


def unregister():
    """Removes the operator."""
    bpy.utils.unregister_class(RENDER_OT_hipmap_effects)
