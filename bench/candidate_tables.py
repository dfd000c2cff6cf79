#!/usr/bin/env python3
"""Writes the tables of docs/candidates.md: candidates beside the maps that mode thesis builds, and
what predicting them costs.

    candidate_tables.py FOLDER_OF_TOOLS WORK_FOLDER [--real FOLDER] [--before FOLDER_OF_TOOLS] [--to docs/candidates.md]

--real: scenes not made for hipmap, searched for in all folders below.  --before: tools without the
prediction, to compare the cost with.  Writes 150 MB of scenes; 8 minutes.
"""

import argparse
import os
import pathlib
import statistics
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ASSETS = HERE.parent / "assets"
RUNS = 3
LARGE = (("terrain", 1_000_000), ("objects", 1_000_000), ("soup", 1_000_000))


def run(*command):
    return subprocess.run([str(part) for part in command], check=True, stdout=subprocess.PIPE,
                          text=True).stdout


def compare(tools, scenes):
    return run(tools / "candidates", *scenes)


def others(tools, work, real):
    run(sys.executable, HERE / "held_back_rooms.py", work / "held")
    run(sys.executable, HERE / "scenes/make_all.py", work / "furnished")
    scenes = sorted(work.glob("furnished/*.glb")) + sorted(work.glob("held/*.glb"))
    if real:
        found = (path for path in real.rglob("*") if path.suffix in (".glb", ".gltf", ".obj"))
        scenes = sorted(found) + scenes
    return compare(tools, scenes)


def cost(tool, scene, work):
    """Medians of processor seconds and of megabytes at the peak."""
    seconds, megabytes = [], []
    for _ in range(RUNS):
        command = [str(tool), str(scene), "-o", str(work / "cost.hpm"), "--quiet"]
        with subprocess.Popen(command, stderr=subprocess.DEVNULL) as process:
            _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        assert process.returncode == 0, command
        seconds.append(used.ru_utime + used.ru_stime)
        megabytes.append(used.ru_maxrss / 1024)
    return statistics.median(seconds), statistics.median(megabytes)


def costs(tools, before, work):
    scenes = []
    for kind, triangles in LARGE:
        scenes.append(work / f"{kind}.glb")
        run(tools / "large_scene", kind, triangles, scenes[-1])
    scenes.append(work / "room.glb")
    run(sys.executable, HERE / "subdivided_room.py", scenes[-1], 4)
    lines = ["| scene | s before | s | MB before | MB |", "|---|---|---|---|---|"]
    for scene in scenes + [ASSETS / "cornell.glb"]:
        old, new = (cost(folder / "preprocess", scene, work) for folder in (before, tools))
        lines.append(f"| {scene.stem} | {old[0]:.2f} | {new[0]:.2f} | {old[1]:.0f} | {new[1]:.0f} |")
    return "\n".join(lines) + "\n"


def put(text, name, table):
    before, mark, rest = text.partition(f"<!-- {name} -->\n")
    assert mark, name
    return before + mark + table + "<!-- end -->" + rest.partition("<!-- end -->")[2]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("tools", type=pathlib.Path)
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("--real", type=pathlib.Path)
    parser.add_argument("--before", type=pathlib.Path)
    parser.add_argument("--to", type=pathlib.Path)
    asked = parser.parse_args()
    asked.work.mkdir(parents=True, exist_ok=True)
    bundled = sorted(ASSETS.glob("*.glb")) + sorted(ASSETS.glob("effects/*.glb"))
    tables = {"bundled": compare(asked.tools, bundled),
              "others": others(asked.tools, asked.work, asked.real)}
    if asked.before:
        tables["cost"] = costs(asked.tools, asked.before, asked.work)
    for name, table in tables.items():
        print(f"{name}\n{table}", flush=True)
        if asked.to:
            asked.to.write_text(put(asked.to.read_text(encoding="utf-8"), name, table),
                                encoding="utf-8")


if __name__ == "__main__":
    main()
