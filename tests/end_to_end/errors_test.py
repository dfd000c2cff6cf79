"""Bad input and usage, as a user meets them: exit code 2, one line, and no file left behind.

    errors_test.py FOLDER_OF_TOOLS SCENE
"""

import json
import os
import signal
import struct
import subprocess
import sys
import time

import tools
from pictures import read_pfm
from tools import Tools, ToolsTestCase


class Errors(ToolsTestCase):
    def partition(self):
        return self.write_partition()

    def write(self, name, data):
        with open(self.path(name), "wb") as file:
            file.write(data)
        return self.path(name)

    def read(self, path):
        with open(path, "rb") as file:
            return file.read()

    def test_missing_scene(self):
        missing = self.path("missing.glb")
        self.refuse("preprocess", missing, "-o", self.path("a.hpm"), naming="missing.glb")
        self.refuse("render", missing, self.path("a.hpm"), "-o", self.path("a.png"),
                    naming="missing.glb")

    def test_truncated_scene(self):
        whole = self.read(Tools.scene)
        for length in (0, 3, 11, 12, 19, 100, len(whole) // 8, len(whole) // 2, len(whole) - 1):
            with self.subTest(length=length):
                scene = self.write("short.glb", whole[:length])
                self.refuse("preprocess", scene, "-o", self.path("a.hpm"), "--images", self.folder,
                            "--json", self.path("a.json"), naming="short.glb")

    def test_not_a_scene(self):
        self.refuse("preprocess", self.write("a.glb", os.urandom(1000)), "-o", self.path("a.hpm"),
                    naming="a.glb")
        self.refuse("preprocess", self.write("a.blend", b"BLENDER"), "-o", self.path("a.hpm"),
                    naming="a.blend")

    def test_sky(self):
        def refuse(environment, naming):
            self.refuse("render", Tools.scene, partition, "-o", self.path("a.png"), "--environment",
                        environment, naming=naming)

        partition = self.partition()
        refuse("-1", "not a radiance from 0")
        refuse(self.path("sky.hdr"), "sky.hdr")
        refuse(self.write("sky.exr", b"no image"), "sky.exr")
        refuse(self.write("dark.pfm", b"Pf\n2 1\n-1\n" + struct.pack("<2f", 1, -1)), "(1, 0)")

    def test_partition_of_another_scene(self):
        self.partition()
        data = self.read(Tools.scene)
        moved = data.replace(b"0.2199999988079071", b"0.2299999988079071")
        self.assertNotEqual(moved, data)
        scene = self.write("moved.glb", moved)
        self.refuse("render", scene, self.path("scene.hpm"), "-o", self.path("a.png"),
                    naming="preprocess")

    def test_damaged_partition(self):
        whole = self.read(self.partition())
        damaged = [whole[:length] for length in (0, 1, 7, 100, len(whole) // 2, len(whole) - 1)]
        damaged += [os.urandom(len(whole)), self.read(Tools.scene)]
        for data in damaged:
            with self.subTest(length=len(data)):
                partition = self.write("bad.hpm", data)
                self.refuse("render", Tools.scene, partition, "-o", self.path("a.png"),
                            naming="bad.hpm")
        self.refuse("render", Tools.scene, self.path("none.hpm"), "-o", self.path("a.png"),
                    naming="none.hpm")

    def test_unwritable_output(self):
        partition = self.partition()
        self.refuse("preprocess", Tools.scene, "-o", self.path("none/a.hpm"), naming="none/a.hpm")
        self.refuse("render", Tools.scene, partition, "-o", self.path("none/a.png"),
                    naming="none/a.png")
        self.refuse("render", Tools.scene, partition, "-o", self.path("a.jpg"), naming=".exr")
        self.refuse("render", Tools.scene, partition, "-o", self.path("a.png"), "-o",
                    self.path("b.tif"), naming="b.tif")
        self.refuse("render", Tools.scene, partition, "-o", self.path("a.png"), "--error-image",
                    self.path("a.exr"), naming="a.exr")
        self.refuse("render", Tools.scene, partition, "-o", self.path("a.png"), "--error-image",
                    self.path("none/e.png"), naming="none/e.png")
        self.refuse("render", Tools.scene, partition, "-o", self.path("a.png"), "--stats",
                    self.path("none/a.json"), naming="none/a.json")

    def test_bad_options(self):
        render = ["render", Tools.scene, self.path("a.hpm"), "-o", self.path("a.png")]
        for option, value in (("--photons", "-5"), ("--photons", "many"), ("--maps", "sharde"),
                              ("--neighbours", "nan"), ("--size", "0x10"), ("--size", "tall"),
                              ("--exposure", "inf"), ("--samples", "0"), ("--direct", "none"),
                              ("--alpha", "1"), ("--alpha", "0")):
            with self.subTest(option=option, value=value):
                self.refuse(*render, option, value, naming=option)
        self.refuse(*render, "--irradiance", "precomputed", "--integrator", "path",
                    naming="--irradiance")
        self.refuse(*render, "--alpha", "0.5", "--integrator", "path", naming="--alpha")
        self.refuse(*render, "--no-such-option", naming="--no-such-option")
        self.refuse("render", Tools.scene, naming="")
        self.refuse("preprocess", Tools.scene, "-o", self.path("a.hpm"), "--angle", "-1",
                    naming="--angle")
        self.refuse("preprocess", Tools.scene, "-o", self.path("a.hpm"), "--camera", "Nobody",
                    naming="Nobody")
        self.refuse("preprocess", Tools.scene, "-o", self.path("a.hpm"), "--exclude", "Nobody",
                    naming="Nobody")

    def test_an_option_without_effect_is_told(self):
        said = self.succeed("render", Tools.scene, self.partition(), "-o", self.path("a.pfm"), "--size", "16",
                            "--passes", "1", "--photons", "2000", "--effects", "-indirect",
                            "--indirect-by", "paths")
        self.assertIn("--indirect-by paths has no effect", said)

    @staticmethod
    def progress_told(render):
        """What it says until it tells its progress, of which it waits for 5 s, here without computing."""
        render.send_signal(signal.SIGSTOP)
        time.sleep(5)
        render.send_signal(signal.SIGCONT)
        said = ""
        while " %" not in said and render.poll() is None:
            said = render.stderr.readline()
        return said

    def test_a_stopped_render_writes_the_image_so_far(self):
        command = [os.path.join(Tools.folder, "render"), Tools.scene, self.partition(), "-o",
                   self.path("a.pfm"), "--size", "16x16", "--photons", "2000", "--passes",
                   "1000000", "--progress", "json"]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as render:
            for line in render.stdout:
                if json.loads(line)["event"] == "pass":
                    break
            said = self.progress_told(render)
            render.send_signal(signal.SIGTERM)
            said += render.communicate(timeout=120)[1]
        self.assertEqual(render.returncode, 3, said)
        image = read_pfm(self.path("a.pfm"))
        self.assertGreater(min(image.mean()), 0)
        self.assertEqual(sorted(os.listdir(self.folder)), ["a.pfm", "scene.hpm"])


if __name__ == "__main__":
    tools.main(sys.argv)
