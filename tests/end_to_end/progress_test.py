"""render --progress json: lines that a program follows, and images that are whole at any time.

    progress_test.py FOLDER_OF_TOOLS SCENE
"""

import json
import os
import signal
import subprocess
import sys
import time

import tools
from exr_file import ExrFile
from pictures import read_pfm, read_png
from tools import Tools, ToolsTestCase


class Progress(ToolsTestCase):
    def setUp(self):
        super().setUp()
        self.write_partition()

    def command(self, *options, size="16x16"):
        return [os.path.join(Tools.folder, "render"), Tools.scene, self.path("scene.hpm"),
                "--size", size, "--photons", "3000", *map(str, options)]

    def lines(self, *options):
        done = subprocess.run(self.command("--progress", "json", *options), text=True, check=True,
                              stdin=subprocess.DEVNULL, capture_output=True)
        return [json.loads(line) for line in done.stdout.splitlines()]

    def content(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def test_every_pass_and_the_end_have_a_line(self):
        lines = self.lines("-o", self.path("a.pfm"), "-o", self.path("a.png"), "--passes", 3)
        passes = [line for line in lines if line["event"] == "pass"]
        self.assertEqual([line["passes"] for line in passes], [1, 2, 3])
        self.assertIsNone(passes[0]["error"])
        self.assertGreater(passes[1]["error"], 0)
        self.assertEqual(passes[0]["images"], [self.path("a.pfm"), self.path("a.png")])
        self.assertEqual(lines[-1]["event"], "end")
        self.assertEqual(lines[-1]["reason"], "passes")
        self.assertEqual(lines[-1]["images"], [self.path("a.pfm"), self.path("a.png")])
        for line in lines:
            self.assertGreaterEqual(line["seconds"], 0)
            if line["event"] == "progress" and line["passes"] > 0:
                self.assertGreaterEqual(line["left"], 0)

    def test_lines_name_the_error_image_and_the_layers(self):
        files = [self.path(name) for name in ("a.pfm", "error.png", "layers.exr")]
        lines = self.lines("-o", files[0], "--error-image", files[1], "--layers", files[2],
                           "--layer-names", "depth", "--passes", 2)
        first = next(line for line in lines if line["event"] == "pass")
        self.assertEqual(first["images"], [files[0], files[2]])  # one pass knows no error
        self.assertEqual(lines[-1]["images"], files)

    def test_the_image_is_the_same_as_without(self):
        self.lines("-o", self.path("a.pfm"), "--passes", 2)
        self.succeed("render", *self.command("-o", self.path("b.pfm"), "--passes", 2)[1:])
        self.assertEqual(self.content("a.pfm"), self.content("b.pfm"))

    def test_text_prints_nothing_on_standard_output(self):
        done = subprocess.run(self.command("-o", self.path("a.pfm"), "--passes", 1), check=True,
                              capture_output=True)
        self.assertEqual(done.stdout, b"")

    def test_frames_are_numbered(self):
        self.succeed("preprocess", Tools.scene, "-o", self.path("scene.hpm"), "--frames", "1:2")
        lines = self.lines("-o", self.path("a.pfm"), "--passes", 1, "--frames", "1:2")
        ends = [line["frame"] for line in lines if line["event"] == "end"]
        self.assertEqual(ends, [1, 2])

    def test_a_signal_ends_with_the_passes_so_far(self):
        with subprocess.Popen(self.command("--progress", "json", "-o", self.path("a.pfm"),
                                           "--passes", 100000),
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as render:
            for line in render.stdout:
                if json.loads(line)["event"] == "pass":
                    break
            self.assertTrue(self.content("a.pfm").startswith(b"PF\n16 16\n"))
            render.send_signal(signal.SIGTERM)
            last = json.loads(render.stdout.read().splitlines()[-1])
        self.assertEqual(render.returncode, 3)
        self.assertEqual((last["event"], last["reason"]), ("end", "signal"))

    def test_a_slow_first_pass_has_a_coarse_image_before_it(self):
        image = self.path("a.pfm")
        with subprocess.Popen(self.command("--progress", "json", "-o", image, "--integrator", "path",
                                           "--samples", 1024, "--crop", "0,0,128,96", "--threads", 1,
                                           size="128x128"),
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as render:
            events = (json.loads(line) for line in render.stdout)
            coarse = next(event for event in events if event["event"] != "progress")
            self.assertEqual((coarse["event"], coarse["passes"]), ("coarse", 0))
            self.assertEqual(coarse["images"], [image])
            self.assert_whole(image)
            next(event for event in events if event["event"] == "progress")
            render.send_signal(signal.SIGTERM)
            last = list(events)[-1]
        self.assertEqual((last["reason"], last["passes"]), ("signal", 0))
        self.assert_whole(image)

    def assert_whole(self, image):
        pixels = read_pfm(image).pixels()
        self.assertEqual(len(pixels), 128 * 96)
        black = sum(1 for pixel in pixels if not sum(pixel) > 0)
        self.assertLess(black, len(pixels) // 100)  # the view past the box

    def test_a_killed_render_leaves_whole_pictures(self):
        image, exr, errors, layers = map(self.path, ("a.png", "a.exr", "error.png", "layers.exr"))
        with subprocess.Popen(self.command("-o", image, "-o", exr, "--error-image", errors,
                                           "--layers", layers, "--passes", 100000),
                              stderr=subprocess.DEVNULL) as render:
            # The error image is there from the second pass on, the others from the first on.
            while not self.has_noise(layers) and render.poll() is None:
                time.sleep(0.01)
            render.kill()
        self.assertEqual(render.returncode, -signal.SIGKILL)
        for png in (image, errors):
            self.assertGreater(sum(read_png(png).mean()), 0)
        self.assertEqual(ExrFile(exr).width, 16)
        self.assertEqual(len(ExrFile(layers).channels["ViewLayer.Depth.Z"]), 256)

    def has_noise(self, layers):
        return os.path.exists(layers) and "ViewLayer.Noise.R" in ExrFile(layers).channels

    def test_a_reader_that_goes_away_ends_the_render(self):
        with subprocess.Popen(self.command("--progress", "json", "-o", self.path("a.pfm"),
                                           "--time", 100),
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as render:
            render.stdout.readline()
            render.stdout.close()
            began = time.monotonic()
            self.assertNotEqual(render.wait(timeout=60), 0)
            self.assertLess(time.monotonic() - began, 30)


if __name__ == "__main__":
    tools.main(sys.argv)
