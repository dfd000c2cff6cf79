"""Runs map_costs for the experiment and reads what it measured."""

import dataclasses
import itertools
import json
import pathlib
import struct

import programs
import ratios

ROOT = pathlib.Path(__file__).resolve().parent.parent
SCENES = {1: "axis_aligned", 2: "hexagonal_room", 3: "egg_room", 4: "egg_chair"}
CELLS = 4  # scene 3 as its walls, not its furniture, have the local maps
TESTS_OF_CELLS = (2,)
MODES = ("global", "shared", "thesis", "hierarchical")
TREES = ("balanced", "unbalanced", "wide")
# Light paths for each light primitive and neighbours k of tests 1 to 5 (dissertation).
TESTS = {1: (2500, 25), 2: (5000, 50), 3: (15000, 150), 4: (30000, 300), 5: (60000, 600)}
EVERY = {4: 2, 5: 4}  # test: one band of an image's rows of so many is rendered; else all are
ANGLE_DEG = 90  # the dissertation's threshold
LOCAL_MIN_PER_NEIGHBOUR = 10  # the dissertation's M / k
MANY_PATHS = 2_000_000
ROUNDS_OF_MANY = 3  # rounds of so many light paths or more, if there may be more
LEAST_ROUNDS = 5  # of fewer, some look precise by chance
PRECISE = 0.03  # half the interval of a ratio at which rounds end
REFERENCE, MOST_REFERENCE = 40, 8_000_000  # light paths of a reference for each of an image; at most
LEVELS = ("shared_maps", "local_maps", "group_maps")


@dataclasses.dataclass(frozen=True)
class Bench:
    """tools: folder of the programs.  folder: for their files.  size: pixels across an image.
    most_rounds: of each scene and test.  divide: photons and k are divided by it."""

    tools: pathlib.Path
    folder: pathlib.Path
    size: int
    most_rounds: int
    divide: int


@dataclasses.dataclass(frozen=True)
class Setting:
    """One way to put photons into maps.  ratio: M / k.  together: caustic photons are in the maps of
    the others.  control: measured a second time, to see what noise alone does."""

    mode: str
    tree: str
    estimate: str = "thesis"
    tiers: str = "paying"
    ratio: float = LOCAL_MIN_PER_NEIGHBOUR
    together: bool = False
    control: bool = False


def label(scene):
    """What the document calls it."""
    return "3, walls in cells" if scene == CELLS else str(scene)


def scene_path(scene):
    return ROOT / "experiments/scenes" / (SCENES[scene] + ".glb")


def light_primitives(path):
    """Number of glowing triangles and of lamps of a .glb file."""
    data = path.read_bytes()
    document = json.loads(data[20:20 + struct.unpack_from("<I", data, 12)[0]])
    glowing = {i for i, material in enumerate(document["materials"])
               if any(material.get("emissiveFactor", (0, 0, 0)))}
    count = 0
    for node in document["nodes"]:
        count += "KHR_lights_punctual" in node.get("extensions", {})
        for part in document["meshes"][node["mesh"]]["primitives"] if "mesh" in node else ():
            if part.get("material") in glowing:
                count += document["accessors"][part["indices"]]["count"] // 3
    return count


def run_tool(bench, tool, *arguments):
    return programs.run(bench.tools, tool, *arguments).output


def partition_path(bench, scene):
    return bench.folder / f"scene_{scene}.hpm"


def make_partition(bench, scene):
    run_tool(bench, "preprocess", scene_path(scene), "-o", partition_path(bench, scene),
             "--angle", ANGLE_DEG)


def light_paths(bench, scene, test):
    return TESTS[test][0] // bench.divide * light_primitives(scene_path(scene))


def rounds(bench, scene, test):
    """The most rounds."""
    many = light_paths(bench, scene, test) >= MANY_PATHS
    return min(bench.most_rounds, ROUNDS_OF_MANY) if many else bench.most_rounds


def neighbours(bench, test):
    return max(2, TESTS[test][1] // bench.divide)


def as_option(setting, k):
    """A setting as map_costs reads it."""
    text = (f"--maps {setting.mode} --tree {setting.tree} --estimate {setting.estimate} "
            f"--tiers {setting.tiers} --local-min {round(setting.ratio * k)}")
    return f"--setting={text} --together" if setting.together else f"--setting={text}"


def arguments(bench, scene, test, settings):
    """Of map_costs.  Errors are asked for where caustic photons are together with the others."""
    k, paths = neighbours(bench, test), light_paths(bench, scene, test)
    every = EVERY.get(test, 1)
    reference = min(REFERENCE * paths, MOST_REFERENCE)
    asked = any(setting.together for setting in settings)
    return [scene_path(scene), "--photons", paths, "--neighbours", k, "--angle", ANGLE_DEG,
            "--size", bench.size, "--every", every, "--rounds", rounds(bench, scene, test),
            *(("--reference", reference) if asked else ()),
            *(as_option(setting, k) for setting in settings)]


def maps(row, kind, level):
    """How many maps of a level this setting built of a kind of photon."""
    return row["kinds"][kind].get(level, 0)


def compared(rows):
    """Pairs of rows whose ratios the document has: those on trees of one kind."""
    return [pair for pair in itertools.combinations(rows, 2) if pair[0]["tree"] == pair[1]["tree"]]


def is_precise(rows):
    """Whether the ratios of all that are compared have intervals within PRECISE."""
    found = [ratio(*pair) for pair in compared(rows)]
    return all(one is not None and one.half() <= PRECISE for one in found)


def add_round(rows, measured):
    """measured: of one round, in the order of the rows."""
    for row, one in zip(rows, measured):
        for name in ("build", "image", "empty"):
            row[f"{name}_runs"].append(one[f"{name}_s"])
        row["kinds"] = one["kinds"]
        row["stored"] = sum(kind["stored"] for kind in one["kinds"].values())
        if "errors" in one:
            row["errors"] = one["errors"]


def measure(bench, scene, test, settings):
    """Rows of some settings of one scene and test, measured in turn again and again, so that what
    else the machine does falls on all alike, until their ratios are precise."""
    rows = []
    least = min(LEAST_ROUNDS, rounds(bench, scene, test))
    with programs.lines_of(bench.tools, "map_costs", *arguments(bench, scene, test, settings)) as lines:
        about = json.loads(next(lines))
        rows = [{"scene": scene, "test": test, **dataclasses.asdict(setting),
                 "k": neighbours(bench, test), **about,
                 "build_runs": [], "image_runs": [], "empty_runs": []} for setting in settings]
        for line in lines:
            add_round(rows, json.loads(line))
            if len(rows[0]["image_runs"]) >= least and is_precise(rows):
                break
    return [complete(row) for row in rows]


def complete(row):
    """Means of the rounds, for a whole image."""
    return {**row, "build_s": ratios.mean_cost(row["build_runs"]),
            "image_s": ratios.mean_cost(row["image_runs"]) / row["share"],
            "empty_s": ratios.mean_cost(row["empty_runs"]) / row["share"],
            "net_s": ratios.mean_cost(net_runs(row))}


def net_runs(row):
    """The net query costs of the rounds, for a whole image."""
    return [(image - empty) / row["share"]
            for image, empty in zip(row["image_runs"], row["empty_runs"])]


def ratio(above, below, of=net_runs):
    """How many times the cost of `below` that of `above` is, by the rounds in which both were
    measured; None if lost in noise."""
    return ratios.of_rounds(of(above), of(below))
