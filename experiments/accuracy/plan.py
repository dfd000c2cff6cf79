"""What is rendered, how often and for how long."""

import dataclasses
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.append(str(ROOT / "experiments"))
import furnished

COMMON = ("--look", "gltf", "--threads", 1)
PHOTONS = 50_000
DEFAULT_PHOTONS = 200_000
FILTER, BOX = "b-spline", "box"
# Errors at which methods are compared.
ERRORS = (0.2, 0.1, 0.07, 0.05, 0.03, 0.02)


@dataclasses.dataclass(frozen=True)
class Scene:
    """caustics: whether it has any.  mark: for relMSE after a minute of two cores; None: not set."""

    name: str
    caustics: bool
    mark: float | None = None

    @property
    def path(self):
        if self.name in furnished.NAMES:
            return furnished.path_of(self.name)
        return ROOT / "assets" / f"{self.name}.glb"

    @property
    def script(self):
        return ROOT / "assets" / f"{self.name}.py"


SCENES = {scene.name: scene for scene in (
    Scene("cornell", True), Scene("cornell_diffuse", False, 5e-5),
    Scene("cornell_spheres", True, 2e-4), Scene("glass_globe", True, 6e-4),
    *(Scene(name, True) for name in furnished.NAMES))}


@dataclasses.dataclass(frozen=True)
class Setting:
    """A way to render.  seconds: of the processor, that the passes of an image of the whole study take.
    photons: light paths a pass, where there are any.  filter: of pixels."""

    name: str
    seconds: float
    options: tuple
    photons: int = 0
    filter: str = FILTER

    def arguments(self, study):
        photons = ("--photons", max(1, self.photons // study.divide)) if self.photons else ()
        return (*COMMON, "--filter", self.filter, *self.options, *photons)


def progressive(name, seconds, *options, photons=PHOTONS):
    return Setting(name, seconds, ("--integrator", "progressive", *options), photons)


def direct(name, *options, photons=PHOTONS):
    return Setting(name, 2.5, ("--integrator", "direct", *options), photons)


BASE, DEFAULT, PATH = "progressive", "progressive, 200,000 photons", "path"
SETTINGS = {setting.name: setting for setting in (
    progressive(BASE, 12),
    progressive(DEFAULT, 8, photons=DEFAULT_PHOTONS),
    progressive("progressive, 12,500 photons", 4.5, photons=12_500),
    progressive("progressive, k = 20", 4.5, "--neighbours", 20),
    progressive("progressive, k = 125", 4.5, "--neighbours", 125),
    progressive("progressive, 2 samples", 4.5, "--samples", 2),
    progressive("progressive, 8 samples", 4.5, "--samples", 8),
    progressive("progressive, global", 4.5, "--maps", "global"),
    progressive("progressive, shared", 4.5, "--maps", "shared"),
    direct("direct"),
    direct("direct, 200,000 photons", photons=DEFAULT_PHOTONS),
    direct("direct, k = 200", "--neighbours", 200),
    direct("direct, global", "--maps", "global"),
    direct("direct, thesis", "--maps", "thesis"),
    Setting(PATH, 12, ("--integrator", "path")),
)}

# Those that differ from BASE in one number that a user may set.
GRID = [BASE, DEFAULT, *(f"progressive, {what}" for what in (
    "12,500 photons", "k = 20", "k = 125", "2 samples", "8 samples"))]
MOST_REGRET = 1.2
REGRET_PARTS = (0.3, 1)  # of the time for which all of them were measured

# Of a minute of two cores, as hipmap renders if nothing is said of the method; and the referee.
MINUTE = 120
# c of docs/error.md (3) for the marks: other renderers, from which they come, were measured with it.
MARKS_CONSTANT = 0.01
MINUTE_SETTINGS = {setting.name: setting for setting in (
    progressive("progressive", MINUTE, photons=DEFAULT_PHOTONS),
    Setting("path", MINUTE, ("--integrator", "path")),
    Setting("progressive, box", MINUTE, ("--integrator", "progressive"), DEFAULT_PHOTONS, BOX),
)}
# The peer: Blender's path tracer, on the scene as its script makes it, by the box filter, which both
# programs have alike.  Options are render's alone.
CYCLES = Setting("Cycles, box", MINUTE, (), filter=BOX)

# What errors are quoted for: parts of the error that the longest images of BASE have.
QUOTED_PARTS = (1.0, 0.7)
QUOTE_SECONDS = 25  # that a quote and the image it is of take, about


@dataclasses.dataclass(frozen=True)
class Reference:
    """How the truth about a scene is found, and why so.  seconds: of each of the two halves."""

    setting: Setting
    reason: str


LONG_PATH = Reference(
    Setting("path", 65, ("--integrator", "path", "--samples", 16)),
    "no caustics: path tracing finds all light soon and has no bias")
LONG_PROGRESSIVE = Reference(
    progressive("progressive", 65, "--neighbours", 8, photons=1_000_000),
    "paths rarely hit a light through glass or off mirrors; its estimates use a thirtieth of the "
    "default area, so that its bias is small beside the measured one")


def reference_of(scene, by_filter=FILTER):
    reference = LONG_PROGRESSIVE if scene.caustics else LONG_PATH
    setting = dataclasses.replace(reference.setting, filter=by_filter)
    return dataclasses.replace(reference, setting=setting)


def filters_of(scene):
    """Of the references that the scene needs."""
    return (FILTER, BOX) if scene.mark else (FILTER,)


@dataclasses.dataclass(frozen=True)
class Study:
    """size: pixels across an image; references and the images of a minute are twice as wide.
    seeds: images of each setting; minute_seeds: of those of a minute.  share: of all seconds above
    that it may take.  divide: photons are divided by it."""

    size: int
    seeds: int
    minute_seeds: int
    share: float
    divide: int

    @property
    def reference_size(self):
        return 2 * self.size


FULL_MINUTES = 25  # of two cores, about
FULL = Study(size=96, seeds=5, minute_seeds=1, share=1, divide=1)
QUICK = Study(size=12, seeds=2, minute_seeds=1, share=0.006, divide=100)
REFERENCE_SEED = 1_000_000
MINUTE_SEED = 2_000_000
QUOTE_SEED = 3_000_000
