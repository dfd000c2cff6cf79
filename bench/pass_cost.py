#!/usr/bin/env python3
"""Measures what a pass costs, by stage and number of photons.

    bench/pass_cost.py RENDER[,BEFORE] SCENE... [--photons N...] [--size W] [--passes P]
                       [--most RATIO]

Prints, for every scene and number of photons per pass, processor seconds of a pass by stage (of all
threads together, so that other work on the machine disturbs little), and beside them those of the
tool BEFORE if one is given.  Exit code 1 if a pass with fewer photons costs more than RATIO times
one with more.  SCENE.hpm must lie beside SCENE.glb.
"""

import argparse
import json
import os
import resource
import subprocess
import sys
import tempfile

STAGES = ("photons", "maps", "image")


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(tool, scene, folder, options, passes):
    """(processor seconds of the whole run, statistics)."""
    stats = os.path.join(folder, "stats.json")
    begun = processor_seconds()
    subprocess.run([tool, scene, os.path.splitext(scene)[0] + ".hpm", "-o",
                    os.path.join(folder, "image.pfm"), "--stats", stats, "--passes", str(passes),
                    *options], check=True, stderr=subprocess.DEVNULL)
    with open(stats, encoding="utf-8") as file:
        return processor_seconds() - begun, json.load(file)


def cost_of_pass(tool, scene, options, passes):
    """Seconds of a pass as a whole and by stage; where a stage is not told, as a whole alone, by runs
    of different length."""
    with tempfile.TemporaryDirectory() as folder:
        long, stats = run(tool, scene, folder, options, 1 + passes)
        told = [stats["processor_seconds"].get(stage) for stage in STAGES]
        if None not in told:
            return sum(told) / (1 + passes), [seconds / (1 + passes) for seconds in told]
        short, _ = run(tool, scene, folder, options, 1)
    return (long - short) / passes, [None] * len(STAGES)


def row(scene, photons, tools, options):
    name = os.path.splitext(os.path.basename(scene))[0]
    settings = ["--photons", str(photons), "--size", str(options.size)]
    whole, stages = cost_of_pass(tools[0], scene, settings, options.passes)
    cells = [name, f"{photons:,}", *("-" if s is None else f"{s:.2f}" for s in stages),
             f"{whole:.2f}"]
    if len(tools) > 1:
        before, _ = cost_of_pass(tools[1], scene, settings, options.passes)
        cells += [f"{before:.2f}", f"{before / whole:.1f}"]
    print("| " + " | ".join(cells) + " |", flush=True)
    return whole


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tools")
    parser.add_argument("scenes", nargs="+")
    parser.add_argument("--photons", type=int, nargs="+", default=[20_000, 200_000, 1_000_000])
    parser.add_argument("--size", type=int, default=160)
    parser.add_argument("--passes", type=int, default=2)
    parser.add_argument("--most", type=float, default=1.05)
    options = parser.parse_args()
    tools = options.tools.split(",")
    titles = ["scene", "photons a pass", *(f"{stage}, s" for stage in STAGES), "pass, s"]
    titles += ["before, s", "before / now"] if len(tools) > 1 else []
    print("| " + " | ".join(titles) + " |\n|" + "---|" * len(titles))
    dearer = []
    for scene in options.scenes:
        costs = [row(scene, photons, tools, options) for photons in sorted(options.photons)]
        dearer += [scene for few, more in zip(costs, costs[1:]) if few > options.most * more]
    for scene in dearer:
        print(f"{scene}: fewer photons cost more")
    return 1 if dearer else 0


if __name__ == "__main__":
    sys.exit(main())
