#!/usr/bin/env python3
"""Repeats the experiment of Mpawulo's dissertation (2005) on the scenes beside it.

    experiments/run_experiment.py                      # writes docs/experiments.md
    experiments/run_experiment.py --quick --scenes 1   # a look; writes below out/

Needs build/release/bin (./pipeline.sh builds it) and, for the figures, Debian's python3-matplotlib.
"""

import argparse
import itertools
import json
import os
import pathlib
import platform
import subprocess
import sys
import tempfile

import figures
import measure
import tables

QUICK = {"divide": 10, "size": 96, "repeats": 1}
FULL = {"divide": 1, "size": 256, "repeats": 3}


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--scenes", type=int, nargs="+", choices=measure.SCENES,
                        default=list(measure.SCENES), help="which of them [1 2 3]")
    parser.add_argument("--quick", action="store_true",
                        help="a tenth of the photons and neighbours, small images, one run each")
    parser.add_argument("--to", type=pathlib.Path,
                        help="folder to write to [docs; with --quick out/experiments]")
    parser.add_argument("--tools", type=pathlib.Path, default=measure.ROOT / "build/release/bin",
                        help="folder of the programs [build/release/bin]")
    options = parser.parse_args()
    options.to = options.to or measure.ROOT / ("out/experiments" if options.quick else "docs")
    return options


def commit():
    command = ["git", "-C", str(measure.ROOT), "describe", "--always", "--dirty"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return done.stdout.strip() or "unknown"


def machine():
    """The processor as it calls itself, and the cores."""
    name = platform.machine()
    try:
        for line in pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                name = line.split(":", 1)[1].strip()
                break
    except OSError:
        pass
    return f"{name}, {os.cpu_count()} cores"


def run_all(bench, scenes):
    """Rows by scene, test and mode, with progress on standard error."""
    rows, total = [], len(scenes) * len(measure.TESTS) * len(measure.MODES)
    for scene in scenes:
        measure.make_partition(bench, scene)
        for test, mode in itertools.product(range(1, len(measure.TESTS) + 1), measure.MODES):
            row = measure.measure(bench, scene, test, mode)
            rows.append(row)
            print(f"[{len(rows)}/{total}] scene {scene}, test {test}, {mode}: "
                  f"{row['stored']:,} photons, net {row['net_s']:.3f} s", file=sys.stderr)
    return rows


def write(results, folder):
    images = folder / "images"
    images.mkdir(parents=True, exist_ok=True)
    drawn = figures.draw_all(results["rows"], images)
    if not drawn:
        print("no figures: matplotlib is not installed (Debian: python3-matplotlib)",
              file=sys.stderr)
    links = {scene: f"images/{name}" for scene, name in drawn.items()}
    readme = os.path.relpath(measure.ROOT / "experiments/README.md", folder)
    (folder / "experiments.json").write_text(json.dumps(results, indent=1) + "\n")
    (folder / "experiments.md").write_text(tables.document(results, links, readme))
    print(f"wrote {folder / 'experiments.md'}", file=sys.stderr)


def main():
    options = parse_options()
    if not (options.tools / "render").exists():
        sys.exit(f"error: {options.tools}/render is missing; run ./pipeline.sh first")
    settings = QUICK if options.quick else FULL
    about = {"commit": commit(), "machine": machine(), **settings}
    with tempfile.TemporaryDirectory() as folder:
        bench = measure.Bench(options.tools, pathlib.Path(folder), **settings)
        rows = run_all(bench, options.scenes)
    write({"about": about, "rows": rows}, options.to)


if __name__ == "__main__":
    main()
