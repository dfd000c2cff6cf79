"""render --mpi: the bits of one process, by any number of processes, also after one was killed.

    mpi_test.py FOLDER_OF_TOOLS SCENE [--soak]

With --soak: 1, 2, 4 and 7 processes, processes killed at many moments, and a signal.  Exit code 77 where Open MPI or
a render built with it is missing.
"""

import json
import os
import random
import shutil
import signal
import subprocess
import sys
import time
import unittest

import tools
from tools import Tools, ToolsTestCase

SOAK = "--soak" in sys.argv
PASSES = 900
SEED = 3
ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "ASAN_OPTIONS": "detect_leaks=0"}


def children_of(process):
    """The processes that mpirun started, in order."""
    with open(f"/proc/{process}/task/{process}/children", encoding="ascii") as file:
        return [int(word) for word in file.read().split()]


class Mpi(ToolsTestCase):
    def setUp(self):
        super().setUp()
        self.write_partition()
        self.random = random.Random(SEED)

    def options(self, image, *options):
        return [Tools.scene, self.path("scene.hpm"), "-o", self.path(image), "--size", "16x16",
                "--photons", "3000", *map(str, options)]

    def start(self, ranks, image, *options):
        command = ["mpirun", "--oversubscribe", "--bind-to", "none", "-n", str(ranks),
                   os.path.join(Tools.folder, "render"), *self.options(image, *options), "--threads", "1",
                   "--mpi"]
        return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                stdin=subprocess.DEVNULL, env=ENVIRONMENT)

    def run_ranks(self, ranks, image, *options, code=0):
        with self.start(ranks, image, *options) as mpirun:
            said = mpirun.communicate(timeout=120)[1]
        self.assertEqual(mpirun.returncode, code, said)
        return said

    def test_any_number_of_processes_has_the_bits_of_one(self):
        for rule in (("--passes", 13), ("--error", "15%")) if SOAK else (("--error", "15%"),):
            self.succeed("render", *self.options("one.pfm", *rule))
            for ranks in (1, 2, 4, 7) if SOAK else (2,):
                self.run_ranks(ranks, "all.pfm", *rule, "--state", self.path(f"{ranks}{rule[0]}.state"))
                self.same("one.pfm", "all.pfm")
                print(f"{ranks} processes, {rule}: same bits", flush=True)

    def test_statistics_tell_rounds_and_what_they_took(self):
        self.run_ranks(2, "a.pfm", "--passes", 10, "--error", "0.01%", "--stats", self.path("a.json"),
                       "--state", self.path("a.state"))
        with open(self.path("a.json"), encoding="utf-8") as file:
            stats = json.load(file)
        # Rounds end where the error is looked at: after 4, 6 and 8 passes, and at the last.
        self.assertEqual([check["passes"] for check in stats["error"]["checks"]], [4, 6, 8, 10])
        self.assertEqual(stats["rounds"], 4)
        for stage in ("add", "film", "state"):
            self.assertGreater(stats["seconds"][stage], 0, stage)
            self.assertGreater(stats["processor_seconds"][stage], 0, stage)
        self.assertGreaterEqual(stats["seconds"]["wait"], 0)

    def test_one_line_says_what_is_wrong(self):
        for option in (("--photons", "many"), ("--size", "16x16", "--crop", "0,0,17,1"),
                       ("--stats", self.path("no/folder/a.json")))[0 if SOAK else 1:2 + SOAK]:
            said = self.run_ranks(2, "a.pfm", *option, code=2)
            self.assertEqual(said.count("error: "), 1, said)

    def state_time(self):
        path = self.path("a.state")
        return os.stat(path).st_mtime_ns if os.path.exists(path) else 0

    def kill_one(self, ranks, seconds):
        """Kills a process some time after it wrote a state; returns whether the render had gone on with a state."""
        with self.start(ranks, "killed.pfm", "--passes", PASSES, "--state", self.path("a.state")) as mpirun:
            before = self.state_time()
            while self.state_time() == before and mpirun.poll() is None:
                time.sleep(0.01)
            time.sleep(seconds)
            started = children_of(mpirun.pid) if mpirun.poll() is None else []
            if started:
                os.kill(self.random.choice(started), signal.SIGKILL)
            said = mpirun.communicate(timeout=120)[1]
            if mpirun.returncode != 0:
                self.assertFalse(os.path.exists(self.path("killed.pfm.tmp")))
            return "resuming with" in said

    @unittest.skipUnless(SOAK, "with --soak")
    def test_a_render_goes_on_after_a_process_was_killed(self):
        self.succeed("render", *self.options("one.pfm", "--passes", PASSES))
        resumed = 0
        for i in range(12):
            resumed += self.kill_one((2, 4, 7)[i % 3], self.random.uniform(0, 0.5))
        said = self.run_ranks(2, "all.pfm", "--passes", PASSES, "--state", self.path("a.state"))
        resumed += "resuming with" in said
        print(f"resumed {resumed} times", flush=True)
        self.same("one.pfm", "all.pfm")
        self.assertGreater(resumed, 0)

    @unittest.skipUnless(SOAK, "with --soak")
    def test_all_stop_together_at_a_signal(self):
        with self.start(2, "a.pfm", "--passes", 100000, "--state", self.path("a.state")) as mpirun:
            while not os.path.exists(self.path("a.state")) and mpirun.poll() is None:
                time.sleep(0.02)
            os.kill(children_of(mpirun.pid)[-1], signal.SIGTERM)  # a worker alone
            said = mpirun.communicate(timeout=120)[1]
        self.assertEqual(mpirun.returncode, 3, said)
        self.assertIn("stopped by a signal after", said)


def is_there():
    if not shutil.which("mpirun"):
        return False
    said = subprocess.run([os.path.join(Tools.folder, "render"), "a.glb", "a.hpm", "--mpi"],
                          stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True, check=False,
                          env=ENVIRONMENT).stderr
    return "without MPI" not in said


if __name__ == "__main__":
    Tools.folder = sys.argv[1]
    if not is_there():
        print("skipped: no Open MPI, or a render without it (apt-get install libopenmpi-dev)")
        sys.exit(77)
    tools.main(sys.argv)
