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


def _modules():
    """What is registered, in order.  Imported late: export_hipmap.py needs the menu alone."""
    from . import (effects, engine, export_menu, overlay, panels, passes, properties, quote,
                   viewport)
    return (properties, passes, viewport, engine, quote, effects, overlay, panels, export_menu)


def register():
    """Called by Blender when the add-on is enabled."""
    for module in _modules():
        module.register()


def unregister():
    """Called by Blender when the add-on is disabled."""
    for module in reversed(_modules()):
        module.unregister()
