"""Runs preprocess and render for the experiment and reads what they measured."""

import dataclasses
import itertools
import json
import math
import pathlib
import random
import struct

import programs
import ratios

ROOT = pathlib.Path(__file__).resolve().parent.parent
SCENES = {1: "axis_aligned", 2: "hexagonal", 3: "egg_chair"}
MODES = ("global", "shared", "thesis", "hierarchical")
TREES = ("balanced", "unbalanced", "wide")
# Light paths for each light primitive and neighbours k of tests 1 to 5 (dissertation).
TESTS = {1: (2500, 25), 2: (5000, 50), 3: (15000, 150), 4: (30000, 300), 5: (60000, 600)}
ANGLE_DEG = 90  # the dissertation's threshold
LOCAL_MIN_PER_NEIGHBOUR = 10  # the dissertation's M / k
MANY_PATHS = 2_000_000
ROUNDS_OF_MANY = 3  # times to render so many light paths or more, if it may be more
LEAST_ROUNDS = 5  # of fewer, some look precise by chance
PRECISE = 0.03  # half the interval of a ratio at which rounds end
MOST_WIDER = 4  # times as wide as asked, an image whose pixels take too little time
LEVELS = ("shared_maps", "local_maps", "group_maps")


@dataclasses.dataclass(frozen=True)
class Bench:
    """tools: folder of the programs.  folder: for their files.  size: pixels across an image.
    most_rounds: of each rendering.  divide: photons and k are divided by it.  net_seconds: what the
    photons of an image take at least, by a larger image if need be.  rounds_asked: as many rounds,
    whatever it takes; 0: not asked."""

    tools: pathlib.Path
    folder: pathlib.Path
    size: int
    most_rounds: int
    divide: int
    net_seconds: float = 0
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
    """The most rounds: short runs are disturbed more, and repeated more often."""
    if bench.rounds_asked:
        return bench.rounds_asked
    many = light_paths(bench, scene, test) >= MANY_PATHS
    return min(bench.most_rounds, ROUNDS_OF_MANY) if many else bench.most_rounds


def neighbours(bench, test):
    return max(2, TESTS[test][1] // bench.divide)


def render(bench, setting, photons, size):
    """The statistics (docs/statistics.md) of one pass in which all light is gathered from photons.

    photons: light paths; 0 leaves the maps empty.  size: pixels across."""
    stats = bench.folder / "stats.json"
    k = neighbours(bench, setting.test)
    run_tool(bench, "render", scene_path(setting.scene), partition_path(bench, setting.scene),
             "-o", bench.folder / "image.pfm", "--stats", stats, "--maps", setting.mode,
             "--tree", setting.tree, "--estimate", setting.estimate, "--tiers", setting.tiers,
             "--photons", photons, "--neighbours", k, "--local-min", round(setting.ratio * k),
             "--integrator", "direct", "--direct", "photons", "--look", "gltf",
             "--passes", 1, "--samples", 1, "--size", size)
    return json.loads(stats.read_text())


def summary(stats):
    """Of one rendering, what the tables need.  Seconds are of the processor, of all threads."""
    photons = stats["photons"]
    kinds = {kind: photons[kind] for kind in ("caustic", "global")}
    return {"stored": photons["stored"], "aimed": photons["aimed"],
            "kinds": {name: {key: kind[key] for key in ("stored", "queries", *LEVELS, "local",
                                                        "group") if key in kind}
                      for name, kind in kinds.items()},
            "build_s": stats["processor_seconds"]["maps"],
            "image_s": stats["processor_seconds"]["image"]}


def maps(row, kind, level):
    """How many maps of a level this rendering built of a kind of photon."""
    return row["kinds"][kind].get(level, 0)


def image_size(bench, setting, photons):
    """Pixels across an image whose photons take `net_seconds`, by a rendering of the size asked."""
    if bench.net_seconds == 0:
        return bench.size
    net = (summary(render(bench, setting, photons, bench.size))["image_s"] -
           summary(render(bench, setting, 0, bench.size))["image_s"])
    wider = math.sqrt(bench.net_seconds / max(net, 1e-3))
    return round(bench.size * min(max(wider, 1), MOST_WIDER))


def image_sizes(bench, settings, photons):
    """{tree: pixels across}: as large for all settings that are compared."""
    cheapest = {setting.tree: setting
                for setting in sorted(settings, key=lambda one: one.mode != "global")}
    sizes = {tree: image_size(bench, setting, photons) for tree, setting in cheapest.items()}
    if len(sizes) < len(settings):
        return sizes
    return dict.fromkeys(sizes, min(sizes.values()))


def compared(rows):
    """Pairs of rows: those on trees of one kind; all where each has a kind of its own."""
    pairs = list(itertools.combinations(rows, 2))
    return [pair for pair in pairs if pair[0]["tree"] == pair[1]["tree"]] or pairs


def is_precise(rows):
    """Whether the ratios of all that are compared have intervals within PRECISE."""
    found = [ratio(*pair) for pair in compared(rows)]
    return all(one is not None and one.half() <= PRECISE for one in found)


def measure_round(bench, settings, rows, photons):
    """Adds a round to the rows.  The empty images are measured in it too.  Yields (setting, row)."""
    first = {row["size"]: setting for setting, row in zip(settings, rows)}
    empty = {size: summary(render(bench, setting, 0, size))["image_s"]
             for size, setting in first.items()}
    order = list(zip(settings, rows))
    random.Random(len(rows[0]["image_runs"])).shuffle(order)  # no setting always follows another
    for setting, row in order:
        done = summary(render(bench, setting, photons, row["size"]))
        row["build_runs"].append(done.pop("build_s"))
        row["image_runs"].append(done.pop("image_s"))
        row["empty_runs"].append(empty[row["size"]])
        row.update(done)
        yield setting, row


def measure_together(bench, settings, ran):
    """Rows of some settings of one scene and test, measured in turn again and again, so that what
    else the machine does falls on all alike, until their ratios are precise.  ran(setting, row):
    after each rendering."""
    scene, test = settings[0].scene, settings[0].test
    photons = light_paths(bench, scene, test)
    sizes = image_sizes(bench, settings, photons)
    rows = [{**dataclasses.asdict(setting), "k": neighbours(bench, test), "emitted": photons,
             "size": sizes[setting.tree], "scale": (sizes[setting.tree] / bench.size) ** 2,
             "build_runs": [], "image_runs": [], "empty_runs": []} for setting in settings]
    for round_ in range(rounds(bench, scene, test)):
        for setting, row in measure_round(bench, settings, rows, photons):
            ran(setting, row)
        if round_ + 1 >= LEAST_ROUNDS and not bench.rounds_asked and is_precise(rows):
            break
    return [complete(row) for row in rows]


def complete(row):
    """Means of the rounds, for an image of the size asked."""
    return {**row, "build_s": ratios.mean_cost(row["build_runs"]),
            "image_s": ratios.mean_cost([image / row["scale"] for image in row["image_runs"]]),
            "empty_s": ratios.mean_cost([empty / row["scale"] for empty in row["empty_runs"]]),
            "net_s": ratios.mean_cost(net_runs(row))}


def net_runs(row):
    """The net query costs of the rounds, for an image of the size asked."""
    return [(image - empty) / row["scale"]
            for image, empty in zip(row["image_runs"], row["empty_runs"])]


def ratio(above, below, of=net_runs):
    """How many times the cost of `below` that of `above` is, by the rounds in which both were
    measured; None if lost in noise."""
    return ratios.of_rounds(of(above), of(below))
