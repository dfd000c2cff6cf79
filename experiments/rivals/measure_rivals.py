#!/usr/bin/env python3
"""Measures the rivals of photon maps beside hipmap: error against processor time, and memory.

    experiments/rivals/measure_rivals.py           # writes docs/rivals.md
    experiments/rivals/measure_rivals.py --quick   # a look; writes below out/

Needs preprocess, render and rivals in build/release/bin, and for the figures Debian's
python3-matplotlib.  Each result is kept as it comes: the same command goes on with what is left.
"""

import argparse
import dataclasses
import datetime
import json
import os
import pathlib
import sys

import rival_plan as plan
import rival_plots as plots
import rival_report as report
from rival_lab import Lab, stages

sys.path.append(str(plan.ROOT / "experiments"))
import programs
from notebook import Notebook, do_stages

DOCUMENT = plan.ROOT / "docs/rivals.md"


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--scenes", nargs="+", choices=plan.SCENES, default=list(plan.SCENES),
                        metavar="NAME", help=f"which of them [{' '.join(plan.SCENES)}]")
    parser.add_argument("--quick", action="store_true", help="small images, two seeds: seconds")
    parser.add_argument("--to", type=pathlib.Path,
                        help="folder to write to [docs; with --quick out/rivals_quick]")
    parser.add_argument("--work", type=pathlib.Path, help="folder for what was done so far "
                        "[out/rivals; with --quick out/rivals_quick]")
    parser.add_argument("--tools", type=pathlib.Path, default=plan.ROOT / "build/release/bin",
                        help="folder of the programs [build/release/bin]")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(),
                        help="programs at a time, of one thread each [all cores]")
    parser.add_argument("--again", action="store_true",
                        help="measure nothing: write the document from results.json")
    options = parser.parse_args()
    out = plan.ROOT / "out" / ("rivals_quick" if options.quick else "rivals")
    options.work = options.work or out
    options.to = options.to or (out if options.quick else plan.ROOT / "docs")
    return options


def about(options, study):
    """What results must agree in to be of one run."""
    settings = {name: [method.arguments(point, study) for point in range(method.count())]
                for name, method in plan.METHODS.items()}
    return {"programs": programs.digest(options.tools, ("preprocess", "render", "rivals")),
            "machine": programs.machine(), "study": dataclasses.asdict(study), "settings": settings}


def run(options, lab):
    """The results; the earlier ones of the work folder among them."""
    notebook = Notebook(options.work / "results.json", about(options, lab.study))
    scenes = [plan.SCENES[name] for name in options.scenes]
    for scene in scenes:
        lab.make_partition(scene)
        for kind in plan.KINDS:
            for number in (0, 1):
                if not lab.half(scene, kind, number).exists():
                    notebook.forget(f"reference/{scene.name}/{kind}/{number}")
    do_stages(stages(lab, scenes), notebook, options.jobs)
    notebook.results["date"] = datetime.date.today().isoformat()
    return notebook.results


def main():
    options = parse_options()
    options.work.mkdir(parents=True, exist_ok=True)
    lab = Lab(options.tools, options.work, plan.QUICK if options.quick else plan.FULL)
    folder = options.to / "rivals"
    file = folder / "results.json"
    if options.again:
        results = json.loads(file.read_text())
    else:
        results = run(options, lab)
        folder.mkdir(parents=True, exist_ok=True)
        file.write_text(json.dumps(results) + "\n")
    drawn = plots.draw_all(results, lab, folder)
    if not drawn:
        print("no figures: matplotlib is not installed (Debian: python3-matplotlib)",
              file=sys.stderr)
    text = report.write(DOCUMENT.read_text(encoding="utf-8"), results, drawn)
    (options.to / "rivals.md").write_text(text, encoding="utf-8")
    print(f"wrote {options.to / 'rivals.md'}", file=sys.stderr)


if __name__ == "__main__":
    main()
