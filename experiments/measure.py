"""Runs preprocess and render for the experiment and reads what they measured."""

import dataclasses
import json
import pathlib
import struct
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SCENES = {1: "axis_aligned", 2: "hexagonal", 3: "egg_chair"}
MODES = ("global", "shared", "thesis", "hierarchical")
# Light paths for each light primitive and neighbours k of tests 1 to 5 (dissertation).
TESTS = ((2500, 25), (5000, 50), (15000, 150), (30000, 300), (60000, 600))
ANGLE_DEG = 90  # the dissertation's threshold


@dataclasses.dataclass(frozen=True)
class Bench:
    """tools: folder of the programs.  folder: for their files.  size: pixels across an image.
    divide: photons and k are divided by it."""

    tools: pathlib.Path
    folder: pathlib.Path
    size: int
    repeats: int
    divide: int


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
    command = [str(bench.tools / tool), *map(str, arguments)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        lines = done.stderr.splitlines() or ["no message"]
        sys.exit(f"error: {tool} ended with code {done.returncode}: {lines[-1]}")


def partition_path(bench, scene):
    return bench.folder / f"scene_{scene}.hpm"


def make_partition(bench, scene):
    run_tool(bench, "preprocess", scene_path(scene), "-o", partition_path(bench, scene),
             "--angle", ANGLE_DEG)


def render(bench, scene, mode, photons, k):
    """The statistics (docs/statistics.md) of one pass in which all light is gathered from photons.

    photons: light paths; 0 leaves the maps empty."""
    stats = bench.folder / "stats.json"
    run_tool(bench, "render", scene_path(scene), partition_path(bench, scene),
             "-o", bench.folder / "image.pfm", "--stats", stats, "--maps", mode,
             "--photons", photons, "--neighbours", k, "--local-min", 10 * k,
             "--integrator", "direct", "--direct", "photons", "--diffuse", "lambert",
             "--passes", 1, "--samples", 1, "--size", bench.size)
    return json.loads(stats.read_text())


def image_seconds(stats):
    return stats["seconds"]["image"]


def measure(bench, scene, test, mode):
    """One row of the results; the fastest of the repeats, as others only ever slow it down."""
    per_primitive, k = TESTS[test - 1]
    per_primitive, k = per_primitive // bench.divide, max(2, k // bench.divide)
    photons = per_primitive * light_primitives(scene_path(scene))
    runs = [render(bench, scene, mode, photons, k) for _ in range(bench.repeats)]
    empty = [render(bench, scene, mode, 0, k) for _ in range(bench.repeats)]
    image, without = (min(map(image_seconds, some)) for some in (runs, empty))
    kinds = [runs[0]["photons"][kind] for kind in ("caustic", "global")]
    return {
        "scene": scene, "test": test, "mode": mode, "k": k, "local_min": 10 * k,
        "per_primitive": per_primitive, "emitted": photons,
        "aimed": runs[0]["photons"]["aimed"], "stored": runs[0]["photons"]["stored"],
        "shared_maps": sum(kind["shared_maps"] for kind in kinds),
        "local_maps": sum(kind["local_maps"] for kind in kinds),
        "build_s": min(run["seconds"]["maps"] for run in runs),
        "image_s": image, "empty_s": without, "net_s": image - without,
    }
