"""Renders one room by each integrator, several seeds of it, and measures the images."""

import dataclasses
import json
import math
import pathlib
import statistics
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.append(str(ROOT / "experiments/agreement"))
import runs
from runs import arithmetic

FEWEST = 8  # passes of an image: with fewer an error is stated without its interval
MOST = 4096
LONGEST = 120  # seconds of one call, after which it is ended


@dataclasses.dataclass(frozen=True)
class Method:
    """share: of the time for a room and integrator."""

    name: str
    options: tuple
    share: float = 1.0


METHODS = (
    Method("progressive", ("--integrator", "progressive", "--indirect-by", "photons", "--photons", 20_000,
                           "--samples", 2)),
    Method("path", ("--integrator", "path", "--samples", 8)),
    Method("direct", ("--integrator", "direct", "--photons", 20_000, "--samples", 2), 0.2),
)


class Refused(Exception):
    """A program ended with an error; the message is its last line."""


@dataclasses.dataclass(frozen=True)
class Lab:
    """tools: folder of the programs.  folder: for their files.  size: pixels across an image.
    seconds: for each room and integrator.  passes: of an image instead, whatever it takes."""

    tools: pathlib.Path
    folder: pathlib.Path
    size: int
    threads: int
    seeds: int
    seconds: float
    passes: int = 0

    def call(self, program, *arguments):
        command = [str(self.tools / program), *map(str, arguments)]
        try:
            done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True,
                                  text=True, check=False, timeout=LONGEST)
        except subprocess.TimeoutExpired:
            raise Refused(f"{program} took more than {LONGEST} s") from None
        if done.returncode != 0:
            lines = done.stderr.splitlines() or ["no message"]
            code = "" if done.returncode == 2 else f" (exit code {done.returncode})"
            raise Refused(f"{lines[-1]}{code}")

    def make(self, name, room):
        """Writes the scene and its partition."""
        room.write(self.folder / f"{name}.glb")
        self.call("preprocess", self.folder / f"{name}.glb", "-o", self.folder / f"{name}.hpm")

    def render(self, name, method, *options):
        """(image, statistics)"""
        image, stats = self.folder / f"{name}.pfm", self.folder / f"{name}.json"
        self.call("render", self.folder / f"{name}.glb", self.folder / f"{name}.hpm", "-o", image,
                  "--stats", stats, "--size", f"{self.size}x{self.size}", "--filter", "box",
                  "--threads", self.threads, "--fireflies", "keep", *method.options, *options)
        return arithmetic.read_pfm(image), json.loads(stats.read_text())

    def passes_in_time(self, name, method):
        probe = self.render(name, method, "--passes", FEWEST)[1]
        each = probe["error"]["checks"][-1]["seconds"] / FEWEST
        passes = int(self.seconds * method.share / self.seeds / max(each, 1e-6))
        return min(max(passes, FEWEST), MOST)

    def series(self, name, method):
        """[(image, statistics)] by seed; no method has a seed of another."""
        passes = self.passes or self.passes_in_time(name, method)
        first = 1000 * (1 + METHODS.index(method))
        return [self.render(name, method, "--passes", passes, "--seed", first + i)
                for i in range(self.seeds)]


def mean_of(image):
    return sum(image[1]) / len(image[1])


def stated(series):
    """(error, bias) that the images state, roots of the means of their squares."""
    both = [runs.stated2(stats) for _, stats in series]
    return tuple(runs.root_mean([pair[i] for pair in both]) for i in (0, 1))


def regions_of(series, others):
    """[(ratio, its standard error)] of each region and channel that is not dark."""
    floor = 0.1 * statistics.mean(mean_of(image) for image, _ in others)
    rows = [[runs.block_means(image) for image, _ in images] for images in (series, others)]
    return [ratio(a, b) for a, b in zip(zip(*rows[0]), zip(*rows[1]))
            if statistics.mean(b) > floor]


def ratio(values, others):
    """(ratio of the means, its standard error); nothing where the others are black."""
    (a, a_error), (b, b_error) = runs.mean_and_error(values), runs.mean_and_error(others)
    if not b > 0:
        return None
    return a / b, math.hypot(a_error, a / b * b_error) / b


def compare(lab, name, room):
    """What is known of a room: `refused` with a message, or means, ratio and errors."""
    case = {"expect": room.expect}
    try:
        lab.make(name, room)
        series = {method.name: lab.series(name, method) for method in METHODS}
    except Refused as why:
        return {**case, "refused": str(why)}
    means = {key: [mean_of(image) for image, _ in images] for key, images in series.items()}
    case["means"] = {key: statistics.mean(values) for key, values in means.items()}
    case["passes"] = [images[0][1]["error"]["checks"][-1]["passes"]
                      for images in series.values()][:2]
    case["stated"] = {key: stated(images) for key, images in series.items()}
    case["seeds"] = lab.seeds
    if all(math.isfinite(value) for values in means.values() for value in values):
        case["ratio"] = ratio(means["progressive"], means["path"])
        case["direct"] = ratio(means["direct"], means["path"])
        case["regions"] = regions_of(series["progressive"], series["path"])
    return case
