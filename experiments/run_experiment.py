#!/usr/bin/env python3
"""Does the experiment of Mpawulo's dissertation (2005) again, on the scenes beside it.

    experiments/run_experiment.py                      # writes docs/experiments.md
    experiments/run_experiment.py --quick --scenes 1   # a look; writes below out/
    experiments/run_experiment.py --check              # compares identical computations of the last run

Needs the programs in build/release/bin and, for the plots, Debian's python3-matplotlib.
"""

import argparse
import dataclasses
import datetime
import itertools
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

import document
import figures
import identical
import measure
import pictures
import programs
import questions
from progress import Progress

QUICK = {"divide": 10, "size": 96, "most_rounds": 1, "net_seconds": 0}
FULL = {"divide": 1, "size": 256, "most_rounds": 12, "net_seconds": 0.5}
PROGRAMS = ("preprocess", "render", "crease_profile", "filter_radius", "rebuild_maps")
# Seconds of a light path and of a photon found, about; for the time left.
PATH_SECONDS, FOUND_SECONDS, START_SECONDS = 1.5e-6, 1e-7, 0.05


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--scenes", type=int, nargs="+", choices=measure.SCENES,
                        default=list(measure.SCENES), help="which of them [1 2 3]")
    parser.add_argument("--tests", type=int, nargs="+", choices=measure.TESTS,
                        default=list(measure.TESTS), help="which of them [1 2 3 4 5]")
    parser.add_argument("--quick", action="store_true",
                        help="a tenth of the photons and neighbours, small images, one run each")
    parser.add_argument("--rounds", type=int,
                        help="times to run each at most [12; with --quick 1]")
    parser.add_argument("--to", type=pathlib.Path,
                        help="folder to write to [docs; with --quick out/experiments]")
    parser.add_argument("--tools", type=pathlib.Path, default=measure.ROOT / "build/release/bin",
                        help="folder of the programs [build/release/bin]")
    parser.add_argument("--again", action="store_true",
                        help="measure nothing: write the document and plots from results.json")
    parser.add_argument("--check", action="store_true",
                        help="measure nothing: say which identical computations of results.json differ by "
                             "more than their intervals; exit code 1 if any do")
    parser.add_argument("--update", action="store_true",
                        help="measure these scenes and tests anew, keep the rest of results.json")
    options = parser.parse_args()
    options.to = options.to or measure.ROOT / ("out/experiments" if options.quick else "docs")
    return options


def weight(bench, setting):
    """Seconds that a rendering takes, about."""
    found = bench.size ** 2 * 0.75 * measure.neighbours(bench, setting.test)
    paths = measure.light_paths(bench, setting.scene, setting.test)
    return START_SECONDS + PATH_SECONDS * paths + FOUND_SECONDS * found


class Measuring:
    """Measures batches of settings and says how far they are."""

    def __init__(self, bench, batches):
        self.bench = bench
        weights = [self.batch_weight(batch, self.rounds(batch)) for batch in batches]
        self.progress = Progress(sum(self.rounds(batch) * len(batch) for batch in batches),
                                 sum(weights))

    def rounds(self, batch):
        return measure.rounds(self.bench, batch[0].scene, batch[0].test)

    def batch_weight(self, batch, rounds):
        return rounds * sum(weight(self.bench, setting) for setting in batch)

    def ran(self, setting, row):
        self.progress.ran(f"scene {setting.scene}, test {setting.test}, {setting.mode}, "
                          f"{setting.tree}: {row['stored']:,} photons", weight(self.bench, setting))

    def rows(self, batch):
        rows = measure.measure_together(self.bench, batch, self.ran)
        spared = self.rounds(batch) - len(rows[0]["image_runs"])
        self.progress.skip(spared * len(batch), self.batch_weight(batch, spared))
        return rows


def commit():
    command = ["git", "-C", str(measure.ROOT), "describe", "--always", "--dirty"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return done.stdout.strip() or "unknown"


def main_batch(scene, test):
    """The settings of one scene and test, to be measured in turn."""
    return [measure.Setting(scene, test, mode, tree) for tree in measure.TREES
            for mode in measure.MODES]


def run_all(bench, options):
    """The results, but for what the run itself was."""
    main = list(itertools.starmap(main_batch, itertools.product(options.scenes, options.tests)))
    asked = questions.batches(options.scenes, options.tests)
    print("measuring creases, filter radii and rebuilt maps", file=sys.stderr)
    singly = {"creases": questions.run_creases(bench, 10_000 // bench.divide),
              "filter": questions.run_filter(bench, options.scenes, options.tests),
              "rebuilds": questions.run_rebuilds(bench, options.scenes, options.tests)}
    measuring = Measuring(bench, main + [batch for batches in asked.values() for batch in batches])
    return {**singly, "rows": [row for batch in main for row in measuring.rows(batch)],
            "questions": questions.measure_batches(asked, measuring.rows)}


def write(results, drawn, to):
    folder = to / "experiments"
    plots = figures.draw_all(results, folder)
    if not plots:
        print("no plots: matplotlib is not installed (Debian: python3-matplotlib)",
              file=sys.stderr)
    links = {name: f"experiments/{file}" for name, file in {**drawn, **plots}.items()}
    root = os.path.relpath(measure.ROOT, to)
    (to / "experiments.md").write_text(document.write(results, links, root))
    print(f"wrote {to / 'experiments.md'}", file=sys.stderr)


def run(options, results_file):
    start = time.monotonic()
    settings = dict(QUICK if options.quick else FULL)
    settings["most_rounds"] = options.rounds or settings["most_rounds"]
    with tempfile.TemporaryDirectory() as folder:
        bench = measure.Bench(options.tools, pathlib.Path(folder), **settings)
        about = {"date": datetime.date.today().isoformat(), "commit": commit(),
                 "machine": programs.machine(), **settings}
        for scene in options.scenes:
            measure.make_partition(bench, scene)
        results = {"about": about, "pictures": {}, **run_all(bench, options)}
        about["minutes"] = (time.monotonic() - start) / 60
        results_file.write_text(json.dumps(results, indent=1) + "\n")
        print("rendering the scenes", file=sys.stderr)
        results["pictures"] = pictures.draw_all(
            bench, options.scenes, results_file.parent,
            pictures.QUICK_RENDER if options.quick else pictures.RENDER)
    results_file.write_text(json.dumps(results, indent=1) + "\n")
    return results


def update(options, results_file):
    """Rows of the scenes and tests asked for, measured anew; the rest as it was."""
    results = json.loads(results_file.read_text())
    with tempfile.TemporaryDirectory() as folder:
        bench = measure.Bench(options.tools, pathlib.Path(folder),
                              **{name: results["about"][name] for name in FULL})
        bench = dataclasses.replace(bench, rounds_asked=options.rounds)
        for scene in options.scenes:
            measure.make_partition(bench, scene)
        batches = list(itertools.starmap(main_batch,
                                         itertools.product(options.scenes, options.tests)))
        measuring = Measuring(bench, batches)
        rows = [row for batch in batches for row in measuring.rows(batch)]
    new = {(row["scene"], row["test"]): row for row in rows}
    kept = [row for row in results["rows"] if (row["scene"], row["test"]) not in new]
    results["about"].setdefault("again", []).extend(
        f"scene {scene}, test {test} ({len(row['image_runs'])} rounds)"
        for (scene, test), row in new.items())
    results["rows"] = sorted(kept + rows, key=lambda row: (row["scene"], row["test"]))
    results_file.write_text(json.dumps(results, indent=1) + "\n")
    return results


def check(results, required):
    """Ends this program if identical computations differ.  required: also if none were measured."""
    complaints = identical.complaints(results)
    for line in complaints:
        print(line, file=sys.stderr)
    measured = any(identical.is_measured(pair[2]) for pair in identical.find_all(results))
    if complaints and (measured or required):
        sys.exit(1)
    if not complaints:
        print("identical computations agree within their intervals", file=sys.stderr)


def main():
    options = parse_options()
    results_file = options.to / "experiments" / "results.json"
    results_file.parent.mkdir(parents=True, exist_ok=True)
    if options.check:
        check(json.loads(results_file.read_text()), True)
        return
    if options.again:
        results = json.loads(results_file.read_text())
    else:
        missing = [name for name in PROGRAMS if not (options.tools / name).exists()]
        if missing:
            sys.exit(f"error: {options.tools}/{missing[0]} is missing; build it: cmake --build "
                     f"build/release --target {' '.join(PROGRAMS)}")
        results = (update if options.update else run)(options, results_file)
    write(results, results["pictures"], options.to)
    check(results, False)


if __name__ == "__main__":
    main()
