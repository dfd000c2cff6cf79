"""What --memory promises: the largest memory in use stays within the limit, by fewer light paths.

    memory_test.py FOLDER_OF_TOOLS SCENE
"""

import json
import sys

import tools
from tools import Tools, ToolsTestCase

GIB = 1 << 30
LIMIT = 0.2
# docs/memory.md states this margin.
MARGIN = 1.05
# Programs with checks of memory (--sanitize) take more than this for nothing.
PLAIN = 100 << 20


class Memory(ToolsTestCase):
    def setUp(self):
        super().setUp()
        self.write_partition()

    def options(self, *options):
        return [Tools.scene, self.path("scene.hpm"), "--size", 16, "--samples", 1, "--passes", 1, *options]

    def render(self, name, *options):
        said = self.succeed("render", *self.options("-o", self.path(name + ".pfm"), "--stats",
                                                    self.path(name + ".json"), *options))
        with open(self.path(name + ".json"), encoding="utf-8") as file:
            return said, json.load(file)

    def test_the_peak_keeps_to_the_limit_and_the_photons_are_said(self):
        _, small = self.render("small", "--photons", 1000, "--memory", LIMIT)
        self.assertEqual(small["options"]["photons"], 1000)
        said, stats = self.render("limited", "--photons", 3_000_000, "--memory", LIMIT)
        photons = stats["options"]["photons"]
        self.assertIn(f"--photons {photons} instead of 3000000, as --memory 0.2 allows", said)
        self.assertEqual(said.count("--memory"), 1)
        self.assertGreater(photons, 200_000)
        if small["error"]["memory"] < PLAIN:
            self.assertLess(stats["error"]["memory"], MARGIN * LIMIT * GIB)

    def test_an_image_depends_on_the_photons_that_are_left_and_not_on_the_limit(self):
        _, limited = self.render("limited", "--photons", 100_000, "--memory", 0.07, "--state",
                                 self.path("image.state"))
        photons = limited["options"]["photons"]
        self.assertLess(photons, 100_000)
        self.render("same", "--photons", photons)
        self.same("limited.pfm", "same.pfm")
        said, _ = self.render("resumed", "--photons", photons, "--memory", 1, "--state", self.path("image.state"))
        self.assertIn("resuming with 1 pass", said)

    def test_a_limit_that_the_rest_exceeds_is_an_error_that_says_how_much_it_needs(self):
        output = "-o", self.path("x.png")
        self.refuse("render", *self.options(*output, "--memory", 0.01), naming="scene and image alone need 0.0")
        self.refuse("render", *self.options(*output, "--memory", 0.055, "--photons", 100_000),
                    naming="as few as 10,000 light paths need 0.0")


if __name__ == "__main__":
    sys.exit(tools.main(sys.argv))
