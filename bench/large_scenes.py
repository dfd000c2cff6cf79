#!/usr/bin/env python3
"""Measures preprocess and render on large scenes, and writes the tables of docs/large_scenes.md.

    bench/large_scenes.py FOLDER_OF_TOOLS WORK_FOLDER [--millions M...] [--only triangles|instances|textures|lookups]
                          [--to docs/large_scenes.md]

Scenes come from the programs large_scene and textured_scene.  A triangle needs 60 bytes of disk and 200 bytes of
memory, the textures 7 GB of both.  The text between <!-- triangles -->, <!-- instances -->, <!-- textures --> or
<!-- lookups --> and <!-- end --> in the file is replaced.  lookups needs texture_lookups (bench/CMakeLists.txt).
"""

import argparse
import json
import os
import re
import subprocess
import sys
import time

STAGES = ("load scene", "weld vertices", "find half-edges", "build tree", "join seams",
          "build trees of maps", "find self-distances", "find group candidates", "find contacts",
          "summarise", "predict photons", "write partition")


class Measured:
    """What a program took: seconds, processor seconds, bytes at the peak."""

    def __init__(self, command):
        begun = time.monotonic()
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        said = process.stderr.read()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        self.seconds = time.monotonic() - begun
        self.processor_seconds = usage.ru_utime + usage.ru_stime
        self.peak = usage.ru_maxrss * 1024
        if process.returncode != 0:
            sys.exit(f"{' '.join(command)}: exit code {process.returncode}: {said[-300:]}")


def read_json(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


class Bench:
    def __init__(self, tools, folder):
        self.tools, self.folder = tools, folder

    def tool(self, name):
        return os.path.join(self.tools, name)

    def path(self, name):
        return os.path.join(self.folder, name)

    def write_scene(self, kind, count):
        scene = self.path(f"{kind}_{count:.0f}.glb")
        subprocess.run([self.tool("large_scene"), kind, str(count), scene], check=True)
        return scene

    def preprocess(self, scene, *options):
        measured = Measured([self.tool("preprocess"), scene, "-o", self.path("scene.hpm"), "--json",
                             self.path("scene.json"), *options])
        measured.facts = read_json(self.path("scene.json"))
        return measured

    def render(self, scene, *options):
        measured = Measured([self.tool("render"), scene, self.path("scene.hpm"), "-o", self.path("image.png"),
                             "--size", "320x240", "--passes", "1", "--photons", "1000000", "--stats",
                             self.path("stats.json"), *options])
        measured.facts = read_json(self.path("stats.json"))
        return measured


def row(*cells):
    return "| " + " | ".join(str(cell) for cell in cells) + " |"


def header(*cells):
    return [row(*cells), "|" + "---|" * len(cells)]


def size_rows(name, faces, measured):
    return row(name, f"{measured.seconds:.0f}", f"{measured.processor_seconds:.0f}", f"{measured.peak / 1e9:.2f}",
               f"{measured.peak / faces:.0f}", f"{measured.processor_seconds / faces * 1e6:.2f}")


def table_of_sizes(bench, millions):
    columns = ("s", "processor s", "GB at the peak", "bytes a triangle", "processor us a triangle")
    sizes = header("terrain", *columns)
    stages = header("pass of preprocess, s", *(f"{m:g} M" for m in millions))
    seconds, rays = [], []
    for size in millions:
        scene = bench.write_scene("terrain", size * 1e6)
        made = bench.preprocess(scene)
        faces = made.facts["faces"]
        sizes.append(size_rows(f"preprocess, {size:g} M", faces, made))
        seconds.append(made.facts["seconds"])
        print(sizes[-1], flush=True)
        shown = bench.render(scene)
        sizes.append(size_rows(f"render, {size:g} M", faces, shown))
        rays.append(shown.facts["seconds"])
        print(sizes[-1], flush=True)
        os.remove(scene)
    for stage in STAGES:
        stages.append(row(stage, *(f"{of.get(stage, 0):.2f}" for of in seconds)))
    for stage, name in (("scene", "render: load scene and partition"), ("rays", "render: build Embree's tree")):
        stages.append(row(name, *(f"{of.get(stage, 0):.2f}" for of in rays)))
    return [*sizes, "", *stages]


def table_of_kinds(bench):
    lines = header("scene", "maps", "contacts", "s", "processor s", "GB at the peak", "MB of JSON")
    for kind, count in (("objects", 20e6), ("soup", 5e6), ("terrain", 20e6)):
        scene = bench.write_scene(kind, count)
        made = bench.preprocess(scene)
        lines.append(row(f"{kind}, {count / 1e6:g} M triangles", made.facts["shared_maps"], made.facts["contacts"],
                         f"{made.seconds:.0f}", f"{made.processor_seconds:.0f}", f"{made.peak / 1e9:.2f}",
                         f"{os.path.getsize(bench.path('scene.json')) / 1e6:.1f}"))
        print(lines[-1], flush=True)
        os.remove(scene)
    return lines


def table_of_threads(bench):
    scene = bench.write_scene("terrain", 10e6)
    lines = header("10 M triangles", "s", "processor s")
    for threads in (1, 2):
        made = bench.preprocess(scene, "--threads", str(threads))
        lines.append(row(f"preprocess --threads {threads}", f"{made.seconds:.1f}", f"{made.processor_seconds:.1f}"))
        print(lines[-1], flush=True)
    os.remove(scene)
    return lines


def table_of_bytes(bench):
    """Bytes a triangle in use at the peak of each pass, as the program partition_scale counts them."""
    scene = bench.write_scene("terrain", 10e6)
    said = subprocess.run([bench.tool("partition_scale"), "--scene", scene], stdout=subprocess.PIPE, text=True,
                          check=True).stdout
    os.remove(scene)
    lines = header("terrain of 10 M triangles", "bytes a triangle at the peak")
    for name, size in re.findall(r"(?m)^  (.*?)  +.* (\d+) bytes$", said):
        lines.append(row(name, size))
    return lines


def table_of_instances(bench):
    """Trees that are instances of one mesh, which stand free or are rooted in hills."""
    lines = header("trees of 10,000 triangles", "triangles", "maps", "preprocess: s", "GB at the peak",
                   "MB of the partition file", "render: s", "GB at the peak")
    for kind in ("forest", "wood"):
        for count in (100, 1000, 10_000, 100_000):
            scene = bench.write_scene(kind, count)
            made, shown = bench.preprocess(scene), bench.render(scene)
            lines.append(row(f"{count:,}" + (", rooted" if kind == "wood" else ""),
                             f"{made.facts['faces'] / 1e6:.0f} M", f"{made.facts['shared_maps'] / 1e6:.2f} M",
                             f"{made.seconds:.1f}", f"{made.peak / 1e9:.2f}",
                             f"{os.path.getsize(bench.path('scene.hpm')) / 1e6:.1f}", f"{shown.seconds:.1f}",
                             f"{shown.peak / 1e9:.2f}"))
            print(lines[-1], flush=True)
            os.remove(scene)
    return lines


def table_of_textures(bench):
    """A wall of cards with a texture each, by the memory that their pixels may take."""
    scene = bench.path("textures.glb")
    subprocess.run([bench.tool("textured_scene"), "100", "4096", scene], check=True)
    bench.preprocess(scene)
    lines = header("--texture-cache, MiB", "s", "processor s", "processor s of the image", "GB at the peak")
    for limit in (8192, 4096, 2048, 1024, 256, 16):
        shown = bench.render(scene, "--texture-cache", str(limit))
        of_image = shown.facts["processor_seconds"]["image"]
        lines.append(row(f"{limit:,}", f"{shown.seconds:.0f}", f"{shown.processor_seconds:.0f}", f"{of_image:.1f}",
                         f"{shown.peak / 1e9:.2f}"))
        print(lines[-1], flush=True)
    os.remove(scene)
    return lines


def table_of_lookups(bench):
    return subprocess.run([bench.tool("texture_lookups")], check=True, text=True, capture_output=True).stdout.splitlines()


def table_of_triangles(bench, millions):
    return [*table_of_kinds(bench), "", *table_of_threads(bench), "", *table_of_bytes(bench), "",
            *table_of_sizes(bench, millions)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tools")
    parser.add_argument("folder")
    parser.add_argument("--millions", type=float, nargs="+", default=[1, 10, 30, 90])
    parser.add_argument("--only", choices=("triangles", "instances", "textures", "lookups"))
    parser.add_argument("--to")
    arguments = parser.parse_args()
    bench = Bench(arguments.tools, arguments.folder)
    tables = {"triangles": lambda: table_of_triangles(bench, arguments.millions),
              "instances": lambda: table_of_instances(bench), "textures": lambda: table_of_textures(bench),
              "lookups": lambda: table_of_lookups(bench)}
    for name in [arguments.only] if arguments.only else tables:
        text = "\n".join(tables[name]())
        if not arguments.to:
            continue
        with open(arguments.to, encoding="utf-8") as file:
            page = file.read()
        with open(arguments.to, "w", encoding="utf-8") as file:
            file.write(re.sub(rf"(<!-- {name} -->\n).*?(<!-- end -->)", lambda m, new=text: m[1] + new + "\n" + m[2], page,
                              flags=re.S))


if __name__ == "__main__":
    main()
