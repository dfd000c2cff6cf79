"""Renders a mesh of 1,002,528 triangles, one sample or pass, so that Blender prints when what began:

    blender -b --factory-startup --python bench/large_mesh.py -- PROGRAMS HIPMAP|CYCLES smooth|flat

Blender's lines tell the seconds since the start of the render (Time).  Cycles has synchronised its
scene at "Initializing", and has its tree at "Sample 0/1".  hipmap has exported at "finding faces",
and has the partition at "starting".
"""

import os
import sys

import bpy
import numpy

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.join(ROOT, "blender"))
import hipmap
from hipmap import job

PROGRAMS, ENGINE, SHADING = sys.argv[sys.argv.index("--") + 1:]
SIDE = 708


def waves():
    """A square of 10 metres with waves, in the scene with a camera and a sun."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.mesh.primitive_grid_add(x_subdivisions=SIDE, y_subdivisions=SIDE, size=10)
    mesh = bpy.context.object.data
    positions = numpy.empty(len(mesh.vertices) * 3, numpy.float32)
    mesh.vertices.foreach_get("co", positions)
    x, y = positions[0::3], positions[1::3]
    positions[2::3] = 0.3 * numpy.sin(3 * x) * numpy.cos(2 * y)
    mesh.vertices.foreach_set("co", positions)
    if SHADING == "smooth":
        bpy.ops.object.shade_smooth()
    bpy.ops.object.light_add(type="SUN")
    bpy.ops.object.camera_add(location=(0, -14, 10), rotation=(0.95, 0, 0))
    bpy.context.scene.camera = bpy.context.object


def main():
    waves()
    hipmap.register()
    job.programs_folder = lambda context: PROGRAMS
    scene = bpy.context.scene
    scene.render.engine = ENGINE
    scene.render.resolution_x, scene.render.resolution_y = 64, 48
    scene.cycles.samples, scene.cycles.use_denoising = 1, False
    scene.hipmap.stop_at, scene.hipmap.passes = "PASSES", 1
    bpy.ops.render.render()


main()
