#!/usr/bin/env python3
"""Renders rooms with one nasty thing each by photons and by paths, and compares the images' means.

    experiments/sweep/sweep.py                                     # all rooms; prints a table
    experiments/sweep/sweep.py --rooms slab_on_floor --seconds 30  # one of them, more precisely
    experiments/sweep/sweep.py --by-chance 100 --seconds 4         # random rooms of several objects
    experiments/sweep/sweep.py --to docs/sweep.md                  # writes the table as a page

Needs preprocess and render in build/release/bin.  Exit code 1 if a room differs or is black.
"""

import argparse
import datetime
import pathlib
import sys
import tempfile
import time

import measure
import verdicts
from rooms import ROOMS
from rooms_by_chance import by_chance
import rooms_of_glass  # adds to ROOMS
import rooms_of_light  # adds to ROOMS


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--rooms", nargs="+", metavar="NAME", choices=list(ROOMS),
                        help="rooms to render [all]")
    parser.add_argument("--by-chance", type=int, metavar="N",
                        help="instead, N random rooms of several objects; a room's number is its seed [none]")
    parser.add_argument("--first", type=int, default=0, help="the first of these numbers [0]")
    parser.add_argument("--list", action="store_true", help="print the names of the rooms and exit")
    parser.add_argument("--bin", type=pathlib.Path, default=measure.ROOT / "build/release/bin",
                        help="folder of the programs [build/release/bin]")
    parser.add_argument("--seconds", type=float, default=10,
                        help="time for each room and integrator [10]")
    parser.add_argument("--seeds", type=int, default=6,
                        help="images by each integrator; of 2 the mean must be 44 standard errors off to "
                             "be called wrong, of 6 it must be 5 off [6]")
    parser.add_argument("--size", type=int, default=32,
                        help="pixels across an image, a multiple of 4 [32]")
    parser.add_argument("--threads", type=int, default=0, help="threads of render; 0: all [0]")
    parser.add_argument("--keep", type=pathlib.Path,
                        help="folder that keeps the scenes and partitions [none]")
    parser.add_argument("--to", type=pathlib.Path, help="Markdown file to write")
    options = parser.parse_args()
    if options.to and options.to.is_dir():
        parser.error(f"--to: {options.to} is a folder; name the file to write")
    return options


def rooms_of(options):
    """{name: function that builds it}"""
    if options.by_chance:
        return by_chance(range(options.first, options.first + options.by_chance))
    return {name: ROOMS[name] for name in options.rooms or ROOMS}


def sweep(options, folder):
    """[(name, what is nasty, case)] of each room, printed as they come.  A room without a reference comes
    again, with lights that paths can find."""
    found = []
    lab = measure.Lab(options.bin, folder, options.size, options.threads, options.seeds,
                      options.seconds)
    print(verdicts.header(), flush=True)

    def judge(name, room, nasty):
        case = measure.compare(lab, name, room)
        found.append((name, nasty, case))
        print(verdicts.line(name, case), flush=True)
        return verdicts.verdict(case)

    for name, build in rooms_of(options).items():
        if judge(name, build(), build.__doc__) == verdicts.VAGUE:
            room = build()  # writing one changes it
            if room.widen_lights():
                judge(f"{name}_wide", room, build.__doc__)
    return found


def main():
    options = parse_options()
    if options.list:
        print("\n".join(ROOMS))
        return 0
    start = time.monotonic()
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.keep or pathlib.Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        found = sweep(options, folder)
    if options.to:
        minutes = (time.monotonic() - start) / 60
        options.to.write_text(verdicts.page(found, datetime.date.today().isoformat(), minutes,
                                            options), encoding="utf-8")
        print(f"wrote {options.to}", file=sys.stderr)
    return 1 if any(verdicts.verdict(case) in verdicts.WRONG for _, _, case in found) else 0


if __name__ == "__main__":
    sys.exit(main())
