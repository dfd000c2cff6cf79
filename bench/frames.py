#!/usr/bin/env python3
"""Times frames of an animation made in one run of each tool, and one by one, and compares the files.

    bench/frames.py FOLDER_OF_TOOLS SCENE FIRST LAST [option of render...]

Prints the seconds of both tools both ways and their ratio; exit code 1 if a file differs.
"""

import filecmp
import os
import subprocess
import sys
import tempfile
import time


def run(command):
    """Seconds that a command took."""
    begin = time.monotonic()
    subprocess.run(command, check=True, stderr=subprocess.DEVNULL)
    return time.monotonic() - begin


def seconds_of(tools, scene, ranges, folder, options):
    """Of preprocess and of render, each called once for every range of frames."""
    partition = os.path.join(folder, "scene.hpm")
    preprocess = [os.path.join(tools, "preprocess"), scene, "-o", partition, "--frames"]
    render = [os.path.join(tools, "render"), scene, partition, "-o",
              os.path.join(folder, "image.pfm"), *options, "--frames"]
    return [sum(run([*command, frames]) for frames in ranges) for command in (preprocess, render)]


def main(tools, scene, first, last, *options):
    with tempfile.TemporaryDirectory() as row, tempfile.TemporaryDirectory() as alone:
        together = seconds_of(tools, scene, [f"{first}:{last}"], row, options)
        apart = seconds_of(tools, scene, [*map(str, range(int(first), int(last) + 1))],
                           alone, options)
        names = sorted(os.listdir(row))
        assert names == sorted(os.listdir(alone))
        differing = filecmp.cmpfiles(row, alone, names, shallow=False)[1:]
    for tool, one, many in zip(("preprocess", "render"), together, apart):
        print(f"{tool}: {one:.2f} s in one run, {many:.2f} s one by one, ratio {many / one:.2f}")
    print(f"{len(names)} files, {len(sum(differing, []))} of them not the same")
    return 1 if any(differing) else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
