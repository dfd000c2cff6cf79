#!/usr/bin/env python3
"""Measures the true error of images against the processor's time, by scene and method.

    experiments/accuracy/measure_accuracy.py           # writes docs/accuracy.md
    experiments/accuracy/measure_accuracy.py --quick   # a look; writes below out/

Needs preprocess and render in build/release/bin, and for the plots Debian's python3-matplotlib.
Each result is kept as it comes: the same command goes on with what is left.
"""

import argparse
import dataclasses
import datetime
import itertools
import json
import os
import pathlib
import sys

import jobs
import plan
import plots
import write_up
from lab import Lab

sys.path.append(str(plan.ROOT / "experiments"))
import programs
from notebook import Notebook, do_stages


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--scenes", nargs="+", choices=plan.SCENES, default=list(plan.SCENES),
                        metavar="NAME", help=f"which of them [{' '.join(plan.SCENES)}]")
    parser.add_argument("--quick", action="store_true",
                        help="small images, few photons, two seeds: seconds")
    parser.add_argument("--minutes", type=float, default=plan.FULL_MINUTES,
                        help="that all scenes are to take two cores, about "
                        f"[{plan.FULL_MINUTES}]")
    parser.add_argument("--to", type=pathlib.Path,
                        help="folder to write to [docs; with --quick out/accuracy_quick]")
    parser.add_argument("--work", type=pathlib.Path, help="folder for what was done so far "
                        "[out/accuracy; with --quick out/accuracy_quick]")
    parser.add_argument("--tools", type=pathlib.Path, default=plan.ROOT / "build/release/bin",
                        help="folder of the programs [build/release/bin]")
    parser.add_argument("--again", action="store_true",
                        help="measure nothing: write the document from results.json")
    options = parser.parse_args()
    out = plan.ROOT / "out" / ("accuracy_quick" if options.quick else "accuracy")
    options.work = options.work or out
    options.to = options.to or (out if options.quick else plan.ROOT / "docs")
    return options


def study_of(options):
    if options.quick:
        return plan.QUICK
    return dataclasses.replace(plan.FULL, share=options.minutes / plan.FULL_MINUTES)


def about(options, study):
    """What results must agree in to be of one run."""
    settings = {setting.name: setting.arguments(study)
                for setting in (*plan.SETTINGS.values(), *plan.MINUTE_SETTINGS.values())}
    return {"programs": programs.digest(options.tools, ("preprocess", "render")),
            "machine": programs.machine(), "study": dataclasses.asdict(study),
            "settings": settings}


def run(options):
    """The results; the earlier ones of the work folder among them."""
    study = study_of(options)
    options.work.mkdir(parents=True, exist_ok=True)
    notebook = Notebook(options.work / "results.json", about(options, study))
    lab = Lab(options.tools, options.work, study)
    scenes = [plan.SCENES[name] for name in options.scenes]
    for scene in scenes:
        lab.make_partition(scene)
        for by_filter, half in itertools.product(plan.filters_of(scene), (0, 1)):
            if not lab.half(scene, by_filter, half).exists():
                notebook.forget(f"reference/{scene.name}/{by_filter}/{half}")
    do_stages(jobs.stages(lab, notebook, scenes), notebook, os.cpu_count())
    notebook.results["date"] = datetime.date.today().isoformat()
    return notebook.results


def main():
    options = parse_options()
    folder = options.to / "accuracy"
    file = folder / "results.json"
    if options.again:
        results = json.loads(file.read_text())
    else:
        results = run(options)
        folder.mkdir(parents=True, exist_ok=True)
        file.write_text(json.dumps(results) + "\n")
    drawn = plots.draw_all(results, folder)
    if not drawn:
        print("no plots: matplotlib is not installed (Debian: python3-matplotlib)",
              file=sys.stderr)
    (options.to / "accuracy.md").write_text(write_up.write(results, drawn))
    print(f"wrote {options.to / 'accuracy.md'}", file=sys.stderr)


if __name__ == "__main__":
    main()
