"""What is measured: scenes, methods and their settings, references."""

import dataclasses
import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[2]

WHOLE, EFFECTS = "whole", "no caustics"  # what an image is compared with
REFERENCE_SEED = 1000


@dataclasses.dataclass(frozen=True)
class Scene:
    name: str
    path: pathlib.Path
    whole: tuple  # options of render for a reference of the whole image


# Progressive finds caustics of point lights, which no path from the eye finds; its bias on the curved egg
# chair is several percent, where paths have none.
BY_PROGRESSIVE = ("--integrator", "progressive", "--samples", 4)
BY_PATH = ("--integrator", "path", "--samples", 64)

SCENES = {scene.name: scene for scene in (
    Scene("cornell", ROOT / "assets/cornell.glb", BY_PROGRESSIVE),
    Scene("axis_aligned", ROOT / "experiments/scenes/axis_aligned.glb", BY_PROGRESSIVE),
    Scene("hexagonal", ROOT / "experiments/scenes/hexagonal.glb", BY_PROGRESSIVE),
    Scene("egg_chair", ROOT / "experiments/scenes/egg_chair.glb", BY_PATH),
)}


@dataclasses.dataclass(frozen=True)
class Study:
    """photons: light paths in a pass of hipmap.  divide: what the settings of all methods are divided
    by.  passes: of a reference with caustics and of one without."""

    width: int
    seeds: int
    photons: int
    divide: int
    passes: tuple


FULL = Study(width=80, seeds=3, photons=40_000, divide=1, passes=(64, 32))
QUICK = Study(width=32, seeds=2, photons=2_000, divide=16, passes=(8, 8))


@dataclasses.dataclass(frozen=True)
class Method:
    """program: render or rivals.  fixed: options of all points of its curve.  points: (option, values),
    several that go together; numbers are divided by Study.divide.  against: what its image is compared
    with.  cannot: what it leaves out or costs, for the document."""

    name: str
    program: str
    fixed: tuple
    points: tuple
    against: tuple
    cannot: str = ""

    def count(self):
        return len(self.points[0][1])

    def arguments(self, point, study):
        out = list(self.fixed)
        if "--integrator" in self.fixed and "path" not in self.fixed:
            out += ["--photons", study.photons]
        for option, values in self.points:
            value = values[point]
            out += [option, max(2, value // study.divide) if isinstance(value, int) else value]
        return out


def of_hipmap(name, *fixed, passes=(2, 8, 24), against=(WHOLE,), cannot=""):
    return Method(name, "render", ("--samples", 4, "--integrator", *fixed), (("--passes", passes),),
                  against, cannot)


def rival(name, *points, against=(WHOLE,), cannot="", fixed=()):
    return Method(name, "rivals", ("--method", name, *fixed), points, against, cannot)


DIRECT, PROGRESSIVE, PATH = "direct", "progressive", "path"
OF_ITS_TIME = "direct, one balanced map"
PATH_EFFECTS = "path, no caustics"
RADIOSITY, MAP, CACHE, BOTH_WAYS, FIELD = (
    "radiosity", "illumination-map", "irradiance-cache", "bidirectional", "light-field")

METHODS = {method.name: method for method in (
    of_hipmap(DIRECT, "direct", cannot="blurs indirect light within the radius of an estimate"),
    of_hipmap(OF_ITS_TIME, "direct", "--maps", "global", "--tree", "balanced", "--estimate", "thesis",
              passes=(2, 8), cannot="that, and leaks light and darkens at edges"),
    of_hipmap(PROGRESSIVE, "progressive",
              cannot="nothing of these scenes; a bias that vanishes"),
    of_hipmap(PATH, "path", passes=(4, 32, 96), cannot="caustics of point lights; noise in other caustics"),
    of_hipmap(PATH_EFFECTS, "path", "--effects=-caustics", passes=(4, 32, 96), against=(EFFECTS,)),
    rival(RADIOSITY, ("--cells", (2_000, 20_000, 80_000)), ("--rays", (100_000, 1_000_000, 4_000_000)),
          ("--samples", (4, 8, 16)), against=(WHOLE, EFFECTS),
          cannot="caustics, gloss in the solution, light that mirrors and glass pass on to surfaces; "
          "shadows finer than a cell"),
    rival(MAP, ("--cells", (2_000, 20_000, 80_000)), ("--rays", (50_000, 500_000, 2_000_000)),
          ("--samples", (4, 8, 32)),
          cannot="indirect light on gloss; detail finer than a cell, and noise in fine cells"),
    rival(CACHE, ("--directions", (64, 256, 512)), ("--tolerance", (0.5, 0.3, 0.25)),
          ("--samples", (4, 8, 16)), against=(WHOLE, EFFECTS),
          cannot="caustics; indirect light on gloss"),
    rival(BOTH_WAYS, ("--samples", (4, 16, 48)),
          cannot="caustics of point lights seen in a mirror or through glass"),
    rival(FIELD, ("--views", (2, 2, 4)), ("--samples", (4, 16, 16)),
          cannot="views beyond its window; sharpness off its plane; what its images lack (those of "
          "`path`)"),
)}
HIPMAP = (DIRECT, PROGRESSIVE, PATH)
RIVALS = (RADIOSITY, MAP, CACHE, BOTH_WAYS, FIELD)

KINDS = (WHOLE, EFFECTS)


def reference(scene, kind):
    """Options of render for half a reference."""
    if kind == WHOLE:
        return scene.whole
    return ("--integrator", "path", "--samples", 16, "--effects=-caustics")


COMMON = ("--threads", 1)
OF_RENDER = ("--look", "gltf", "--filter", "box", "--fireflies", "keep")
