#!/usr/bin/env python3
"""Counts how often the interval that render states holds the true error of its image.

    experiments/calibration/calibrate.py                # writes docs/calibration.md
    experiments/calibration/calibrate.py --seeds 4      # a look; writes below out/

Needs preprocess, render and compare_images in build/release/bin.
"""

import argparse
import datetime
import json
import pathlib
import sys
import tempfile
import time

import report
import runs
from progress import Progress

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
    parser.add_argument("--threads", type=int, default=0, help="of render; 0: all [0]")
    parser.add_argument("--to", type=pathlib.Path,
                        help="folder to write to [docs; with fewer seeds out/calibration]")
    parser.add_argument("--tools", type=pathlib.Path, default=runs.ROOT / "build/release/bin",
                        help="folder of the programs [build/release/bin]")
    parser.add_argument("--again", action="store_true",
                        help="render nothing: write the document from calibration.json")
    options = parser.parse_args()
    whole = options.again or options.seeds >= SEEDS
    options.to = options.to or runs.ROOT / ("docs" if whole else "out/calibration")
    return options


def calibrate(lab, scene, integrators, seeds, progress):
    """Cases of one scene: what its runs were, and each image's true error and interval."""
    lab.make_partition(scene)
    targets = {integrator: lab.find_target(scene, integrator) for integrator in integrators}
    references, cases = {}, []
    for integrator, target in targets.items():
        method = runs.reference_method(scene, integrator)
        wanted = min(target for other, target in targets.items()
                     if runs.reference_method(scene, other) == method)
        if method not in references:
            references[method] = lab.make_reference(scene, method, wanted)
            progress.ran(f"{scene}, reference by {method.name}")
        reference = references[method]
        images = []
        for seed in range(seeds):
            images.append(lab.try_image(scene, integrator, target, seed, reference))
            progress.ran(f"{scene}, {integrator}, seed {seed}")
        cases.append({"scene": scene, "integrator": integrator, "target": target,
                      "reference": method.name, "reference_error": reference.error,
                      "images": images})
    return cases


def run(options, file):
    """Renders, and keeps what there is after each scene: other scenes of an earlier run too."""
    start = time.monotonic()
    chosen = {scene: runs.integrators_for(scene, options.integrators) for scene in options.scenes}
    references = {(scene, runs.reference_method(scene, name))
                  for scene, names in chosen.items() for name in names}
    progress = Progress(len(references) + options.seeds * sum(map(len, chosen.values())))
    cases = []
    if file.exists():
        earlier = json.loads(file.read_text())
        if earlier["size"] == options.size:
            cases = [case for case in earlier["cases"] if case["scene"] not in chosen]
    with tempfile.TemporaryDirectory() as folder:
        lab = runs.Lab(options.tools, pathlib.Path(folder), options.size, options.threads)
        for scene, names in chosen.items():
            cases += calibrate(lab, scene, names, options.seeds, progress)
            results = {"date": datetime.date.today().isoformat(), "size": options.size,
                       "minutes": (time.monotonic() - start) / 60, "cases": cases}
            file.write_text(json.dumps(results) + "\n")
    return results


def main():
    options = parse_options()
    file = options.to / "calibration.json"
    options.to.mkdir(parents=True, exist_ok=True)
    results = json.loads(file.read_text()) if options.again else run(options, file)
    (options.to / "calibration.md").write_text(report.write(results))
    print(f"wrote {options.to / 'calibration.md'}", file=sys.stderr)


if __name__ == "__main__":
    main()
