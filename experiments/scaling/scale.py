#!/usr/bin/env python3
"""Measures what the simulations of renders by many machines need, and what they are checked against.

    experiments/scaling/scale.py           # writes docs/scaling/measured.json
    experiments/scaling/scale.py --quick   # a look; writes below out/
    experiments/scaling/scale.py --processes 2 4 8 16
                                           # by up to 16 processes; writes docs/scaling/measured_16.json

Needs preprocess and render in build/release/bin, and mpirun.
Each result is kept as it comes: the same command goes on with what is left.
"""

import argparse
import dataclasses
import datetime
import itertools
import json
import os
import pathlib
import shutil
import sys

import all_cores
import jobs
import measure

import programs
from notebook import Notebook, do_stages


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--scenes", nargs="+", choices=measure.SCENES, default=list(measure.SCENES),
                        metavar="NAME", help=f"which of them [{' '.join(measure.SCENES)}]")
    parser.add_argument("--quick", action="store_true", help="small images, measured once: seconds")
    parser.add_argument("--processes", type=int, nargs="+", metavar="N", help="numbers of them, of which the largest is "
                        "that of the cores [1 and 2 in turns, on two cores]")
    parser.add_argument("--passes", type=int, nargs="+", metavar="N", default=[measure.FULL.checked_passes],
                        help="with --processes: passes of each, of all scenes or of one after the other "
                        f"[{measure.FULL.checked_passes}]")
    parser.add_argument("--to", type=pathlib.Path,
                        help="folder to write to [docs; with --quick out/scaling_quick]")
    parser.add_argument("--work", type=pathlib.Path, help="folder for what was done so far "
                        "[out/scaling; with --quick out/scaling_quick]")
    parser.add_argument("--tools", type=pathlib.Path, default=measure.ROOT / "build/release/bin",
                        help="folder of the programs [build/release/bin]")
    options = parser.parse_args()
    out = measure.ROOT / "out" / ("scaling_quick" if options.quick else "scaling")
    options.work = options.work or out
    options.to = options.to or (out if options.quick else measure.ROOT / "docs")
    return options


def study_of(options):
    if options.quick:
        return measure.QUICK
    return all_cores.STUDY if options.processes else measure.FULL


def stages_of(lab, options):
    """Returns stages of jobs, and how many jobs run at once."""
    if not options.processes:
        return jobs.jobs(lab, options.scenes), 1
    loads = {name: all_cores.Load(tuple(options.processes), each)
             for name, each in zip(options.scenes, itertools.cycle(options.passes))}
    return jobs.jobs_of_all_cores(lab, loads), max(1, max(options.processes) // 2)


def measured(options):
    """The results; the earlier ones of the work folder among them."""
    if shutil.which("mpirun") is None:
        sys.exit("error: mpirun is missing; install Open MPI (Debian: openmpi-bin)")
    if os.geteuid() == 0:  # Open MPI asks for it
        os.environ.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    study = study_of(options)
    options.work.mkdir(parents=True, exist_ok=True)
    about = {"programs": programs.digest(options.tools, ("preprocess", "render")),
             "machine": programs.machine(), "study": dataclasses.asdict(study)}
    notebook = Notebook(options.work / "measured.json", about)
    lab = measure.Lab(options.tools, options.work, study)
    for name in options.scenes:
        lab.make_partition(name)
    stages, workers = stages_of(lab, options)
    do_stages(stages, notebook, workers)
    return {**notebook.results, "scenes": options.scenes, "date": datetime.date.today().isoformat()}


def main():
    options = parse_options()
    folder = options.to / "scaling"
    file = folder / (f"measured_{max(options.processes)}.json" if options.processes else "measured.json")
    results = measured(options)
    folder.mkdir(parents=True, exist_ok=True)
    file.write_text(json.dumps(results) + "\n")
    print(f"wrote {file}", file=sys.stderr)


if __name__ == "__main__":
    main()
