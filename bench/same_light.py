#!/usr/bin/env python3
"""Compares hipmap's light with Cycles' in .glb files: mean radiance, and the worst tile.

    bench/same_light.py BIN FOLDER SCENE.glb... [--size W H] [--samples S] [--passes P] [--look L]

BIN has `render` and `preprocess`; needs blender on the PATH and python3-numpy.  Cycles renders two
images of S samples by different seeds, hipmap two of P passes; both filter by the box.  Prints the
ratio of means (R, G, B) with its standard error by the differences between the two of each, and the
8x8 tile whose mean is farthest off beyond both noises (three standard errors), in per cent of the
larger of its own brightness and a fifth of the image's.  Images are kept in FOLDER.
"""

import argparse
import pathlib
import subprocess
import sys

import numpy

HERE = pathlib.Path(__file__).resolve().parent
sys.path.append(str(HERE.parent / "experiments/accuracy"))
import arithmetic  # noqa: E402
import in_blender  # noqa: E402

TILE = 8
SIGMAS = 3
DARK = 0.2


def read_pfm(path):
    width, numbers = arithmetic.read_pfm(path)
    return numpy.array(numbers).reshape(-1, width, 3).astype(float)


def tiles(image):
    """Means of the tiles, luminance of equal channels; what does not fill a tile is left out."""
    height, width = (n // TILE * TILE for n in image.shape[:2])
    grey = image[:height, :width].mean(axis=2)
    return grey.reshape(height // TILE, TILE, width // TILE, TILE).mean(axis=(1, 3))


def by_cycles(options, scene, seed):
    image = options.folder / f"{scene.stem}.cycles.{options.samples}.{seed}.pfm"
    if not image.exists():
        in_blender.processor_seconds(HERE / "cycles_import.py", scene,
                                     [scene, image, *options.size, options.samples, seed, 0],
                                     options.folder)
    return read_pfm(image)


def by_hipmap(options, scene, seed):
    image = options.folder / f"{scene.stem}.hipmap.{options.look}.{seed}.pfm"
    partition = options.folder / f"{scene.stem}.hpm"
    subprocess.run([options.bin / "preprocess", scene, "-o", partition], check=True,
                   stderr=subprocess.DEVNULL)
    subprocess.run([options.bin / "render", scene, partition, "-o", image, "--look", options.look,
                    "--size", "x".join(map(str, options.size)), "--filter", "box", "--seed",
                    str(seed), "--passes", str(options.passes), "--environment", "0"],
                   check=True, stderr=subprocess.DEVNULL)
    return read_pfm(image)


def worst_tile(ours, theirs):
    """Its offset, in per cent beyond the noise; its column and row in tiles, rows from below."""
    a, b = (numpy.array([tiles(image) for image in pair]) for pair in (ours, theirs))
    noise = numpy.sqrt((a[0] - a[1])**2 + (b[0] - b[1])**2) / 2
    # Of two images the difference of one tile says little: that of the tiles around counts too.
    padded = numpy.pad(noise**2, 1, mode="edge")
    rows, columns = noise.shape
    noise = numpy.sqrt(sum(padded[y:y + rows, x:x + columns] for y in range(3) for x in range(3))
                       / 9)
    offset = a.mean(axis=0) - b.mean(axis=0)
    beyond = numpy.sign(offset) * numpy.maximum(0, abs(offset) - SIGMAS * noise)
    mean = b.mean(axis=0)
    share = beyond / numpy.maximum(mean, DARK * mean.mean())
    row, column = numpy.unravel_index(abs(share).argmax(), share.shape)
    return 100 * share[row, column], column, row


def compare(options, scene):
    ours = [by_hipmap(options, scene, seed) for seed in (1, 2)]
    theirs = [by_cycles(options, scene, seed) for seed in (1, 2)]
    a, b = (numpy.array([image.mean(axis=(0, 1)) for image in pair]) for pair in (ours, theirs))
    ratio = a.mean(axis=0) / b.mean(axis=0)
    error = numpy.sqrt(((a[0] - a[1]) / a.sum(axis=0))**2 + ((b[0] - b[1]) / b.sum(axis=0))**2)
    share, column, row = worst_tile(ours, theirs)
    print(f"| {scene.stem} | " + ", ".join(f"{r:.4f}" for r in ratio) +
          f" | {100 * error.max():.2f} % | {share:+.1f} % at {column}, {row} |", flush=True)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("bin", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("scenes", type=pathlib.Path, nargs="+")
    parser.add_argument("--size", type=int, nargs=2, default=[160, 120])
    parser.add_argument("--samples", type=int, default=256)
    parser.add_argument("--passes", type=int, default=16)
    parser.add_argument("--look", default="auto")
    options = parser.parse_args()
    options.folder = options.folder.resolve()
    options.folder.mkdir(parents=True, exist_ok=True)
    print("| scene | hipmap / Cycles (R, G, B) | standard error | worst tile |\n|---|---|---|---|")
    for scene in options.scenes:
        compare(options, scene.resolve())


if __name__ == "__main__":
    main()
