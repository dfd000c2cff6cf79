# SPDX-License-Identifier: GPL-3.0-or-later
"""File > Export > hipmap (.glb)."""

import bpy
from bpy_extras.io_utils import ExportHelper

from . import stock_export
from .world import WorldError


class EXPORT_SCENE_OT_hipmap(bpy.types.Operator, ExportHelper):
    """Export the scene for hipmap: glTF, and what glTF lacks as custom properties"""

    bl_idname = "export_scene.hipmap"
    bl_label = "Export for hipmap"
    filename_ext = ".glb"
    filter_glob: bpy.props.StringProperty(default="*.glb", options={"HIDDEN"})

    def execute(self, context):
        """Writes the file and names what hipmap does not render."""
        try:
            losses = stock_export.export_scene(context.scene, self.filepath)
        except WorldError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        for line in losses:
            self.report({"WARNING"}, line)
        return {"FINISHED"}


def _add_entry(menu, _context):
    menu.layout.operator(EXPORT_SCENE_OT_hipmap.bl_idname, text="hipmap (.glb)")


def register():
    """Adds the entry to the menu."""
    bpy.utils.register_class(EXPORT_SCENE_OT_hipmap)
    bpy.types.TOPBAR_MT_file_export.append(_add_entry)


def unregister():
    """Removes the entry."""
    bpy.types.TOPBAR_MT_file_export.remove(_add_entry)
    bpy.utils.unregister_class(EXPORT_SCENE_OT_hipmap)
