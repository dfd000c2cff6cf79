#!/usr/bin/env python3
"""Does the experiment of Mpawulo's dissertation (2005) again, on the scenes beside it.

    experiments/run_experiment.py                      # writes docs/experiments.md
    experiments/run_experiment.py --quick --scenes 1   # a look; writes below out/
    experiments/run_experiment.py --so-far             # writes it from what a stopped run has measured
    experiments/run_experiment.py --check              # compares identical computations of the last run

Needs the programs in build/release/bin and, for the plots, Debian's python3-matplotlib.
"""

import argparse
import datetime
import itertools
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import document
import figures
import identical
import measure
import pictures
import programs
import questions
from notebook import Job, Notebook, do_stages

QUICK = {"divide": 10, "size": 96, "most_rounds": 1}
FULL = {"divide": 1, "size": 256, "most_rounds": 20}
PROGRAMS = ("preprocess", "render", "map_costs", "crease_profile", "filter_radius", "rebuild_maps")
CREASE_SETS = 10_000
PATH_SECONDS, FOUND_SECONDS = 3e-6, 1.5e-7  # of a light path in all maps, of a photon found; about


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--scenes", type=int, nargs="+", choices=measure.SCENES,
                        default=list(measure.SCENES),
                        help="which of them; 4 is scene 3 with walls in cells [1 2 3 4]")
    parser.add_argument("--tests", type=int, nargs="+", choices=measure.TESTS,
                        default=list(measure.TESTS), help="which of them [1 2 3 4 5]")
    parser.add_argument("--quick", action="store_true",
                        help="a tenth of the photons and neighbours, small images, one round")
    parser.add_argument("--rounds", type=int,
                        help="times to measure each at most [20; with --quick 1]")
    parser.add_argument("--to", type=pathlib.Path,
                        help="folder to write to [docs; with --quick out/experiments]")
    parser.add_argument("--work", type=pathlib.Path,
                        help="folder of what a stopped run has measured [out/experiment; with "
                             "--quick work, below the folder to write to]")
    parser.add_argument("--workers", type=int, default=1,
                        help="how many to measure at the same time [1]; seconds are of the processor")
    parser.add_argument("--tools", type=pathlib.Path, default=measure.ROOT / "build/release/bin",
                        help="folder of the programs [build/release/bin]")
    parser.add_argument("--so-far", action="store_true",
                        help="measure nothing: write the document from what a stopped run has measured")
    parser.add_argument("--again", action="store_true",
                        help="measure nothing: write the document and plots from results.json")
    parser.add_argument("--check", action="store_true",
                        help="measure nothing: say which identical computations of results.json differ by "
                             "more than their intervals; exit code 1 if any do")
    options = parser.parse_args()
    options.to = options.to or measure.ROOT / ("out/experiments" if options.quick else "docs")
    options.work = options.work or (options.to / "work" if options.quick else
                                    measure.ROOT / "out/experiment")
    return options


def commit():
    command = ["git", "-C", str(measure.ROOT), "describe", "--always", "--dirty"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return done.stdout.strip() or "unknown"


def measured(options):
    """Scenes and tests."""
    return [(scene, test) for scene, test in itertools.product(options.scenes, options.tests)
            if scene != measure.CELLS or test in measure.TESTS_OF_CELLS]


def own_settings():
    return [measure.Setting(mode, tree) for tree in measure.TREES for mode in measure.MODES]


def weight(bench, scene, test, settings):
    """Seconds that measuring them takes, about."""
    found = bench.size ** 2 * 0.75 * measure.neighbours(bench, test) / measure.EVERY.get(test, 1)
    paths = measure.light_paths(bench, scene, test)
    once = (PATH_SECONDS * paths + FOUND_SECONDS * found) * len(settings)
    return once * min(measure.LEAST_ROUNDS, measure.rounds(bench, scene, test))


def cost_job(bench, scene, test):
    settings = own_settings() + questions.settings(scene, test)
    return Job(f"costs of scene {scene}, test {test}", weight(bench, scene, test, settings),
               lambda: measure.measure(bench, scene, test, settings))


def single_jobs(bench, options):
    """What is measured by other programs."""
    settings = pictures.QUICK_RENDER if options.quick else pictures.RENDER
    folder = options.to / "experiments"
    found = [Job("creases", 60, lambda: questions.run_creases(bench, CREASE_SETS // bench.divide ** 2))]
    for scene in options.scenes:
        found.append(Job(f"pictures of scene {scene}", 30, lambda scene=scene: pictures.draw_scene(
            bench, scene, folder, settings)))
    for scene, test in measured(options):
        if questions.ASKED.get(scene) == test:
            found.append(Job(f"filter radius of scene {scene}", 60, lambda of=(scene, test):
                             questions.run_filter(bench, *of)))
        if test in questions.SOME_TESTS and scene != measure.CELLS:
            found.append(Job(f"rebuilt maps of scene {scene}, test {test}", 60, lambda of=(
                scene, test): questions.run_rebuilds(bench, *of)))
    return found


def all_jobs(bench, options):
    """Those that take least first."""
    jobs = [cost_job(bench, *of) for of in measured(options)] + single_jobs(bench, options)
    return sorted(jobs, key=lambda job: job.weight)


def collect(notebook, jobs):
    """The results, of what was measured of the jobs."""
    done = [job.key for job in jobs if job.key in notebook]
    of = lambda start: [row for key in sorted(done) if key.startswith(start) for row in notebook[key]]
    drawn = {name: file for key in done if key.startswith("pictures")
             for name, file in notebook[key].items()}
    return {"rows": of("costs"), "creases": of("creases"), "filter": of("filter"),
            "rebuilds": of("rebuilt"), "pictures": drawn,
            "missing": [job.key for job in jobs if job.key not in notebook]}


def write(results, to):
    folder = to / "experiments"
    plots = figures.draw_all(results, folder)
    if not plots:
        print("no plots: matplotlib is not installed (Debian: python3-matplotlib)",
              file=sys.stderr)
    links = {name: f"experiments/{file}"
             for name, file in {**results["pictures"], **plots}.items()}
    root = os.path.relpath(measure.ROOT, to)
    (to / "experiments.md").write_text(document.write(results, links, root))
    print(f"wrote {to / 'experiments.md'}", file=sys.stderr)


def settings_of(options):
    found = dict(QUICK if options.quick else FULL)
    found["most_rounds"] = options.rounds or found["most_rounds"]
    return found


def run(options, results_file):
    """Measures what the notebook does not have, and writes the results."""
    settings = settings_of(options)
    options.work.mkdir(parents=True, exist_ok=True)
    notebook = Notebook(options.work / "measured.json",
                        {"programs": programs.digest(options.tools, PROGRAMS), **settings})
    with tempfile.TemporaryDirectory() as folder:
        bench = measure.Bench(options.tools, pathlib.Path(folder), **settings)
        jobs = all_jobs(bench, options)
        if not options.so_far:
            for scene in options.scenes:
                measure.make_partition(bench, scene)
            do_stages([jobs], notebook, options.workers)
    results = collect(notebook, jobs)
    results["about"] = {"date": datetime.date.today().isoformat(), "commit": commit(),
                        "machine": programs.machine(), **settings,
                        "minutes": notebook.results["seconds"] / 60,
                        "missing": results.pop("missing")}
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
        results = run(options, results_file)
    write(results, options.to)
    check(results, False)


if __name__ == "__main__":
    main()
