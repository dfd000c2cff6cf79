"""Writes all furnished scenes: python3 bench/scenes/make_all.py OUTDIR [--detail N]"""

import argparse
import os

from room_writer import write_scene

# pylint: disable=wrong-import-position
import kitchen
import living_room
import museum
import workshop

SCENES = {"kitchen": kitchen, "living_room": living_room, "museum": museum, "workshop": workshop}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", metavar="OUTDIR")
    parser.add_argument("--detail", type=float, default=1.0, metavar="N",
                        help="tessellation relative to the default, the shapes stay [1]")
    options = parser.parse_args()
    os.makedirs(options.folder, exist_ok=True)
    for name, scene in SCENES.items():
        path = os.path.join(options.folder, name + ".glb")
        print(write_scene(scene.build, path, options.detail), flush=True)


if __name__ == "__main__":
    main()
