"""Runs preprocess and render for the experiment and reads what they measured."""

import dataclasses
import json
import pathlib
import struct

import programs

ROOT = pathlib.Path(__file__).resolve().parent.parent
SCENES = {1: "axis_aligned", 2: "hexagonal", 3: "egg_chair"}
MODES = ("global", "shared", "thesis", "hierarchical")
TREES = ("balanced", "unbalanced", "wide")
# Light paths for each light primitive and neighbours k of tests 1 to 5 (dissertation).
TESTS = {1: (2500, 25), 2: (5000, 50), 3: (15000, 150), 4: (30000, 300), 5: (60000, 600)}
ANGLE_DEG = 90  # the dissertation's threshold
LOCAL_MIN_PER_NEIGHBOUR = 10  # the dissertation's M / k
MANY_PATHS = 200_000
ROUNDS_OF_MANY = 2  # times to render so many light paths or more, if it may be more


@dataclasses.dataclass(frozen=True)
class Bench:
    """tools: folder of the programs.  folder: for their files.  size: pixels across an image.
    most_rounds: of each rendering; rounds_asked: as many, whatever it takes; 0: not asked.  divide: photons and k are divided by it."""

    tools: pathlib.Path
    folder: pathlib.Path
    size: int
    most_rounds: int
    divide: int
    rounds_asked: int = 0


@dataclasses.dataclass(frozen=True)
class Setting:
    """One rendering.  ratio: M / k."""

    scene: int
    test: int
    mode: str
    tree: str
    estimate: str = "thesis"
    tiers: str = "paying"
    ratio: float = LOCAL_MIN_PER_NEIGHBOUR


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
    """Short runs are disturbed more, and repeated more often."""
    if bench.rounds_asked:
        return bench.rounds_asked
    many = light_paths(bench, scene, test) >= MANY_PATHS
    return min(bench.most_rounds, ROUNDS_OF_MANY) if many else bench.most_rounds


def neighbours(bench, test):
    return max(2, TESTS[test][1] // bench.divide)


def render(bench, setting, photons):
    """The statistics (docs/statistics.md) of one pass in which all light is gathered from photons.

    photons: light paths; 0 leaves the maps empty."""
    stats = bench.folder / "stats.json"
    k = neighbours(bench, setting.test)
    run_tool(bench, "render", scene_path(setting.scene), partition_path(bench, setting.scene),
             "-o", bench.folder / "image.pfm", "--stats", stats, "--maps", setting.mode,
             "--tree", setting.tree, "--estimate", setting.estimate, "--tiers", setting.tiers,
             "--photons", photons, "--neighbours", k, "--local-min", round(setting.ratio * k),
             "--integrator", "direct", "--direct", "photons", "--look", "gltf",
             "--passes", 1, "--samples", 1, "--size", bench.size)
    return json.loads(stats.read_text())


def summary(stats):
    """Of one rendering, what the tables need.  Seconds are of the processor, of all threads."""
    photons = stats["photons"]
    kinds = {kind: photons[kind] for kind in ("caustic", "global")}
    count = {name: sum(kind[name] for kind in kinds.values())
             for name in ("shared_maps", "local_maps", "group_maps")}
    return {"stored": photons["stored"], "aimed": photons["aimed"], **count,
            "largest_map": max(kind["largest_map"] for kind in kinds.values()),
            "kinds": {name: {key: kind[key] for key in ("stored", "queries", "shared_maps",
                                                        "local_maps", "local", "group")
                             if key in kind} for name, kind in kinds.items()},
            "build_s": stats["processor_seconds"]["maps"],
            "image_s": stats["processor_seconds"]["image"]}


def measure_together(bench, settings, ran):
    """Rows of some settings of one scene and test, measured in turn again and again, so that what
    else the machine does falls on all alike.  ran(setting, row): after each rendering."""
    scene, test = settings[0].scene, settings[0].test
    photons = light_paths(bench, scene, test)
    rows = [{**dataclasses.asdict(setting), "k": neighbours(bench, test), "emitted": photons,
             "build_runs": [], "image_runs": [], "empty_runs": []} for setting in settings]
    for _ in range(rounds(bench, scene, test)):
        empty = summary(render(bench, settings[0], 0))["image_s"]
        for setting, row in zip(settings, rows):
            done = summary(render(bench, setting, photons))
            row["build_runs"].append(done.pop("build_s"))
            row["image_runs"].append(done.pop("image_s"))
            row["empty_runs"].append(empty)
            row.update(done)
            ran(setting, row)
    return [complete(row) for row in rows]


def complete(row):
    """The fastest of the runs counts, as others only ever slow it down."""
    image, empty = min(row["image_runs"]), min(row["empty_runs"])
    return {**row, "build_s": min(row["build_runs"]), "image_s": image, "empty_s": empty,
            "net_s": image - empty}


def net_runs(row):
    return [image - row["empty_s"] for image in row["image_runs"]]


def ratio(above, below, of=net_runs):
    """How many times the cost of `below` that of `above` is: by the fastest runs, and the least and
    the most of the rounds in which both were measured."""
    rounds = [a / b for a, b in zip(of(above), of(below))]
    return min(of(above)) / min(of(below)), min(rounds), max(rounds)
