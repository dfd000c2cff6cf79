"""Exports the open scene by the add-on and by Blender's own exporter:

    blender SCENE.blend --python oracle_inside.py -- BLENDER_FOLDER OURS.glb STOCK.glb
"""

import json
import sys

import bpy

FOLDER, OURS, STOCK = sys.argv[sys.argv.index("--") + 1:]
sys.path.insert(0, FOLDER)
from hipmap import frame, scene_export


def main():
    # The exporter takes the settings of the viewport, so both do; and it drops the instances of
    # objects that are hidden in renders.
    for item in bpy.data.objects:
        item.hide_render = False
    depsgraph = bpy.context.evaluated_depsgraph_get()
    exported = scene_export.export_depsgraph(depsgraph, OURS,
                                             frame.picture_of(bpy.context.scene.render))
    print("exported:", json.dumps({"triangles": exported.triangles, "losses": exported.losses}))
    bpy.ops.export_scene.gltf(filepath=STOCK, export_cameras=True, export_lights=True,
                              export_apply=True, use_renderable=True)


main()
