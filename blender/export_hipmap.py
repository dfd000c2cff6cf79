"""Exports a Blender scene for hipmap, without hipmap being installed in Blender.

    blender SCENE.blend --python blender/export_hipmap.py
    blender --background SCENE.blend --python blender/export_hipmap.py -- OUT.glb

The first command adds File > Export > hipmap (.glb); the second one exports and ends.  Both use
Blender's own glTF exporter with the right boxes ticked, and add what glTF lacks as custom properties:
area lights, the size of lights, depth of field and the world.  The folder `hipmap` must lie beside
this file.
"""

import os
import sys

import bpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from hipmap import export_menu, stock_export


def main():
    """Exports if the command line names a file, else adds the menu entry."""
    if "--" not in sys.argv:
        export_menu.register()
        return
    for line in stock_export.export_scene(bpy.context.scene, sys.argv[sys.argv.index("--") + 1]):
        print(f"warning: {line}", file=sys.stderr)


main()
