#!/usr/bin/env python3
"""Compares the images of two builds over all bundled scenes.

    images_equal.py BEFORE AFTER [--scene NAME ...] [--seeds N] [--size N]

BEFORE and AFTER are folders with `preprocess` and `render`.  Each scene of assets/ is rendered by
each integrator with N seeds by both.  Prints a Markdown table: "same bits", or the ratio of the
means of the images with its standard error over the seeds.  Ends with 1 if a ratio is more than
3.5 standard errors from 1 (some 90 are tested).  Pixels above ten times an image's mean are clamped,
in both, because a single bright sample would hide any difference.
"""

import argparse
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.append(str(ROOT / "experiments/accuracy"))
import arithmetic  # noqa: E402

ASSETS = ROOT / "assets"
INTEGRATORS = ("progressive", "path", "direct")


def clamped_mean(values):
    limit = 10 * statistics.fmean(values)
    return statistics.fmean(min(value, limit) for value in values)


def render(folder, scene, partition, out, arguments):
    command = [os.path.join(folder, "render"), scene, partition, "-o", out, *arguments]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return arithmetic.read_pfm(out)[1]


def compare(before, after, scene, integrator, options, scratch):
    """One cell of the table, and how many standard errors the ratio is from 1."""
    means = ([], [])
    same = True
    for seed in range(1, options.seeds + 1):
        arguments = ["--integrator", integrator, "--size", str(options.size), "--passes", "2", "--photons", "5000",
                     "--samples", "4", "--seed", str(seed)]
        pair = [render(folder, scene, f"{scratch}/{place}.hpm", f"{scratch}/{place}.pfm", arguments)
                for place, folder in enumerate((before, after))]
        same = same and pair[0] == pair[1]
        if same and seed == 2:
            return "same bits", 0.0
        for values, mean in zip(pair, means):
            mean.append(clamped_mean(values))
    if same:
        return "same bits", 0.0
    ratio = statistics.fmean(means[1]) / statistics.fmean(means[0])
    errors = [statistics.stdev(mean) / statistics.fmean(mean) / len(mean) ** 0.5 for mean in means]
    error = (errors[0] ** 2 + errors[1] ** 2) ** 0.5
    return f"{ratio:.4f} +- {error:.4f}", (ratio - 1) / error if error > 0 else float("inf")


def compare_scene(scene, options, scratch):
    for place, folder in enumerate((options.before, options.after)):
        subprocess.run([os.path.join(folder, "preprocess"), scene, "-o", f"{scratch}/{place}.hpm"], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return [compare(options.before, options.after, scene, integrator, options, scratch)
            for integrator in INTEGRATORS]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("before")
    parser.add_argument("after")
    parser.add_argument("--scene", nargs="*", default=[])
    parser.add_argument("--seeds", type=int, default=8)
    parser.add_argument("--size", type=int, default=32)
    options = parser.parse_args()
    scenes = [path for folder in (ASSETS, ASSETS / "effects") for path in sorted(folder.glob("*.glb"))]
    print(f"| scene | {' | '.join(INTEGRATORS)} |\n|{'---|' * (1 + len(INTEGRATORS))}")
    worst = 0.0
    with tempfile.TemporaryDirectory() as scratch:
        for path in scenes:
            if options.scene and path.stem not in options.scene:
                continue
            cells = compare_scene(str(path), options, scratch)
            print(f"| {path.stem} | {' | '.join(text for text, _ in cells)} |", flush=True)
            worst = max([worst] + [abs(distance) for _, distance in cells])
    print(f"\nfarthest from 1: {worst:.1f} standard errors")
    return 1 if worst > 3.5 else 0


if __name__ == "__main__":
    sys.exit(main())
