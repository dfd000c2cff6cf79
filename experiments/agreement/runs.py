"""Renders each scene by each method, some seeds of it, and sums up how the images differ."""

import dataclasses
import json
import math
import pathlib
import statistics
import struct
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path += [str(ROOT / "experiments"), str(ROOT / "experiments/accuracy")]
import arithmetic
import furnished
import programs

SCENES = furnished.Scenes({
    path.stem: path for folder in ("assets/effects", "assets", "experiments/scenes")
    for path in sorted((ROOT / folder).glob("*.glb"))})
BLOCKS = 4  # regions of an image, across and down
# Paths whose stated error is larger cannot be compared with: there is light that they hardly find.
MOST_ERROR = 0.3
# Pictures without caustics of which less is lit, over all, say nothing.
LEAST_LIT = 0.1


@dataclasses.dataclass(frozen=True)
class Method:
    """share: of a scene's time."""

    name: str
    options: tuple
    share: float


PATH = Method("path", ("--integrator", "path", "--samples", 2), 0.5)
PROGRESSIVE = Method("progressive", ("--integrator", "progressive", "--indirect-by", "photons",
                                     "--photons", 50_000, "--samples", 2), 0.4)
# Within a tenth of the area of the method above, so that little of its bias is shared.
NARROW = Method("progressive, narrow", ("--integrator", "progressive", "--indirect-by", "photons",
                                        "--photons", 150_000, "--neighbours", 16, "--samples", 2), 0.5)
DIRECT = Method("direct", ("--integrator", "direct", "--photons", 50_000, "--samples", 2), 0.1)
FEWEST = 8  # passes of an image: with fewer an error is stated without its interval


def has_lamps_without_size(scene):
    """A path cannot find such a light through glass or in mirrors, and hardly in a medium."""
    data = SCENES[scene].read_bytes()
    document = json.loads(data[20:20 + struct.unpack_from("<I", data, 12)[0]])
    lamps = document.get("extensions", {}).get("KHR_lights_punctual", {}).get("lights", [])
    return any(not lamp.get("extras", {}).get("hipmap") for lamp in lamps)


def block_means(image):
    """Means of the channels over each region, row by row."""
    width, numbers = image
    side = width // BLOCKS
    out = []
    for row in range(len(numbers) // 3 // width // side):
        for column in range(BLOCKS):
            sums = [0.0, 0.0, 0.0]
            for y in range(row * side, (row + 1) * side):
                at = 3 * (y * width + column * side)
                for c in range(3):
                    sums[c] += sum(numbers[at + c:at + 3 * side:3])
            out += [value / side ** 2 for value in sums]
    return out


@dataclasses.dataclass(frozen=True)
class Lab:
    """tools: folder of the programs.  folder: for their files.  size: pixels across an image.
    seeds: images of a method.  seconds: to render a scene."""

    tools: pathlib.Path
    folder: pathlib.Path
    size: int
    threads: int
    seeds: int
    seconds: float

    def make_partition(self, scene):
        programs.run(self.tools, "preprocess", SCENES[scene], "-o", self.folder / "scene.hpm")

    def render(self, scene, method, *options):
        """(image, statistics)"""
        image, stats = self.folder / "image.pfm", self.folder / "stats.json"
        programs.run(self.tools, "render", SCENES[scene], self.folder / "scene.hpm", "-o", image,
                     "--stats", stats, "--size", f"{self.size}x{self.size}", "--threads",
                     self.threads, "--fireflies", "keep", *method.options, *options)
        return arithmetic.read_pfm(image), json.loads(stats.read_text())

    def series(self, scene, method, effects=""):
        """[(image, statistics)] of the seeds; no method has a seed of another."""
        options = ("--effects", effects) if effects else ()
        _, probe = self.render(scene, method, "--passes", FEWEST, *options)
        each = probe["error"]["checks"][-1]["seconds"] / FEWEST
        passes = max(FEWEST, int(self.seconds * method.share / self.seeds / each))
        first = 1000 * (1 + [PATH, PROGRESSIVE, NARROW, DIRECT].index(method))
        return [self.render(scene, method, "--passes", passes, "--seed", first + i, *options)
                for i in range(self.seeds)]


def stated2(stats):
    """Squares of the errors that a run states of its image: (all, of that bias)."""
    check = stats["error"]["checks"][-1]
    return check["error"] ** 2, check.get("bias2", 0.0)


def difference2(image, other):
    """Mean square of the difference over r² + c, r the mean of both."""
    weights = arithmetic.weights((image, other))
    return sum(w * (a - b) ** 2 for w, a, b in zip(weights, image[1], other[1])) / len(image[1])


def mean_and_error(values):
    return statistics.mean(values), statistics.stdev(values) / math.sqrt(len(values))


def side_by_side(rows, others):
    """[(mean, standard error, the same of the others)] of each column.  Six digits."""
    return [[float(f"{number:.6g}") for column in columns for number in mean_and_error(column)]
            for columns in zip(zip(*rows), zip(*others))]


def channel_means(image):
    return [sum(image[1][c::3]) / (len(image[1]) / 3) for c in range(3)]


def root_mean(values):
    """Below zero by chance: zero."""
    return math.sqrt(max(0.0, sum(values)) / len(values))


def summarise(scene, method, other, images, others):
    """What is known of a method against another one."""
    def beside(measure):
        return side_by_side(*([measure(image) for image, _ in series]
                              for series in (images, others)))
    pairs = list(zip(images, others))
    return {
        "scene": scene, "method": method, "other": other,
        "passes": [stats["error"]["checks"][-1]["passes"]
                   for _, stats in (images[0], others[0])],
        "channels": beside(channel_means), "regions": beside(block_means),
        "difference2": [difference2(a[0], b[0]) for a, b in pairs],
        "stated2": [stated2(a[1])[0] + stated2(b[1])[0] for a, b in pairs],
        "bias": root_mean([stated2(a[1])[1] + stated2(b[1])[1] for a, b in pairs])}


def with_paths(lab, scene, photons):
    """(summaries against paths, why they are no reference)"""
    on = {effect["name"] for effect in photons[0][1]["effects"] if effect["on"]}
    if has_lamps_without_size(scene) and on & {"caustics", "media"}:
        return [], "path tracing cannot find its lights without size through glass, in mirrors or in media"
    paths = lab.series(scene, PATH)
    error = root_mean([stated2(stats)[0] for _, stats in paths])
    if error > MOST_ERROR:
        return [], f"path tracing states an error of {100 * error:.0f} %: it hardly finds the light"
    return [summarise(scene, method.name, PATH.name, images, paths) for method, images in
            ((PROGRESSIVE, photons), (DIRECT, lab.series(scene, DIRECT)))], ""


def without_caustics(lab, scene):
    """A summary against paths, of what light is left."""
    effects = "-caustics"
    photons = lab.series(scene, PROGRESSIVE, effects)
    if sum(number > 0 for number in photons[0][0][1]) < LEAST_LIT * len(photons[0][0][1]):
        return []
    return [{**summarise(scene, PROGRESSIVE.name, PATH.name, photons,
                         lab.series(scene, PATH, effects)), "effects": effects}]


def compare(lab, scene):
    """Summaries of all methods on one scene, each with a reason (`why`) where paths are no
    reference."""
    lab.make_partition(scene)
    photons = lab.series(scene, PROGRESSIVE)
    found, why = with_paths(lab, scene, photons)
    if not why:
        return found
    narrow = summarise(scene, PROGRESSIVE.name, NARROW.name, photons, lab.series(scene, NARROW))
    caustics = any(effect["name"] == "caustics" and effect["on"]
                   for effect in photons[0][1]["effects"])
    return [{**narrow, "why": why}, *(without_caustics(lab, scene) if caustics else [])]
