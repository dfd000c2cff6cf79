#!/usr/bin/env python3
"""Measures what errors cost hipmap and Blender's Cycles in the same .glb.

    bench/beside_cycles.py BIN FOLDER SCENE... [--size W H] [--passes P] [--renders N]
                           [--samples S] [--reference SECONDS]

BIN has `render` and `preprocess`; needs blender on the PATH and python3-numpy.  Both filter by the
box.  Prints, for every scene, processor seconds (of all threads) and true error (root of relMSE,
docs/error.md (3)) of images of hipmap after ever more passes, against two references of hipmap's
own with narrow radii (the product of an image's differences from both has none of their noise), and
of Cycles, by the variance between N renders of S samples; then seconds to 10 % and 5 %, by the longest run, its square error falling as one over time.  Errors in brackets
leave out the pixel of a thousand that is farthest off, of both alike: one sample of a light in a
mirror of a mirror may outweigh a whole image.  Each is held to its own converged image, as their
models of materials differ (docs/cycles.md).  Images and states are kept in FOLDER; a run that was
stopped goes on with them.
"""

import argparse
import json
import math
import pathlib
import resource
import subprocess
import sys

import numpy

HERE = pathlib.Path(__file__).resolve().parent
sys.path.append(str(HERE.parent / "experiments/accuracy"))
import arithmetic  # noqa: E402
import in_blender  # noqa: E402

FEW = 4
MARKS = (0.1, 0.05)


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def read_pfm(path):
    width, numbers = arithmetic.read_pfm(path)
    return numpy.array(numbers).reshape(-1, width, 3).astype(float)


def weights(reference):
    return 1 / (reference**2 + (0.1 * reference.mean())**2)


def errors2(square, weight):
    """Of relMSE with all pixels, and without the thousandth that is farthest off."""
    by_pixel = numpy.sort((square * weight).mean(axis=2).ravel())
    return numpy.array([by_pixel.mean(), by_pixel[:int(0.999 * by_pixel.size)].mean()])


class Kept:
    """Figures by name, in a file."""

    def __init__(self, path):
        self.path = path
        self.figures = json.loads(path.read_text()) if path.exists() else {}

    def of(self, name, make):
        if name not in self.figures:
            self.figures[name] = make()
            self.path.write_text(json.dumps(self.figures, indent=1))
        return self.figures[name]


def cycles(options, scene, samples, seed):
    """The processor's seconds."""
    image = options.folder / f"{scene.stem}.cycles.{samples}.{seed}.pfm"
    return in_blender.processor_seconds(HERE / "cycles_import.py", scene,
                                        [scene, image, *options.size, samples, seed, 0],
                                        options.folder)


def hipmap(options, scene, *arguments):
    """The processor's seconds."""
    begun = processor_seconds()
    subprocess.run([options.bin / "render", scene, options.folder / f"{scene.stem}.hpm", "--size",
                    "x".join(map(str, options.size)), "--filter", "box", *map(str, arguments)],
                   check=True, stderr=subprocess.DEVNULL)
    return processor_seconds() - begun


def measure_cycles(options, scene, kept):
    """[(seconds, [square errors])] of one render and of the mean of all."""
    few = kept.of("cycles few", lambda: cycles(options, scene, FEW, 1))
    spent = [kept.of(f"cycles {seed}", lambda: cycles(options, scene, options.samples, seed))
             for seed in range(1, options.renders + 1)]
    images = numpy.array(
        [read_pfm(options.folder / f"{scene.stem}.cycles.{options.samples}.{seed}.pfm")
         for seed in range(1, options.renders + 1)])
    each = (numpy.mean(spent) - few) / (options.samples - FEW)
    start = max(0.0, few - FEW * each)
    one = errors2(images.var(axis=0, ddof=1), weights(images.mean(axis=0)))
    return [(start + n * options.samples * each, one / n) for n in (1, options.renders)]


def measure_hipmap(options, scene, kept):
    partition = options.folder / f"{scene.stem}.hpm"
    if not partition.exists():
        subprocess.run([options.bin / "preprocess", scene, "-o", partition], check=True,
                       stderr=subprocess.DEVNULL)
    references = [options.folder / f"{scene.stem}.reference{number}.pfm" for number in (1, 2)]
    spent, passes = 0.0, 4
    images = []
    while passes <= options.passes:
        image = options.folder / f"{scene.stem}.{passes}.pfm"
        state = options.folder / f"{scene.stem}.state"
        spent += kept.of(f"hipmap {passes}",
                         lambda: hipmap(options, scene, "-o", image, "--state", state,
                                        "--passes", passes))
        images.append((spent, image))
        passes *= 2
    for number, reference in enumerate(references):
        kept.of(reference.stem, lambda: hipmap(options, scene, "-o", reference, "--photons", 2000000,
                                               "--neighbours", 20, "--seed", 998 + number,
                                               "--fireflies", "keep", "--time", options.reference))
    one, two = map(read_pfm, references)
    weight = weights((one + two) / 2)
    return [(seconds, errors2((read_pfm(image) - one) * (read_pfm(image) - two), weight))
            for seconds, image in images]


def in_brackets(numbers, form):
    return f"{form(numbers[0])} ({form(numbers[1])})"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("bin", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("scenes", type=pathlib.Path, nargs="+")
    parser.add_argument("--size", type=int, nargs=2, default=[480, 320])
    parser.add_argument("--passes", type=int, default=32)
    parser.add_argument("--renders", type=int, default=8)
    parser.add_argument("--samples", type=int, default=64)
    parser.add_argument("--reference", type=float, default=300, help="seconds of each")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    print("| scene | by | images: seconds, error | seconds to 10 % | seconds to 5 % |")
    print("|---|---|---|---|---|")
    for scene in options.scenes:
        kept = Kept(options.folder / f"{scene.stem}.json")
        for name, measure in (("hipmap", measure_hipmap), ("Cycles", measure_cycles)):
            points = measure(options, scene.resolve(), kept)
            cells = "; ".join(
                f"{seconds:.0f} s, " + in_brackets(two, lambda e2: f"{100 * math.sqrt(e2):.1f} %")
                for seconds, two in points)
            longest, two = points[-1]
            marks = [in_brackets(longest * two / mark**2, lambda s: f"{s:,.0f}") for mark in MARKS]
            print(f"| {scene.stem} | {name} | {cells} | {' | '.join(marks)} |", flush=True)


if __name__ == "__main__":
    main()
