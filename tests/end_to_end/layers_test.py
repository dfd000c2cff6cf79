"""render --layers: what is in the file, and that nothing else changes.

    layers_test.py FOLDER_OF_TOOLS SCENE ROOT
"""

import os
import re
import sys

import tools
from exr_file import ExrFile
from pictures import read_pfm
from tools import Tools, ToolsTestCase, run

ROOT = sys.argv[3]
SIZE = 16


class Layers(ToolsTestCase):
    def setUp(self):
        super().setUp()
        self.write_partition()

    def command(self, *options, passes=2):
        return [Tools.scene, self.path("scene.hpm"), "--size", f"{SIZE}x{SIZE}", "--photons", 3000,
                "--passes", passes, *options]

    def layers(self, name, *options, passes=2):
        """Renders; returns the channels, and what was printed."""
        path = self.path(name)
        said = self.succeed("render", *self.command("--layers", path, *options, passes=passes))
        return ExrFile(path).channels, said

    def content(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def test_the_image_is_combined_and_does_not_depend_on_layers(self):
        channels, said = self.layers("a.exr", "-o", self.path("a.pfm"), "-o", self.path("b.exr"),
                                     "--threads", 2)
        self.assertRegex(said, r"a.exr \(\d+ layers\)")
        self.succeed("render", *self.command("-o", self.path("c.pfm")))
        self.assertEqual(self.content("a.pfm"), self.content("c.pfm"))
        image = ExrFile(self.path("b.exr")).channels
        for letter, values in zip("RGB", zip(*read_pfm(self.path("a.pfm")).pixels())):
            self.assertEqual(tuple(channels["ViewLayer.Combined." + letter]), values)
            for name in ("Noise", "Error"):
                self.assertEqual(channels[f"ViewLayer.{name}.{letter}"],
                                 image[f"{name.lower()}.{letter}"])
        self.assertEqual(set(channels["ViewLayer.Combined.A"]), {1.0})
        self.layers("one.exr", "--threads", 1)
        self.assertEqual(self.content("one.exr"), self.content("a.exr"))

    def test_the_file_of_the_scene_numbers_what_is_seen(self):
        channels, _ = self.layers("a.exr", passes=1)
        self.assertEqual(set(channels["ViewLayer.IndexOB.X"]) - {1, 2, 3, 4, 5}, set())
        self.assertGreater(len(set(channels["ViewLayer.IndexMA.X"])), 3)
        depth, height = channels["ViewLayer.Depth.Z"], channels["ViewLayer.Position.Z"]
        self.assertTrue(all(1 < one < 5 for one in depth))
        self.assertTrue(all(-1e-5 < one < 2 + 1e-5 for one in height))  # the room is 2 m high

    def test_only_the_layers_asked_for_are_written(self):
        channels, _ = self.layers("a.exr", "--layer-names", "normal,depth", "--view-layer",
                                  "Room.1", passes=1)
        self.assertEqual(list(channels), ["Room.1.Depth.Z", *("Room.1.Normal." + one
                                                               for one in "XYZ")])

    def test_one_pass_knows_no_error(self):
        channels, said = self.layers("a.exr", passes=1)
        self.assertIn("a.exr: written without noise, error", said)
        self.assertNotIn("ViewLayer.Noise.R", channels)

    def test_wrong_options_are_refused(self):
        wrong = {("--layers", "a.png"): "layers must be .exr",
                 ("--layers", "a.exr", "--layer-names", "z"): "'z' is no layer",
                 ("--layer-names", "depth"): "--layers"}
        for options, naming in wrong.items():
            self.refuse("render", *self.command(*options), naming=naming)

    def test_the_page_tells_of_every_layer(self):
        table = run("render", "--options-table").stdout
        names = re.search(r"Layers that --layers writes: ([\w, -]+) \|", table)[1].split(", ")
        with open(os.path.join(ROOT, "docs/layers.md"), encoding="utf-8") as file:
            rows = re.findall(r"^\| `([\w-]+)` \|", file.read(), re.MULTILINE)
        self.assertEqual(rows, names)


if __name__ == "__main__":
    tools.main(sys.argv)
