"""Frames of an animation: each is what it is when it is asked for alone.

    frames_test.py FOLDER_OF_TOOLS SCENE
"""

import sys

import tools
from tools import Tools, ToolsTestCase

SMALL = ("--size", "16", "--photons", "2000", "--passes", "2")


class Frames(ToolsTestCase):
    def content(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def preprocess(self, *options, output="scene.hpm"):
        return self.succeed("preprocess", Tools.scene, "-o", self.path(output), *options)

    def render(self, image, *options):
        return self.succeed("render", Tools.scene, self.path("scene.hpm"), "-o", self.path(image),
                            *SMALL, *options)

    def test_a_frame_alone_is_the_frame_of_the_row(self):
        said = self.preprocess("--frames", "6:8")
        self.assertIn("this is at 0.25 s", said)
        self.assertIn("this is at 0.333 s", said)
        self.render("row.pfm", "--frames", "6:8")
        for frame in (6, 7, 8):
            row = self.content(f"scene.{frame:04}.hpm"), self.content(f"row.{frame:04}.pfm")
            self.preprocess("--frames", frame, output="one.hpm")
            self.render("one.pfm", "--frames", frame)
            one = self.content(f"one.{frame:04}.hpm"), self.content(f"one.{frame:04}.pfm")
            self.assertEqual(row[0], one[0], frame)
            self.assertEqual(row[1], one[1], frame)
        self.assertNotEqual(self.content("row.0006.pfm"), self.content("row.0008.pfm"))

    def test_fps_says_when_a_frame_is(self):
        self.preprocess("--frames", "6")
        self.preprocess("--frames", "3", "--fps", "12", output="slow.hpm")
        self.assertEqual(self.content("scene.0006.hpm"), self.content("slow.0003.hpm"))

    def test_what_makes_no_sense_is_refused(self):
        self.preprocess("--frames", "2:3")
        image = ("-o", self.path("refused.pfm"))
        partition = self.path("scene.hpm")
        for frames, naming in (("3:2", "ends before"), ("x", "no range"), ("1:2:3", "no range"),
                               ("-1:2", "--frames"), ("4", "scene.0004.hpm")):
            self.refuse("render", Tools.scene, partition, *image, "--frames", frames,
                        naming=naming)
        self.refuse("render", Tools.scene, partition, *image, "--fps", "25", naming="--frames")
        self.refuse("render", Tools.scene, partition, *image, "--frames", "2", "--fps", "25",
                    naming="scene.0002.hpm")


if __name__ == "__main__":
    tools.main(sys.argv)
