# SPDX-License-Identifier: GPL-3.0-or-later
"""hipmap inside Blender."""

bl_info = {
    "name": "hipmap",
    "author": "the hipmap authors",
    "version": (0, 1, 0),
    "blender": (2, 93, 0),
    "location": "Render Properties > Render Engine > hipmap; File > Export > hipmap (.glb)",
    "description": "Renders with hierarchical photon maps",
    "category": "Render",
}


def register():
    """Called by Blender when the add-on is enabled."""
    from . import export_menu
    export_menu.register()


def unregister():
    """Called by Blender when the add-on is disabled."""
    from . import export_menu
    export_menu.unregister()
