#!/usr/bin/env python3
"""Renders assets/carafe.glb for the README: the picture, and the strip beside Blender's Cycles.

    bench/hero.py BIN FOLDER picture [--seconds S]
    bench/hero.py BIN FOLDER strip [--seconds S]

BIN has `render` and `preprocess`; strip needs blender on the PATH and python3-numpy. Images and
states are kept in FOLDER; a run that was stopped resumes.

picture renders 1600x800 for S seconds by the clock (default 1500) and writes docs/images/carafe.png.

strip renders 800x400 by both for about S processor seconds each, box filter, and writes
docs/images/carafe_cycles.png: hipmap, Cycles, and hipmap's estimated error of each pixel, side by
side. Cycles gets the light radii and the lens of the file; neither clamps nor denoises. Prints
processor seconds, passes of hipmap and samples per pixel of Cycles.
"""

import argparse
import json
import pathlib
import struct
import subprocess
import sys
import zlib

import numpy

import beside_cycles

ROOT = pathlib.Path(__file__).resolve().parent.parent
SCENE = ROOT / "assets/carafe.glb"
IMAGES = ROOT / "docs/images"
EXPOSURE = 0.15
FIRST_PASSES = 2
FEW_SAMPLES = 4
GAP = 8  # pixels between the images of a strip


def read_png(path):
    """The RGB values of an 8-bit PNG whose rows are not filtered or filtered by the row above."""
    data, place, packed = path.read_bytes(), 8, b""
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place:place + 8])
        body = data[place + 8:place + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colours = struct.unpack(">IIBB", body[:10])
        packed += body if kind == b"IDAT" else b""
        place += 12 + length
    assert depth == 8 and colours == 2, f"{path}: not 8-bit RGB"
    rows = numpy.frombuffer(zlib.decompress(packed), "u1").reshape(height, 1 + 3 * width)
    pixels = numpy.zeros((height + 1, width + 1, 3), "u1")
    for y, row in enumerate(rows):
        unfilter(int(row[0]), row[1:].reshape(width, 3), pixels[y:y + 2])
    return pixels[1:, 1:]


def unfilter(kind, values, two):
    """two: the row above and the one to fill, each behind a pixel of zeros."""
    above, here = two.astype(int)
    if kind in (0, 2):
        here[1:] = values if kind == 0 else (values + above[1:]) & 255
    else:
        for x in range(len(values)):
            left, up, corner = here[x], above[x + 1], above[x]
            if kind == 1:
                guess = left
            elif kind == 3:
                guess = (left + up) // 2
            else:
                plane = left + up - corner
                choices = numpy.stack((left, up, corner))
                guess = numpy.take_along_axis(
                    choices, numpy.abs(plane - choices).argmin(axis=0)[None], 0)[0]
            here[x + 1] = (values[x] + guess) & 255
    two[1] = here


def write_png(path, pixels):
    """8-bit RGB; each row is stored as what it differs from the row above by."""
    differences = numpy.diff(pixels, axis=0, prepend=numpy.zeros_like(pixels[:1]))
    rows = b"".join(b"\2" + row.tobytes() for row in differences)

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    height, width, _ = pixels.shape
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(
        ">IIBBBBB", width, height, 8, 2, 0, 0, 0)) + chunk(
            b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def expose(radiance):
    """sRGB, as `render --exposure` writes it."""
    linear = numpy.clip(radiance * 2**EXPOSURE, 0, 1)
    curve = numpy.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear**(1 / 2.4) - 0.055)
    return numpy.rint(255 * curve).astype("u1")


def preprocess(options):
    options.folder.mkdir(parents=True, exist_ok=True)
    partition = options.folder / "carafe.hpm"
    if not partition.exists():
        subprocess.run([options.bin / "preprocess", SCENE, "-o", partition], check=True)


def picture(options):
    preprocess(options)
    stats = options.folder / "picture.json"
    subprocess.run([
        options.bin / "render", SCENE, options.folder / "carafe.hpm", "-o", IMAGES / "carafe.png",
        "-o", options.folder / "picture.exr", "--size", "1600", "--photons", "8000000",
        "--neighbours", "30", "--exposure", str(EXPOSURE), "--time", str(options.seconds or 1500),
        "--state", options.folder / "picture.state", "--stats", stats], check=True)
    seconds = sum(json.loads(stats.read_text())["processor_seconds"].values())
    print(f"{passes_of(stats)} passes, {seconds:.0f} processor seconds in this run")


def passes_of(stats):
    """Passes in the image of a render, from its statistics."""
    return json.loads(stats.read_text())["passes_done"]


def hipmap_strip(options):
    """The image and its error map; prints what they cost."""
    kept = beside_cycles.Kept(options.folder / "strip.json")
    stats = options.folder / "strip_stats.json"

    def render(passes):
        return beside_cycles.hipmap(
            options, SCENE, "-o", options.folder / "strip.png", "--exposure", EXPOSURE, "--passes",
            passes, "--state", options.folder / "strip.state", "--error-image",
            options.folder / "strip_error.png", "--stats", stats)

    few = kept.of("hipmap few", lambda: render(FIRST_PASSES))
    passes = max(FIRST_PASSES + 1, round(FIRST_PASSES * options.seconds / few))
    rest = kept.of(f"hipmap {passes}", lambda: render(passes))
    print(f"hipmap: {few + rest:.0f} processor seconds, {passes_of(stats)} passes")
    return [read_png(options.folder / name) for name in ("strip.png", "strip_error.png")]


def cycles_strip(options):
    """The image; prints what it costs."""
    kept = beside_cycles.Kept(options.folder / "strip.json")
    few = kept.of("cycles few", lambda: beside_cycles.cycles(options, SCENE, FEW_SAMPLES, 99))
    samples = max(1, round(FEW_SAMPLES * options.seconds / few))
    spent = kept.of(f"cycles {samples}", lambda: beside_cycles.cycles(options, SCENE, samples, 1))
    print(f"Cycles: {spent:.0f} processor seconds, {samples} samples per pixel")
    image = beside_cycles.read_pfm(options.folder / f"carafe.cycles.{samples}.1.pfm")
    return expose(image[::-1])


def strip(options):
    options.seconds = options.seconds or 200
    options.size = (800, 400)
    preprocess(options)
    image, error = hipmap_strip(options)
    parts = [image, cycles_strip(options), error]
    height = max(part.shape[0] for part in parts)
    padded = []
    for part in parts:
        below = height - part.shape[0]
        padded.append(numpy.pad(part, ((0, below), (0, GAP), (0, 0)), constant_values=255))
    write_png(IMAGES / "carafe_cycles.png", numpy.concatenate(padded, axis=1)[:, :-GAP])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("bin", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("what", choices=("picture", "strip"))
    parser.add_argument("--seconds", type=float)
    options = parser.parse_args()
    options.bin, options.folder = options.bin.resolve(), options.folder.resolve()
    {"picture": picture, "strip": strip}[options.what](options)


if __name__ == "__main__":
    sys.exit(main())
