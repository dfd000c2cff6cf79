"""Renders images that stop at an error, and what they are compared with."""

import dataclasses
import functools
import hashlib
import json
import math
import pathlib
import struct
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path += [str(ROOT / "experiments"), str(ROOT / "experiments/accuracy")]
import arithmetic
import furnished
import programs
SCENES = furnished.Scenes({path.stem: path for folder in ("assets", "experiments/scenes")
                           for path in sorted((ROOT / folder).glob("*.glb"))})
# Where all light comes through glass, so that paths hardly ever find it.
LIT_THROUGH_GLASS = {"glass_globe"}
# By scene, besides those lit through glass: rare samples are so bright that a reference good enough takes more than a
# quarter of an hour.
LEFT_OUT = {**dict.fromkeys(LIT_THROUGH_GLASS | set(furnished.NAMES), {"path"}),
            "carafe": {"progressive", "path", "direct"}, "museum": {"direct", "path"}}
REFERENCE_SEED = 1_000_000
# A reference is as much better than the images.
BETTER = 5
# A run is to go on for some passes: it ends at this part of the error that the first check shows.
PART_OF_FIRST = 0.7
FIRST_CHECK = 8
MOST_ERROR = 100  # percent that --error takes


@dataclasses.dataclass(frozen=True)
class Method:
    """How an image is rendered."""

    name: str
    options: tuple
    pilots: int = 1  # seeds whose mean a reference is


# Options such that a pass takes some hundredths of a second.
INTEGRATORS = {
    "progressive": Method("progressive", ("--integrator", "progressive", "--photons", 5_000,
                                          "--samples", 1)),
    "path": Method("path", ("--integrator", "path", "--samples", 8)),
    # The lit underside of a lamp shade in `hexagonal` covers less than a hundredth of two pixels:
    # by one sample of a pixel in each pass most images would not meet it.
    # What pilots choose also moves the mean of its images, by a third of their noise in `axis_aligned`: so many of them
    # make a reference.
    "direct": Method("direct", ("--integrator", "direct", "--photons", 5_000, "--samples", 8), 16),
}
LONG_PATH = Method("path", ("--integrator", "path", "--samples", 64))
# By radii less than a tenth as wide: what bias it has left would be missing in that of the images.
LONG_PROGRESSIVE = Method("progressive, photons x 30, k = 4",
                          ("--integrator", "progressive", "--photons", 150_000, "--neighbours", 4,
                           "--samples", 8))


@functools.lru_cache
def has_lamps_without_size(scene):
    """A path cannot find such a lamp by way of glass and mirrors."""
    data = SCENES[scene].read_bytes()
    document = json.loads(data[20:20 + struct.unpack_from("<I", data, 12)[0]])
    return any("KHR_lights_punctual" in node.get("extensions", {}) for node in document["nodes"])


def integrators_for(scene, wanted):
    return [name for name in wanted if name not in LEFT_OUT.get(scene, ())]


def reference_method(scene, integrator):
    """By what the truth about images of the integrator is found.  What integrator direct says of
    its error is of noise alone: its truth is its own mean."""
    if integrator == "direct":
        return INTEGRATORS["direct"]
    hidden = has_lamps_without_size(scene) or scene in LIT_THROUGH_GLASS
    if integrator == "progressive" and hidden:
        return LONG_PROGRESSIVE
    return LONG_PATH


def named(scene):
    """The scene as it is now: what was found of another file of that name is of something else."""
    return f"{scene}@{hashlib.sha256(SCENES[scene].read_bytes()).hexdigest()[:8]}"


@dataclasses.dataclass(frozen=True)
class Lab:
    """tools: folder of the programs.  folder: for partitions and references.  size: pixels across an
    image.  Any number of threads may call what it has."""

    tools: pathlib.Path
    folder: pathlib.Path
    size: int

    def run(self, tool, *arguments):
        return programs.run(self.tools, tool, *arguments).output

    def partition(self, scene):
        return self.folder / f"{scene}.hpm"

    def make_partition(self, scene):
        self.run("preprocess", SCENES[scene], "-o", self.partition(scene))

    def reference(self, scene, method):
        return self.folder / f"{scene}_{method.name}.pfm"

    def render(self, scene, method, image, *options):
        """The last check of the image's error, and the number of its passes."""
        with tempfile.TemporaryDirectory() as folder:
            stats = pathlib.Path(folder, "stats.json")
            self.run("render", SCENES[scene], self.partition(scene), "-o", image, "--stats", stats,
                     "--size", self.size, "--threads", 1, *method.options, *options)
            return json.loads(stats.read_text())["error"]["checks"][-1]

    def find_target(self, scene, integrator):
        """An error, in percent with two digits, that takes the integrator a few checks."""
        with tempfile.TemporaryDirectory() as folder:
            check = self.render(scene, INTEGRATORS[integrator], pathlib.Path(folder, "image.pfm"),
                                "--passes", FIRST_CHECK, "--seed", REFERENCE_SEED + 1)
        wanted = min(100 * PART_OF_FIRST * check["error"], MOST_ERROR)
        return float(f"{wanted:.2g}")

    def make_reference(self, scene, method, target):
        """By passes until its stated error is a part of the target.  noise2: the part of the error's
        square that is noise."""
        each = min(target / BETTER * math.sqrt(method.pilots), MOST_ERROR)
        images, checks = [], []
        for seed in range(method.pilots):
            checks.append(self.render(scene, method, self.reference(scene, method), "--error", each,
                                      "--seed", REFERENCE_SEED + seed, "--fireflies", "keep"))
            images.append(arithmetic.read_pfm(self.reference(scene, method)))
        if method.pilots > 1:
            arithmetic.write_pfm(self.reference(scene, method), arithmetic.mean_image(images))
        error2, noise2 = (sum(check[part] ** 2 for check in checks) / method.pilots ** 2
                          for part in ("error", "noise"))
        return {"error": math.sqrt(error2), "noise2": noise2}

    def try_image(self, scene, integrator, target, seed, noise2):
        """What an image that stopped at the target says of its error, and what that is.  noise2: of
        the reference."""
        with tempfile.TemporaryDirectory() as folder:
            image = pathlib.Path(folder, "image.pfm")
            check = self.render(scene, INTEGRATORS[integrator], image, "--error", target, "--seed",
                                seed)
            said = self.run("compare_images", image,
                            self.reference(scene, reference_method(scene, integrator)))
        # The reference's noise is not the image's.
        square = float(said.split()[-1]) - noise2
        high = math.inf if check["high"] is None else check["high"]
        return {"seed": seed, "passes": check["passes"], "seconds": check["seconds"],
                "error": check["error"], "low": check["low"], "high": high,
                "true": math.sqrt(max(square, 0))}
