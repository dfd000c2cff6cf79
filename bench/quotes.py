#!/usr/bin/env python3
"""Measures whether `render --quote` keeps its word on scenes, and writes docs/quotes.md.

    bench/quotes.py [--bin BIN] [--size 160] [--error 10 5 2] [--most 60] [--rows FILE] SCENE...

Each scene is quoted once, as a user would, and then rendered to each of the errors. True errors are
relMSE (docs/error.md (3)) against a render of another seed to about two thirds of the least error,
or of ten times the longest render, less that render's own.  Scenes whose rows FILE has are not
measured again.  Takes 1 to 4 minutes a scene, on all cores.
"""

import argparse
import datetime
import json
import math
import pathlib
import re
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.append(str(ROOT / "experiments"))
import programs
import promises

REFERENCE_PART = 0.65  # of the least error, that a reference has
REFERENCE_TIMES = 10  # the longest render that is tried, at most
REFERENCE_SEED = 99


class Scene:
    """A scene, its partition, quote and reference in a folder."""

    def __init__(self, options, path, folder):
        self.options, self.path, self.folder = options, path, pathlib.Path(folder)
        self.partition = self.folder / "scene.hpm"
        programs.run(options.bin, "preprocess", path, "-o", self.partition)

    def render(self, name, *more):
        """Returns the image, and the statistics with the clock's seconds of the whole program as
        `clock`."""
        image, stats = self.folder / f"{name}.pfm", self.folder / "stats.json"
        begin = time.monotonic()
        programs.run(self.options.bin, "render", self.path, self.partition, "-o", image, "--stats",
                     stats, "--size", self.options.size, *more)
        clock = time.monotonic() - begin
        return image, {**json.loads(stats.read_text()), "clock": clock}

    def reference(self, least):
        """Returns the image and the square of the error that it states."""
        image, stats = self.render("reference", "--seed", REFERENCE_SEED, "--error",
                                   100 * REFERENCE_PART * least, "--time",
                                   REFERENCE_TIMES * self.options.most)
        return image, stats["error"]["checks"][-1]["error"] ** 2

    def true_error(self, image, reference):
        """None: it is less than the reference's own."""
        printed = programs.run(self.options.bin, "compare_images", image, reference[0]).output
        square = float(re.search(r"relMSE of A against B\s+([\d.e+-]+)", printed)[1]) - reference[1]
        return math.sqrt(square) if square > 0 else None


def rows(options, path):
    """The rows of a scene: dictionaries."""
    with tempfile.TemporaryDirectory() as folder:
        scene = Scene(options, path, folder)
        _, quoted = scene.render("quote", "--quote")
        prices = [price for error in options.error for price in quoted["error"]["prices"]
                  if math.isclose(price["error"], error / 100) and
                  price["seconds"] <= options.most]
        if not prices:
            return
        reference = scene.reference(min(price["error"] for price in prices))
        for price in prices:
            passes = promises.promised(price, "passes")
            image, stats = scene.render("image", "--error", 100 * price["error"], "--passes",
                                        max(8, math.ceil(promises.PATIENCE * passes[1])))
            check = stats["error"]["checks"][-1]
            yield {"scene": path.name, "error": price["error"],
                   "passes": passes, "taken": check["passes"],
                   "seconds": promises.promised(price, "seconds"), "clock": stats["clock"],
                   "quote": quoted["clock"],
                   "stated": check["error"], "true": scene.true_error(image, reference),
                   "met": stats["ended_by"] == "error"}


def kept(row):
    return (row["met"] and promises.held(row["passes"], row["taken"]) and
            promises.held(row["seconds"], row["clock"]))


def line(row):
    """A row of the table."""
    true = f"{100 * row['true']:.2g} %" if row["true"] else "less than the reference's"
    return "| " + " | ".join((
        row["scene"], f"{100 * row['error']:g} %", promises.written(row["passes"], "g"),
        f"{row['taken']}{'' if row['met'] else ', given up'}",
        promises.written(row["seconds"], ".1f"), f"{row['clock']:.1f}",
        f"{row['clock'] / row['seconds'][0]:.2f}", f"{row['quote']:.1f}", f"{100 * row['stated']:.2g} %", true,
        "held" if kept(row) else "**missed**")) + " |"


def page(options, found):
    return "\n".join([
        "# Does --quote keep its word?", "",
        f"Written by `bench/quotes.py`; do not edit. Run on {datetime.date.today().isoformat()}.", "",
        f"Images {options.size} pixels wide, with `render`'s defaults. `--quote` promises passes and seconds to an "
        "error ([error.md](error.md#quotes)); then `--error` renders to it with the same seed. Seconds taken are the "
        "clock's, of the whole program, on all cores. A render stops only after 4, 6, 8, 11, 16, ... passes. "
        f"Errors that take more than {options.most:g} s were not tried.", "",
        f"Held: passes and seconds are both within a factor of {promises.WITHIN} of the promise, "
        "which is a range where few samples find some of the light ((29) there); the ratio is that to its lower end. "
        f"{sum(map(kept, found))} of {len(found)}.", "",
        "| scene | error | passes promised | taken | seconds promised | taken | ratio | quote, s | error stated | "
        "true error | |",
        "| --- |" + " --- |" * 10,
        *map(line, found), ""])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("scenes", nargs="+", metavar="SCENE", type=pathlib.Path)
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/release/bin")
    parser.add_argument("--size", type=int, default=160, help="pixels across")
    parser.add_argument("--error", type=float, nargs="+", default=[10, 5, 2],
                        help="percent; of those that --quote lists")
    parser.add_argument("--most", type=float, default=60, help="seconds that a render may promise to take")
    parser.add_argument("--rows", type=pathlib.Path, help="JSON, read and written: the rows by scene")
    options = parser.parse_args()
    found = {}
    if options.rows and options.rows.exists():
        found = json.loads(options.rows.read_text(encoding="utf-8"))
    for path in options.scenes:
        if path.name in found:
            continue
        found[path.name] = []
        for row in rows(options, path):
            found[path.name].append(row)
            print(line(row), flush=True)
        if options.rows:
            options.rows.write_text(json.dumps(found, indent=1), encoding="utf-8")
    rendered = [row for path in options.scenes for row in found[path.name]]
    (ROOT / "docs/quotes.md").write_text(page(options, rendered), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
