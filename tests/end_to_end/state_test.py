"""Renders that are stopped, killed, gone on with and merged: the same bits as if never stopped.

    state_test.py FOLDER_OF_TOOLS SCENE
"""

import json
import os
import random
import signal
import subprocess
import sys
import time

import tools
from tools import Tools, ToolsTestCase

PASSES = 90
PHOTONS = 1000
KILLS = 9
SEED = 7


class State(ToolsTestCase):
    size = "16x16"
    photons = PHOTONS

    def setUp(self):
        super().setUp()
        self.write_partition()

    def command(self, image, *options):
        return [os.path.join(Tools.folder, "render"), Tools.scene, self.path("scene.hpm"), "-o",
                self.path(image), "--size", self.size, "--photons", str(self.photons), *map(str, options)]

    def render(self, image, *options):
        return self.succeed("render", *self.command(image, *options)[1:])

    def refuse_render(self, *options, naming):
        self.refuse("render", *self.command("refused.pfm", *options)[1:], naming=naming)

    def read_json(self, name):
        with open(self.path(name), encoding="utf-8") as file:
            return json.load(file)

    def kill(self, command, seconds):
        """Whether the render had gone on with a state when it was killed, if it was in time."""
        with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as render:
            time.sleep(seconds)
            render.kill()
            return "resuming with" in render.communicate(timeout=120)[1]

    def test_killed_at_random_moments_and_gone_on_with(self):
        """The whole and two halves of it, killed in turn, by 1, 2 and 7 threads."""
        self.photons = 3000  # so that the halves take several times the 0.2 s from one saved state to the next
        began = time.monotonic()
        self.render("whole.pfm", "--passes", PASSES)
        seconds = time.monotonic() - began
        half = PASSES // 2
        print(f"not killed: {seconds:.3f} s", flush=True)
        parts = [["--passes", PASSES], ["--passes", half],
                 ["--passes", PASSES - half, "--first-pass", half]]
        for number, part in enumerate(parts):
            part += ["--state", self.path(f"{number}.state")]
        gone_on = 0
        chance = random.Random(SEED)
        for i in range(KILLS):
            number, threads = i % len(parts), (1, 2, 7)[i // len(parts) % 3]
            moment = chance.uniform(0.1, 1) * seconds / (2 if number else 1)
            print(f"part {number} by {threads} threads, killed after {moment:.3f} s", flush=True)
            gone_on += self.kill(self.command("killed.pfm", *parts[number], "--threads", threads),
                                 moment)
        for number, part in enumerate(parts):
            gone_on += "resuming with" in self.render(f"{number}.pfm", *part)
        self.assertGreaterEqual(gone_on, len(parts), "states were not kept in time")
        self.succeed("render", "merge", self.path("2.state"), self.path("1.state"), "-o",
                     self.path("merged.pfm"))
        self.same("whole.pfm", "0.pfm", "merged.pfm")

    def test_stopped_by_a_signal_and_gone_on_with(self):
        options = ["--passes", PASSES // 2, "--state", self.path("a.state")]
        with subprocess.Popen(self.command("a.pfm", *options), stderr=subprocess.PIPE,
                              text=True) as render:
            while not os.path.exists(self.path("a.state")) and render.poll() is None:
                time.sleep(0.01)
            render.send_signal(signal.SIGINT)
            said = render.communicate(timeout=120)[1]
        self.assertIn(render.returncode, (0, 3), said)  # it may have been done by then
        self.assertTrue(os.path.exists(self.path("a.pfm")))
        self.assertIn("resuming with", self.render("a.pfm", *options))
        self.render("b.pfm", "--passes", PASSES // 2)
        self.same("a.pfm", "b.pfm")

    def test_parts_by_any_number_of_threads_merge_into_the_bits_of_one(self):
        self.render("whole.pfm", "--passes", 12, "--threads", 2)
        for part, threads in enumerate((1, 2, 7)):
            self.render("part.pfm", "--passes", 4, "--first-pass", 4 * part, "--threads", threads,
                        "--state", self.path(f"{part}.state"))
        states = [self.path(f"{part}.state") for part in (2, 0, 1)]
        said = self.succeed("render", "merge", *states, "-o", self.path("merged.pfm"), "--state",
                            self.path("merged.state"), "--stats", self.path("merged.json"))
        self.assertIn("accuracy: error ", said)
        self.assertRegex(said, "cost: .* % in 12 passes, .*; .* would take about [0-9]+ passes, ")
        self.look_into_merged_statistics(self.read_json("merged.json"))
        self.render("again.pfm", "--passes", 12, "--state", self.path("merged.state"))
        self.same("whole.pfm", "merged.pfm", "again.pfm")

        image = ("-o", self.path("refused.pfm"))
        self.refuse("render", "merge", states[0], self.path("merged.state"), *image,
                    naming="pass 8")
        self.refuse("render", "merge", states[0], Tools.scene, *image, naming="cornell.glb")
        self.refuse("render", "merge", states[0], "-o", self.path("a.tif"), naming="a.tif")
        self.refuse("render", "merge", *image, naming="STATE")
        self.refuse_render("--state", states[0], "--seed", 1, naming="seed=0")
        self.refuse_render("--state", states[0], "--exclude", "Block", naming="")
        for option in (("--environment", "1"), ("--energy-compensation",), ("--look", "gltf")):
            self.refuse_render("--state", states[0], *option, naming="scene=")
        self.refuse_render("--state", states[0], "--effects", "-caustics", naming="caustics=")

    def look_into_merged_statistics(self, stats):
        self.assertEqual(stats["command"][:2], ["render", "merge"])
        self.assertEqual(stats["passes_done"], 12)
        self.assertEqual(stats["settings"]["photons"], PHOTONS)
        self.assertEqual((stats["image"]["width"], len(stats["states"])), (16, 3))
        checks = stats["error"]["checks"]
        self.assertEqual([check["passes"] for check in checks], [2, 3, 4, 12])
        self.assertGreater(stats["seconds"]["passes"], checks[2]["seconds"])
        price = stats["error"]["prices"][-1]
        self.assertEqual(price["photons"], PHOTONS * price["passes"])

    def test_it_ends_at_an_error_and_after_a_time_and_says_the_price(self):
        said = self.render("a.pfm", "--integrator", "path", "--error", "20%", "--stats",
                           self.path("a.json"))
        self.assertRegex(said, "; 10 % would take about [0-9]+ to [0-9]+ passes, ")
        stats = self.read_json("a.json")
        self.assertEqual(stats["ended_by"], "error")
        checks = stats["error"]["checks"]
        self.assertLessEqual(checks[-1]["error"], 0.2)
        self.assertEqual([check["passes"] for check in checks[:4]], [2, 3, 4, 6])
        self.assertTrue(all(check["high"] is None for check in checks[:2]))
        self.assertTrue(all(check["error"] > 0.2 for check in checks[2:-1]))
        self.assertTrue(all(check["low"] <= check["error"] <= check["high"]
                            for check in checks[2:]))
        self.assertEqual(stats["passes_done"], checks[-1]["passes"])
        prices = stats["error"]["prices"]
        self.assertEqual(sorted((price["passes"] for price in prices)),
                         [price["passes"] for price in prices])
        self.render("a.pfm", "--time", "0.2", "--stats", self.path("a.json"))
        stats = self.read_json("a.json")
        self.assertEqual(stats["ended_by"], "time")
        self.assertGreater(stats["passes_done"], 0)

    def test_a_state_is_written_for_passes_and_for_nothing_else(self):
        options = ["--passes", 8, "--state", self.path("a.state")]
        large = [word.replace("16x16", "512x512") for word in self.command("a.pfm", *options)]
        with subprocess.Popen(large + ["--samples", "256"], stderr=subprocess.PIPE,
                              text=True) as render:
            render.stderr.readline()  # it has begun
            time.sleep(0.2)
            render.send_signal(signal.SIGTERM)
            said = render.communicate(timeout=120)[1]
        self.assertEqual(render.returncode, 3, said)
        self.assertFalse(os.path.exists(self.path("a.state")), "no pass was finished")
        self.render("a.pfm", *options)
        before = os.stat(self.path("a.state"))
        self.render("a.pfm", *options)
        after = os.stat(self.path("a.state"))
        self.assertEqual((before.st_ino, before.st_mtime_ns), (after.st_ino, after.st_mtime_ns))
        raw = (8 + 4 + 4) * 8 * 3 * 16 * 16  # bytes of the sums
        self.assertLess(after.st_size, 0.45 * raw)

    def test_a_state_of_other_options_is_put_aside_where_that_is_asked_for(self):
        options = ["--passes", 2, "--state", self.path("a.state")]
        self.render("a.pfm", *options)
        with open(self.path("a.state"), "rb") as file:
            old = file.read()
        self.refuse_render(*options, "--seed", 1, naming="seed=0")
        said = self.render("b.pfm", *options, "--seed", 1, "--replace-state")
        self.assertRegex(said, "holds passes with seed=0, not seed=1; starting over, .*a.state.old")
        with open(self.path("a.state.old"), "rb") as file:
            self.assertEqual(file.read(), old)
        self.assertIn("resuming with 2 passes",
                      self.render("b.pfm", *options, "--seed", 1, "--replace-state"))
        changed = bytearray(old)
        changed[8] = 4  # the format of an older version
        with open(self.path("a.state"), "wb") as file:
            file.write(changed)
        self.refuse_render(*options, naming="format 4")
        self.assertIn("starting over", self.render("a.pfm", *options, "--replace-state"))
        changed = bytearray(old)
        changed[len(old) // 2] ^= 1
        with open(self.path("a.state"), "wb") as file:
            file.write(changed)
        self.refuse_render(*options, "--replace-state", naming="damaged state file (checksum")
        self.refuse_render("--replace-state", naming="--state")

    def test_a_quote_writes_its_state_alone(self):
        before = sorted(os.listdir(self.folder))
        said = self.succeed("render", Tools.scene, self.path("scene.hpm"), "--size", "16x16",
                            "--photons", PHOTONS, "--quote", "--error", "3")
        self.assertIn("3.0 % error would take about ", said)
        self.assertIn("memory", said)
        self.assertEqual(sorted(os.listdir(self.folder)), before)
        for passes in ("8 passes", "8 passes"):  # the second one has them in its state
            said = self.succeed("render", Tools.scene, self.path("scene.hpm"), "--size", "16x16",
                                "--photons", PHOTONS, "--quote", "--state", self.path("q.state"))
            self.assertIn(f"in {passes}", said)
            self.assertIn("1.0 % error would take about ", said)
        for option, value in (("--error", "0"), ("--error", "5%%"), ("--error", "nan"),
                              ("--time", "-1"), ("--passes", "0"), ("--first-pass", "-1")):
            with self.subTest(option=option, value=value):
                self.refuse_render(option, value, naming=option)
        self.refuse("render", Tools.scene, self.path("scene.hpm"), naming="--output")


    def test_fireflies_are_removed_from_images_and_not_from_states(self):
        """Paths find the light behind the glass ball by rare bright samples."""
        self.size = "40x40"
        options = ["--integrator", "path", "--passes", 8, "--stats", self.path("stats.json")]
        self.render("kept.pfm", *options, "--state", self.path("a.state"), "--fireflies", "keep")
        with open(self.path("a.state"), "rb") as file:
            state = file.read()
        kept = self.read_json("stats.json")["error"]
        self.assertIsNone(kept["removed_fireflies"])
        printed = self.render("removed.pfm", *options, "--state", self.path("a.state"))
        self.assertIn("fireflies: removed from", printed)
        with open(self.path("a.state"), "rb") as file:
            self.assertEqual(file.read(), state)
        error = self.read_json("stats.json")["error"]
        self.assertLess(error["checks"][-1]["noise"], kept["checks"][-1]["noise"])
        removed = error["removed_fireflies"]
        self.assertEqual(error["checks"][-1]["removed"], removed["error"])
        self.assertGreater(removed["pixels"], 0)
        self.assertTrue(0 < removed["light"] < 0.2, removed)
        self.succeed("render", "merge", self.path("a.state"), "-o", self.path("merged.pfm"),
                     "--state", self.path("b.state"))
        self.succeed("render", "merge", self.path("b.state"), "-o", self.path("again.pfm"),
                     "--fireflies", "keep")
        self.same("merged.pfm", "removed.pfm")
        self.same("again.pfm", "kept.pfm")
        with self.assertRaises(AssertionError):
            self.same("kept.pfm", "removed.pfm")

    def test_much_light_of_fireflies_is_told(self):
        """Stars far smaller than a pixel, over a floor under them: few are hit, once."""
        corners, faces = [(-2, -1.2, -3), (2, -1.2, -3), (2, -1.2, 1), (-2, -1.2, 1)], []
        for i in range(400):
            x, y = i % 20 / 10 - 0.95, i // 20 / 10 - 0.95
            corners += [(x + 3e-4 * dx, y + 3e-4 * dy, -2)
                        for dx, dy in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
            faces.append("f %d %d %d %d\n" % tuple(range(4 * i + 5, 4 * i + 9)))
        with open(self.path("stars.mtl"), "w", encoding="utf-8") as file:
            file.write("newmtl floor\nKd 0.5 0.5 0.5\nnewmtl star\nKd 0 0 0\nKe 999 999 999\n")
        with open(self.path("stars.obj"), "w", encoding="utf-8") as file:
            file.write("mtllib stars.mtl\n" + "".join("v %g %g %g\n" % at for at in corners) +
                       "usemtl floor\nf 1 4 3 2\nusemtl star\n" + "".join(faces))
        self.succeed("preprocess", self.path("stars.obj"), "-o", self.path("stars.hpm"))
        said = self.succeed("render", self.path("stars.obj"), self.path("stars.hpm"), "-o",
                            self.path("stars.pfm"), "--size", "100x100", "--passes", "4")
        self.assertIn("of the light; --fireflies keep leaves them in", said)


if __name__ == "__main__":
    tools.main(sys.argv)
