"""Memory that runs out, in every stage: exit code 4, one line that says what to lower, and no file left behind.

    out_of_memory_test.py FOLDER_OF_TOOLS SCENE [--soak]

With --soak: hundreds of limits, and options at random.  Exit code 77 where the programs do not run under a limit at
all, as those built with sanitizers.
"""

import os
import random
import resource
import subprocess
import sys

import tools
from tools import Tools, ToolsTestCase

SOAK = "--soak" in sys.argv
MIB = 2**20
START = 64  # MiB; the programs and their libraries take about that much of the address space
SEED = 5


def run_within(mib, tool, *arguments):
    limit = mib * MIB

    def set_limits():
        resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    command = [os.path.join(Tools.folder, tool), *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL,
                          check=False, preexec_fn=set_limits)


class OutOfMemory(ToolsTestCase):
    def setUp(self):
        super().setUp()
        self.random = random.Random(SEED)

    def check(self, limits, tool, *arguments):
        """Returns how many of the runs ran out of memory."""
        failed = 0
        for mib in limits:
            with self.subTest(mib=mib, arguments=arguments):
                done = run_within(mib, tool, *arguments)
                if done.returncode == 127:  # the system's loader has no room for the libraries
                    continue
                self.assertIn(done.returncode, (0, 4), done.stderr)
                errors = [line for line in done.stderr.splitlines() if line.startswith("error: ")]
                self.assertEqual(len(errors), done.returncode // 4, done.stderr)
                self.assertFalse([name for name in os.listdir(self.folder) if ".tmp" in name])
                if done.returncode == 0:
                    continue
                failed += 1
                self.assertRegex(errors[0], "memory; (lower|export) ")
                self.assertEqual(done.stderr.splitlines()[-1], errors[0])
        return failed

    def limits(self, most, few):
        count = 300 if SOAK else few
        step = (most - START) / count
        return [round(START + step * (i + self.random.random())) for i in range(count)]

    def test_preprocess(self):
        os.mkdir(self.path("images"))
        for limits, threads in ((self.limits(160, 6), 4), (self.limits(120, 4), 1)):
            self.assertGreater(
                self.check(limits, "preprocess", Tools.scene, "-o", self.path("out.hpm"),
                           "--threads", threads, "--images", self.path("images")), 0)

    def test_render(self):
        self.write_partition()
        for limits, threads in ((self.limits(240, 6), 4), (self.limits(160, 4), 1)):
            self.assertGreater(
                self.check(limits, "render", Tools.scene, self.path("scene.hpm"), "-o",
                           self.path("out.exr"), "--size", "512x512", "--photons", 300000,
                           "--passes", 1, "--threads", threads, "--state", self.path("state")), 0)

    def test_merge(self):
        """A state that memory does not hold is not called damaged, and not left out."""
        self.write_partition()
        for first in (0, 1):
            self.succeed("render", Tools.scene, self.path("scene.hpm"), "-o", self.path("out.pfm"), "--size", "320x256",
                         "--integrator", "path", "--samples", 1, "--first-pass", first, "--passes", 1, "--state",
                         self.path(f"{first}.state"))
        os.mkdir(self.path("states"))
        for first in (0, 1):
            os.rename(self.path(f"{first}.state"), self.path(f"states/{first}.state"))
        failed = self.check(self.limits(170, 16), "render", "merge", self.path("states"), "-o", self.path("all.pfm"))
        self.assertGreater(failed, 0)


if __name__ == "__main__":
    Tools.folder = sys.argv[1]
    if run_within(1000, "render", "--version").returncode != 0:
        print("skipped: the programs do not run within a limit of memory")
        sys.exit(77)
    tools.main(sys.argv)
