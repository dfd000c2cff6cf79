"""Tasks of one image, each a tile and some passes: their states put together have the bits of one render.

    tasks_test.py FOLDER_OF_TOOLS SCENE
"""

import json
import os
import random
import signal
import subprocess
import sys
import time

import tools
from pictures import read_pfm
from tools import Tools, ToolsTestCase, run

PASSES = 6
SEED = 5


class Tasks(ToolsTestCase):
    def setUp(self):
        super().setUp()
        self.write_partition()
        self.random = random.Random(SEED)

    def options(self, *options, size="21x13", photons=1000):
        return [Tools.scene, self.path("scene.hpm"), "--size", size, "--photons", photons, *options]

    def render(self, *options):
        return self.succeed("render", *self.options(*options))

    def content(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def tasks(self, grid, folder, cuts=(0, 2, PASSES)):
        """The options of each task, in any order."""
        columns, rows = map(int, grid.split("x"))
        os.mkdir(self.path(folder))
        tasks = [["--tile", f"{tile}/{grid}", "--first-pass", first, "--passes", end - first,
                  "--state", self.path(f"{folder}/{tile}-{first}.state")]
                 for tile in range(columns * rows) for first, end in zip(cuts, cuts[1:])]
        self.random.shuffle(tasks)
        return tasks

    def merge(self, *states, options=()):
        return self.succeed("render", "merge", *map(self.path, states), "-o", self.path("merged.pfm"),
                            *options)

    def test_any_grid_in_any_order_has_the_bits_of_one_render(self):
        whole = "--passes", PASSES, "-o", self.path("whole.pfm"), "--state", self.path("whole.state")
        self.render(*whole)
        for grid, cuts in (("1x1", (0, 3, 4, PASSES)), ("2x2", (0, 2, PASSES)), ("5x3", (0, PASSES))):
            folder = "grid" + grid
            for task in self.tasks(grid, folder, cuts):
                self.render(*task)
            said = self.merge(folder, options=("--passes", PASSES))
            self.assertNotIn("missing", said)
            self.assertEqual(self.content("merged.pfm"), self.content("whole.pfm"), grid)
        self.look_into_a_tree_of_merges()

    def look_into_a_tree_of_merges(self):
        """Halves of the tiles of 5x3, without some, put together and then with passes of 2x2."""
        states = sorted(os.listdir(self.path("grid5x3")))
        states = [self.path("grid5x3/" + state) for state in self.random.sample(states, len(states))]
        lost = [state for state in states if state.endswith(("/3-0.state", "/4-0.state"))]
        for state in lost:
            states.remove(state)
        for name, part in (("a", states[:7]), ("b", states[7:])):
            self.merge(*part, options=("--state", self.path(name + ".state")))
        said = self.merge("a.state", "b.state", options=(
            "--fireflies", "keep",  # a missing tile changes which samples count as fireflies
            "--state", self.path("c.state"), "--stats", self.path("c.json"), "-o", self.path("c.exr"),
            "--error-image", self.path("c.png"), "--passes", PASSES + 1))
        self.assertRegex(said, rf"missing: passes {PASSES} of 21x4 pixels at 0,4;|"
                               rf"missing: passes 0-{PASSES} of 9x4 pixels at 12,0;")
        self.assertIn("of the 87 % of the pixels that hold two passes or more", said)
        with open(self.path("c.json"), encoding="utf-8") as file:
            missing = json.load(file)["missing"]
        self.assertIn({"pixels": [12, 0, 21, 4], "passes": [[0, PASSES + 1]]}, missing)
        self.succeed("render", "merge", self.path("whole.state"), "-o", self.path("kept.pfm"),
                     "--fireflies", "keep")
        whole, part = (read_pfm(self.path(name)).rows for name in ("kept.pfm", "merged.pfm"))
        for y, row in enumerate(part):
            for x, pixel in enumerate(row):
                self.assertEqual(pixel, (0, 0, 0) if x >= 12 and y < 4 else whole[y][x])
        described = run("render", "describe", self.path("c.state"), self.path("whole.state"))
        self.assertRegex(described.stdout, r"c.state: cornell.glb: 21x13, passes 0-5, different ones in "
                                           r"2 parts of the image, error .*\n.*whole.state: cornell.glb: ")
        image = "-o", self.path("refused.pfm")
        self.refuse("render", "merge", self.path("c.state"), self.path("grid2x2/1-2.state"), *image,
                    naming="pass 2 of pixel 10,0 is in")
        self.refuse("render", *self.options("--passes", PASSES, "--state", self.path("c.state"), *image),
                    naming="different passes of different tiles")
        self.refuse("render", *self.options("--state", self.path("grid2x2/1-2.state"), *image),
                    naming="another tile")
        self.merge("c.state", *lost)
        self.assertEqual(self.content("merged.pfm"), self.content("whole.pfm"))

    def test_a_task_that_is_killed_or_whose_state_is_damaged_costs_error_alone(self):
        self.render("--passes", PASSES, "-o", self.path("whole.pfm"))
        tasks = self.tasks("2x2", "states")
        for task in tasks[1:]:
            self.render(*task)
        with subprocess.Popen(
                [os.path.join(Tools.folder, "render"), *map(str, self.options(*tasks[0]))],
                stderr=subprocess.PIPE) as killed:
            time.sleep(self.random.uniform(0, 0.02))
            killed.send_signal(signal.SIGKILL)
            killed.communicate(timeout=60)
        damaged = tasks[1][-1]
        good = self.content(damaged)
        with open(damaged, "wb") as file:
            file.write(good[:-9] + b"x" + good[-8:])
        said = self.merge("states", options=("--passes", PASSES))
        self.assertIn("damaged", said)
        self.assertIn("left out", said)
        self.assertEqual(said.count("warning: missing: "), 2, said)
        self.refuse("render", "merge", damaged, "-o", self.path("b.pfm"), naming="damaged")
        with open(damaged, "wb") as file:
            file.write(good)
        self.render(*tasks[0])
        self.merge("states")
        self.assertEqual(self.content("merged.pfm"), self.content("whole.pfm"))

    def test_tiles_of_a_crop_fill_the_crop(self):
        crop = "--crop", "3,2,18,11", "--passes", 2
        self.render(*crop, "-o", self.path("whole.pfm"))
        for tile in range(3):
            self.render(*crop, "--tile", f"{tile}/3x1", "--state", self.path(f"{tile}.state"))
        self.merge("2.state", "0.state", "1.state")
        self.assertEqual(self.content("merged.pfm"), self.content("whole.pfm"))

    def test_what_is_no_tile_is_refused(self):
        image = "-o", self.path("a.pfm")
        for tile in ("4/2x2", "-1/2x2", "1", "1/2", "0/0x1", "0/x", "0/65x64", "a/2x2", "0/2x2x2"):
            self.refuse("render", *self.options("--tile=" + tile, *image), naming="NUMBER/COLUMNSxROWS")
        self.refuse("render", *self.options("--tile", "0/22x1", *image), naming="give fewer")
        os.mkdir(self.path("empty"))
        self.refuse("render", "merge", self.path("empty"), *image, naming="has no file FILE.state")


if __name__ == "__main__":
    tools.main(sys.argv)
