#!/usr/bin/env python3
"""Times frames of an animation made in one run of each tool, and one by one, and compares the files.

    bench/frames.py FOLDER_OF_TOOLS SCENE FIRST LAST [option of render...]

Prints the seconds of both tools both ways and their ratio, by the clock and by the processor, which other
work on the machine disturbs less; exit code 1 if a file differs.
"""

import filecmp
import os
import resource
import subprocess
import sys
import tempfile
import time


def now():
    """Seconds by the clock, and of the processor by all commands that have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.monotonic(), used.ru_utime + used.ru_stime


def run(commands):
    """Both seconds that commands took."""
    begin = now()
    for command in commands:
        subprocess.run(command, check=True, stderr=subprocess.DEVNULL)
    return [end - first for first, end in zip(begin, now())]


def seconds_of(tools, scene, ranges, folder, options):
    """Both of preprocess and of render, each called once for every range of frames."""
    partition = os.path.join(folder, "scene.hpm")
    preprocess = [os.path.join(tools, "preprocess"), scene, "-o", partition, "--frames"]
    render = [os.path.join(tools, "render"), scene, partition, "-o",
              os.path.join(folder, "image.pfm"), *options, "--frames"]
    return [run([*command, frames] for frames in ranges) for command in (preprocess, render)]


def main(tools, scene, first, last, *options):
    with tempfile.TemporaryDirectory() as row, tempfile.TemporaryDirectory() as alone:
        together = seconds_of(tools, scene, [f"{first}:{last}"], row, options)
        apart = seconds_of(tools, scene, [*map(str, range(int(first), int(last) + 1))],
                           alone, options)
        names = sorted(os.listdir(row))
        assert names == sorted(os.listdir(alone))
        differing = filecmp.cmpfiles(row, alone, names, shallow=False)[1:]
    for tool, one, many in zip(("preprocess", "render"), together, apart):
        for unit, here, there in zip(("s", "s of the processor"), one, many):
            print(f"{tool}: {here:.2f} {unit} in one run, {there:.2f} {unit} one by one, "
                  f"ratio {there / here:.2f}")
    print(f"{len(names)} files, {len(sum(differing, []))} of them not the same")
    return 1 if any(differing) else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
