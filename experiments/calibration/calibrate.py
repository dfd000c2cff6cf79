#!/usr/bin/env python3
"""Counts how often the interval that render states holds the true error of its image.

    experiments/calibration/calibrate.py                # writes docs/calibration.md
    experiments/calibration/calibrate.py --seeds 4      # a look; writes below out/

Needs preprocess, render and compare_images in build/release/bin.
Each image's outcome is kept as it comes: the same command goes on with what is left.
"""

import argparse
import datetime
import json
import os
import pathlib
import sys

import jobs
import report
import runs
import programs
from notebook import Notebook, do_stages

SEEDS = 50


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--seeds", type=int, default=SEEDS, help=f"images of each [{SEEDS}]")
    parser.add_argument("--scenes", nargs="+", choices=sorted(runs.SCENES),
                        default=sorted(runs.SCENES), metavar="NAME",
                        help=f"which of them [{' '.join(sorted(runs.SCENES))}]")
    parser.add_argument("--integrators", nargs="+", choices=sorted(runs.INTEGRATORS),
                        default=list(runs.INTEGRATORS), metavar="NAME",
                        help=f"which of them [{' '.join(runs.INTEGRATORS)}]")
    parser.add_argument("--size", type=int, default=24, help="pixels across an image [24]")
    parser.add_argument("--to", type=pathlib.Path,
                        help="folder to write to [docs; with fewer seeds out/calibration]")
    parser.add_argument("--work", type=pathlib.Path, default=runs.ROOT / "out/calibration",
                        help="folder for what was done so far [out/calibration]")
    parser.add_argument("--tools", type=pathlib.Path, default=runs.ROOT / "build/release/bin",
                        help="folder of the programs [build/release/bin]")
    parser.add_argument("--again", action="store_true",
                        help="render nothing: write the document from calibration.json")
    options = parser.parse_args()
    whole = options.again or options.seeds >= SEEDS
    options.to = options.to or runs.ROOT / ("docs" if whole else "out/calibration")
    return options


def about(options):
    """What results must agree in to be of one run."""
    methods = (*runs.INTEGRATORS.values(), runs.LONG_PATH, runs.LONG_PROGRESSIVE)
    return {"programs": programs.digest(options.tools, ("preprocess", "render", "compare_images")),
            "size": options.size, "methods": {method.name: [*method.options, method.pilots] for method in methods},
            "aim": [runs.BETTER, runs.PART_OF_FIRST, runs.FIRST_CHECK, runs.MOST_ERROR,
                    runs.REFERENCE_SEED]}


def run(options):
    """The results; the earlier ones of the work folder among them."""
    options.work.mkdir(parents=True, exist_ok=True)
    notebook = Notebook(options.work / "notebook.json", about(options))
    lab = runs.Lab(options.tools, options.work, options.size)
    for scene in options.scenes:
        lab.make_partition(scene)
        for method in jobs.methods(scene, options.integrators):
            if not lab.reference(scene, method).exists():
                notebook.forget(jobs.reference_key(scene, method))
    stages = jobs.stages(lab, notebook, options.scenes, options.integrators, options.seeds)
    do_stages(stages, notebook, os.cpu_count())
    return {"date": datetime.date.today().isoformat(), "size": options.size,
            "cases": jobs.cases(notebook, options.seeds)}


def main():
    options = parse_options()
    file = options.to / "calibration.json"
    options.to.mkdir(parents=True, exist_ok=True)
    if options.again:
        results = json.loads(file.read_text())
    else:
        results = run(options)
        file.write_text(json.dumps(results) + "\n")
    (options.to / "calibration.md").write_text(report.write(results))
    print(f"wrote {options.to / 'calibration.md'}", file=sys.stderr)


if __name__ == "__main__":
    main()
