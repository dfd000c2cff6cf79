"""Renders the scenes of tests/blender by F12 and by Cycles, and puts them side by side:

    blender -b --factory-startup --python tests/blender/f12_scenes.py -- FOLDER
    blender -b --factory-startup --python bench/f12_beside_cycles.py -- PROGRAMS FOLDER OUT.png \
        [NAME...]

Prints a table of mean radiance, hipmap / Cycles, for docs/blender.md.  In OUT.png hipmap is on the
left of each pair.
"""

import os
import sys
import time

import bpy
import numpy

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.join(ROOT, "blender"))
import hipmap
from hipmap import job

PROGRAMS, FOLDER, OUT, *NAMES = sys.argv[sys.argv.index("--") + 1:]
SCENES = ("modifiers", "instances", "lights", "sky", "text", "glass", "motion", "media")
WIDTH, HEIGHT, COLUMNS = 300, 200, 2
PASSES, SAMPLES = 48, 512
TILE = 10


def render(name, engine):
    """Linear pixels [height, width, 3], bottom row first, and the seconds they took."""
    scene = bpy.context.scene
    scene.render.engine = engine
    scene.render.filepath = os.path.join(FOLDER, f"{name}_{engine}.exr")
    began = time.monotonic()
    bpy.ops.render.render(write_still=True)
    seconds = time.monotonic() - began
    image = bpy.data.images.load(scene.render.filepath)
    pixels = numpy.empty(WIDTH * HEIGHT * 4, numpy.float32)
    image.pixels.foreach_get(pixels)
    return pixels.reshape(HEIGHT, WIDTH, 4)[:, :, :3], seconds


def set_up(name):
    """Nothing is clamped or left out by either engine."""
    bpy.ops.wm.open_mainfile(filepath=os.path.join(FOLDER, name + ".blend"))
    scene = bpy.context.scene
    scene.render.resolution_x, scene.render.resolution_y = WIDTH, HEIGHT
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.hipmap.stop_at, scene.hipmap.passes = "PASSES", PASSES
    scene.hipmap.folder = os.path.join(FOLDER, "files_" + name)
    cycles = scene.cycles
    cycles.samples, cycles.use_adaptive_sampling, cycles.use_denoising = SAMPLES, False, False
    for kind in ("max", "diffuse", "glossy", "transmission", "volume", "transparent_max"):
        setattr(cycles, kind + "_bounces", 32)
    cycles.sample_clamp_indirect, cycles.blur_glossy = 0, 0


def tiles(pixels):
    """Means of squares of TILE pixels."""
    return pixels.reshape(HEIGHT // TILE, TILE, WIDTH // TILE, TILE, 3).mean((1, 3, 4))


def shown(ours, theirs):
    """Both for a screen, exposed alike, so that 98 % of the pixels are not white."""
    both = numpy.concatenate([ours, theirs], axis=1)
    white = numpy.percentile(both.max(axis=2), 98)
    return numpy.clip(both / white, 0, 1) ** (1 / 2.2)


def save(pictures):
    """Writes pairs of pictures in columns."""
    pictures += [numpy.zeros_like(pictures[0])] * (-len(pictures) % COLUMNS)
    rows = [numpy.concatenate(pictures[i:i + COLUMNS], axis=1)
            for i in range(0, len(pictures), COLUMNS)]
    whole = numpy.concatenate(rows[::-1], axis=0)
    pixels = numpy.ones((*whole.shape[:2], 4), numpy.float32)
    pixels[:, :, :3] = whole
    image = bpy.data.images.new("pairs", whole.shape[1], whole.shape[0])
    image.pixels.foreach_set(pixels.ravel())
    image.filepath_raw, image.file_format = OUT, "PNG"
    image.save()


def main():
    hipmap.register()
    job.programs_folder = lambda context: PROGRAMS
    pictures, rows = [], []
    for name in NAMES or SCENES:
        set_up(name)
        (ours, ours_s), (theirs, theirs_s) = render(name, "HIPMAP"), render(name, "CYCLES")
        pictures.append(shown(ours, theirs))
        ratio = ours.mean((0, 1)) / theirs.mean((0, 1))
        by_tile = tiles(ours) / tiles(theirs)
        rows.append(f"| {name} | {ratio[0]:.3f}, {ratio[1]:.3f}, {ratio[2]:.3f} | "
                    f"{numpy.percentile(by_tile, 5):.2f} to {numpy.percentile(by_tile, 95):.2f} | "
                    f"{ours_s:.1f} | {theirs_s:.1f} |")
    save(pictures)
    print("\n".join(["| scene | red, green, blue | 90 % of tiles | hipmap, s | Cycles, s |",
                     "|---|---|---|---|---|", *rows]))


main()
