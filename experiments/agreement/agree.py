#!/usr/bin/env python3
"""Asks whether the integrators agree on every bundled scene, as far as they say they do.

    experiments/agreement/agree.py                              # writes docs/agreement.md
    experiments/agreement/agree.py --minutes 1 --scenes milk    # a look; writes below out/

Needs preprocess and render in build/release/bin.
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

MINUTES = 20


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--scenes", nargs="+", choices=sorted(runs.SCENES), metavar="NAME",
                        help=f"which of them [{' '.join(runs.SCENES)}]")
    parser.add_argument("--minutes", type=float, default=MINUTES,
                        help=f"about how long to render [{MINUTES}]")
    parser.add_argument("--seeds", type=int, default=8, help="images of each method [8]")
    parser.add_argument("--size", type=int, default=48,
                        help=f"pixels across an image, a multiple of {runs.BLOCKS} [48]")
    parser.add_argument("--threads", type=int, default=0, help="of render; 0: all [0]")
    parser.add_argument("--to", type=pathlib.Path,
                        help="folder to write to [docs; of some scenes out/agreement]")
    parser.add_argument("--tools", type=pathlib.Path, default=runs.ROOT / "build/release/bin",
                        help="folder of the programs [build/release/bin]")
    parser.add_argument("--again", action="store_true",
                        help="render nothing: write the document from agreement.json")
    options = parser.parse_args()
    options.to = options.to or runs.ROOT / ("out/agreement" if options.scenes else "docs")
    options.scenes = options.scenes or list(runs.SCENES)
    return options


def compare(options):
    """Every scene gets the same share of the time."""
    start = time.monotonic()
    progress = Progress(len(options.scenes))
    comparisons = []
    with tempfile.TemporaryDirectory() as folder:
        for scene in options.scenes:
            lab = runs.Lab(options.tools, pathlib.Path(folder), options.size, options.threads,
                           options.seeds, 60 * options.minutes / len(options.scenes))
            comparisons += runs.compare(lab, scene)
            progress.ran(scene)
    return {"date": datetime.date.today().isoformat(), "size": options.size,
            "seeds": options.seeds, "minutes": (time.monotonic() - start) / 60,
            "comparisons": comparisons}


def main():
    options = parse_options()
    options.to.mkdir(parents=True, exist_ok=True)
    file = options.to / "agreement.json"
    if options.again:
        results = json.loads(file.read_text())
    else:
        results = compare(options)
        file.write_text(json.dumps(results) + "\n")
    (options.to / "agreement.md").write_text(report.write(results))
    print(f"wrote {options.to / 'agreement.md'}", file=sys.stderr)


if __name__ == "__main__":
    main()
