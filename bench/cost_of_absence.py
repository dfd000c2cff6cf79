#!/usr/bin/env python3
"""Counts what effects cost a scene that has none of them.

    bench/cost_of_absence.py [--scene assets/cornell_diffuse.glb] [--size 24 --photons 3000]

Instructions of a pass on one thread (valgrind's callgrind: one run after another gives the same), and bytes a
photon, of render in build/release over those of a build without the code of all effects but the diffuse lobe: the
sources are copied to build/matte, where MATTE makes constants of the conditions under which effects run.  Exit code 1 if
a ratio is above 1.01 or the two builds' images differ.
"""

import argparse
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
INTEGRATORS = ("path", "progressive", "direct")
MARK = 1.01
FEW_PASSES, MANY_PASSES = 1, 3
MATTE = (
    ("render/shading/interaction.h", "return bsdf().is_diffuse;", "return true;"),
    ("render/shading/interaction.h", "return inside != nullptr;", "return false;"),
    ("render/shading/interaction.h", "if (!is_black(absorption))", "if (false)"),
    ("render/shading/render_scene.h", "return media.has_value();", "return false;"),
    ("render/shading/render_scene.h", "return all_plain || plain[material] != 0;",
     "return true;"),
    ("render/shading/dispersion.h", "if (at.bsdf().dispersion > 0 && at.solid)", "if (false)"),
    ("render/media/medium_stack.h", "kMost = 8;", "kMost = 1;"),
    ("render/lights/light_set.h", "return !lights.met.empty() || lights.chosen_are_met;",
     "return false;"),
    ("render/lights/emissive_mesh.h", "return !material.textured", "return true"),
    ("render/paths/direct_light.h", "scene.lit_by_faces ?", "true ?"),
    ("render/paths/path_state.h", "if (!scene.clear)", "if (false)"),
)
FEW_PHOTONS, MANY_PHOTONS = 200_000, 1_000_000


def build_without(folder):
    """Copies the sources to a folder, takes the effects out, and builds render there."""
    source = folder / "source"
    build = source / "build/release"
    files = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, check=True, capture_output=True,
                           text=True).stdout.split("\0")
    for name in filter(None, files):
        text = (ROOT / name).read_bytes()
        for path, was, becomes in MATTE:
            if path == name:
                if text.count(was.encode()) != 1:
                    sys.exit(f"error: {name}: not once \"{was}\"; bring MATTE in line")
                text = text.replace(was.encode(), becomes.encode())
        to = source / name
        to.parent.mkdir(parents=True, exist_ok=True)
        if not to.exists() or to.read_bytes() != text:
            to.write_bytes(text)
    subprocess.run(["cmake", "--preset", "release", "-DHIPMAP_TESTS=OFF"], cwd=source, check=True,
                   stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", build, "--target", "render"], check=True,
                   stdout=subprocess.DEVNULL)
    return build


class Lab:
    def __init__(self, options, folder):
        self.options, self.folder = options, pathlib.Path(folder)
        self.partition = self.folder / "scene.hpm"
        self.image = self.folder / "image.pfm"
        self.run([options.tools / "bin/preprocess", options.scene, "-o", self.partition])

    def run(self, command):
        return subprocess.run([str(word) for word in command], check=True, text=True,
                              capture_output=True).stderr

    def command(self, build, *arguments):
        return [build / "bin/render", self.options.scene, self.partition, "-o", self.image,
                "--threads", "1", *arguments]

    def instructions(self, build, integrator):
        """Of a pass: what is done once, as reading the scene, is taken off.  And the image."""
        counts = []
        for passes in (FEW_PASSES, MANY_PASSES):
            printed = self.run(["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null",
                                *self.command(build, "--integrator", integrator, "--size",
                                              self.options.size, "--photons", self.options.photons,
                                              "--passes", passes)])
            counts.append(int(re.search(r"Collected : (\d+)", printed)[1]))
        return (counts[1] - counts[0]) / (MANY_PASSES - FEW_PASSES), self.image.read_bytes()

    def bytes_of_photon(self, build):
        """Growth of the most memory held over that of the photons kept."""
        memory, photons = [], []
        for paths in (FEW_PHOTONS, MANY_PHOTONS):
            stats = self.folder / "stats.json"
            command = self.command(build, "--integrator", "direct", "--size", 8, "--passes", 1,
                                   "--photons", paths, "--stats", stats)
            with subprocess.Popen([str(word) for word in command],
                                  stderr=subprocess.DEVNULL) as process:
                memory.append(os.wait4(process.pid, 0)[2].ru_maxrss * 1024)
            photons.append(json.loads(stats.read_text())["photons"]["stored"])
        return (memory[1] - memory[0]) / (photons[1] - photons[0])


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--tools", type=pathlib.Path, default=ROOT / "build/release",
                        help="the build to measure [build/release]")
    parser.add_argument("--scene", type=pathlib.Path, default=ROOT / "assets/cornell_diffuse.glb")
    parser.add_argument("--size", type=int, default=64, help="pixels across [64]")
    parser.add_argument("--photons", type=int, default=20_000, help="light paths a pass [20000]")
    return parser.parse_args()


def main():
    options = parse_options()
    without = build_without(ROOT / "build/matte")
    good = True
    with tempfile.TemporaryDirectory() as folder:
        lab = Lab(options, folder)
        print(f"{'':12} {'with':>14} {'without':>14} {'ratio':>8}")
        for integrator in INTEGRATORS:
            ours, image = lab.instructions(options.tools, integrator)
            theirs, other_image = lab.instructions(without, integrator)
            print(f"{integrator:12} {ours:14.0f} {theirs:14.0f} {ours / theirs:8.4f}")
            good = good and ours <= MARK * theirs and image == other_image
            if image != other_image:
                print(f"{integrator}: the images differ")
        ours, theirs = lab.bytes_of_photon(options.tools), lab.bytes_of_photon(without)
        print(f"{'bytes/photon':12} {ours:14.1f} {theirs:14.1f} {ours / theirs:8.4f}")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
