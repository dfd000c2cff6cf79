"""The whole pipeline on the bundled scene, at a small size, with its output looked into.

    pipeline_test.py FOLDER_OF_TOOLS SCENE
"""

import json
import math
import os
import sys

import tools
from pictures import read_pfm, read_png
from tools import Tools, ToolsTestCase, run

SIZE = 64
PHOTONS = 8000
LAMP_RADIANCE = (16.0, 13.76, 10.88)
LAMP_AREA = 0.56 * 0.44
FACES = 7960
SHARED_MAPS = 5 + 6 + 2 + 1  # sides of room and block, spheres, lamp
EDGES = {"connected": 2 * 3968 * 3 // 2 + 5 + 6 + 1,  # spheres; diagonals of the sides and the lamp
         "unconnected": 8 + 12, "border": 4 + 4, "non_manifold": 0, "degenerate": 0}
CANDIDATES = 2 * (5 + 5)  # sides of the room and the block, all but its bottom
AREA = 5 * 4 + 2.5 + LAMP_AREA + 4 * math.pi * (0.4 ** 2 + 0.32 ** 2)
PICTURES = ("shared_maps.png", "edges.png", "candidates.png", "groups.png")


class Pipeline(ToolsTestCase):
    def make_partition(self):
        return self.write_partition("cornell.hpm")

    def read_json(self, name):
        with open(self.path(name), encoding="utf-8") as file:
            return json.load(file)

    def render(self, partition, *options, name="image.pfm", size=SIZE, photons=PHOTONS):
        """By the maps as they are, which is fast."""
        self.succeed("render", Tools.scene, partition, "-o", self.path(name), "--size",
                     f"{size}x{size}", "--photons", photons, "--passes", 4, "--integrator",
                     "direct", *options)
        return read_pfm(self.path(name))

    def test_a_black_image_says_so_and_what_it_shows(self):
        dark = ("--exclude", "Lamp", "--environment", 0)
        self.succeed("preprocess", Tools.scene, "-o", self.path("dark.hpm"), *dark[:2])
        said = self.succeed("render", Tools.scene, self.path("dark.hpm"), *dark, "-o",
                            self.path("dark.pfm"), "--size", 16, "--passes", 2)
        self.assertRegex(said, r"accuracy: the image is black, .* looks at 'Room', ")

    def candidates(self, *options):
        self.succeed("preprocess", Tools.scene, "-o", self.path("cornell.hpm"), "--json",
                     self.path("partition.json"), *options)
        return self.read_json("partition.json")

    def test_candidates_are_those_of_the_pass_that_is_expected(self):
        few, none = self.candidates("--photons", 20000), self.candidates("--photons", 0)
        self.assertIn(few["candidates"], range(2, CANDIDATES - 2))
        self.assertEqual(few["expected"]["light_paths"], 20000)
        self.assertEqual(none["candidates"], 0)
        fewer_each = self.candidates("--photons", 20000, "--neighbours", 10)
        self.assertEqual(fewer_each["expected"]["photons_at_least"], 100)
        self.assertGreater(fewer_each["candidates"], few["candidates"])

    def test_without_light_candidates_are_those_by_shape(self):
        dark = self.candidates("--exclude", "Lamp", "--environment", 0)
        self.assertFalse(dark["expected"]["is_known"])
        self.assertEqual(dark["candidates"], FACES - 2)

    def test_as_pipeline_sh_calls_it(self):
        name = self.path("cornell")
        said = self.succeed("preprocess", Tools.scene, "-o", name + ".hpm", "--images",
                            self.folder, "--candidates", "--size", 2 * SIZE, "--json",
                            self.path("partition.json"), "--verbose")
        self.assertRegex(said, rf"candidates: {CANDIDATES} of {FACES:,} faces for local maps; each is "
                               "expected to hold about 500 photons or more in a pass of 1,048,576 light paths\n")
        self.succeed("render", Tools.scene, name + ".hpm", "-o", name + ".png", "-o",
                     name + ".exr", "-o", name + ".pfm", "--size", f"{SIZE}x{SIZE}", "--photons",
                     PHOTONS, "--passes", 4, "--error-image", self.path("error.png"), "--bias-image",
                     self.path("bias.png"), "--stats", self.path("stats.json"))
        expected = ["bias.png", "cornell.exr", "cornell.hpm", "cornell.pfm", "cornell.png", "error.png",
                    "partition.json", "stats.json", *PICTURES]
        self.assertEqual(sorted(os.listdir(self.folder)), sorted(expected))
        self.look_into_image(read_pfm(name + ".pfm"))
        self.look_into_display(read_png(name + ".png"))
        self.look_into_exr()
        self.look_into_error_pictures(self.read_json("stats.json")["pictures"])
        self.look_into_partition_pictures()
        self.look_into_partition(self.read_json("partition.json"))
        self.look_into_statistics(self.read_json("stats.json"))

    def look_into_image(self, image):
        self.assertEqual((image.width, image.height), (SIZE, SIZE))
        for pixel in image.pixels():
            self.assertTrue(all(math.isfinite(c) and c >= 0 for c in pixel), pixel)
        for seen, emitted in zip(image.rows[8][SIZE // 2], LAMP_RADIANCE):
            self.assertLess(seen, 1.001 * emitted)
            self.assertGreater(seen, 0.95 * emitted)  # the filter reaches a little beyond the lamp
        middle = slice(SIZE // 2 - 6, SIZE // 2)
        red = image.mean(2, middle.start, 8, middle.stop)
        green = image.mean(SIZE - 8, middle.start, SIZE - 2, middle.stop)
        self.assertGreater(red[0], 3 * red[1])
        self.assertGreater(green[1], 2 * green[0])
        floor_left = image.mean(6, SIZE - 3, 12, SIZE - 1)
        floor_right = image.mean(SIZE - 12, SIZE - 3, SIZE - 6, SIZE - 1)
        self.assertGreater(floor_left[0] / floor_left[1],
                           1.1 * floor_right[0] / floor_right[1], "no colour bleeding")

    def look_into_display(self, shown):
        self.assertEqual((shown.width, shown.height), (SIZE, SIZE))
        pixels = shown.pixels()
        self.assertGreater(len(set(pixels)), SIZE * SIZE // 4)
        self.assertEqual(shown.rows[8][SIZE // 2], (255, 255, 255))
        self.assertLess(sum(max(pixel) < 8 for pixel in pixels), len(pixels) // 4)
        self.assertLess(sum(min(pixel) == 255 for pixel in pixels), len(pixels) // 10)

    def look_into_exr(self):
        printed = run("compare_images", self.path("cornell.exr"), self.path("cornell.pfm"))
        self.assertEqual(printed.returncode, 0, printed.stderr)
        self.assertEqual(printed.stdout.split()[-1], "0", printed.stdout)

    def look_into_error_pictures(self, listed):
        names = [self.path("error.png"), self.path("bias.png")]
        self.assertEqual([(entry["file"], entry["width"], entry["height"]) for entry in listed],
                         [(name, SIZE, SIZE) for name in names])
        shown = [read_png(name) for name in names]
        for entry, picture in zip(listed, shown):
            self.assertIn("100 %", entry["legend"][0]["text"])
            self.assertEqual(picture.width, SIZE)
            self.assertGreater(picture.height, SIZE)
            self.assertGreater(len(set(picture.pixels())), SIZE)
        self.assertNotEqual(shown[0].rows[:SIZE], shown[1].rows[:SIZE])

    def look_into_partition_pictures(self):
        shown = [read_png(self.path(name)) for name in PICTURES]
        colours = [len(set(picture.pixels())) for picture in shown]
        self.assertGreaterEqual(colours[0], 10, "each shared map in view has its colour")
        self.assertGreaterEqual(min(colours), 2)
        self.assertGreater(colours[2], 2 * colours[3], "candidates by photons, and no groups")
        self.assertEqual(len({str(picture.rows) for picture in shown}), len(PICTURES))

    def look_into_partition(self, found):
        self.assertEqual(found["faces"], FACES)
        self.assertEqual(found["shared_maps"], SHARED_MAPS)
        self.assertEqual({name: found["edges"][name] for name in EDGES}, EDGES)
        self.assertEqual(found["candidates"], CANDIDATES)
        self.assertEqual(found["groups"], 0, "glass and mirrors store no photons")
        self.assertEqual(found["expected"]["candidates_by_shape"], FACES)
        self.assertEqual(len(found["maps"]), SHARED_MAPS)
        self.assertEqual(sum(part["faces"] for part in found["maps"]), FACES)
        self.assertAlmostEqual(sum(part["area_m2"] for part in found["maps"]), AREA, delta=0.02)

    def look_into_statistics(self, stats):
        self.assertEqual(stats["scene"]["faces"], FACES)
        self.assertEqual(stats["partition"]["shared_maps"], SHARED_MAPS)
        self.assertEqual(stats["image"]["width"], SIZE)
        self.assertEqual(stats["image"]["files"],
                         [self.path("cornell" + suffix) for suffix in (".png", ".exr", ".pfm")])
        self.assertEqual(stats["command"][:2], ["render", Tools.scene])
        self.assertEqual(stats["ended_by"], "passes")
        self.assertTrue(any("Lamp" in sentence for sentence in stats["audit"]["found"]))
        self.assertEqual([check["passes"] for check in stats["error"]["checks"]], [2, 3, 4])
        law, last = stats["error"]["law"], stats["error"]["checks"][-1]
        square = (law["by_pass"] / 4 + law["by_photon"] / 4 ** law["photon_power"] +
                  law["by_bias"] / 4 ** law["bias_power"])
        self.assertAlmostEqual(math.sqrt(square), last["error"], delta=1e-6)
        photons = stats["photons"]
        self.assertEqual(photons["emitted"], 4 * PHOTONS)
        self.assertGreater(photons["caustic"]["stored"], 0)
        self.assertGreater(photons["global"]["stored"], photons["caustic"]["stored"])
        self.assertEqual(photons["stored"],
                         photons["caustic"]["stored"] + photons["global"]["stored"])
        self.assertTrue(all(seconds >= 0 for seconds in stats["seconds"].values()))
        self.look_into_seconds(stats["seconds"], dict(stats["processor_seconds"]))
        power = stats["power_W"]
        for c, radiance in enumerate(LAMP_RADIANCE):
            emitted = math.pi * LAMP_AREA * radiance
            self.assertAlmostEqual(power["emitted"][c], emitted, delta=0.01 * emitted)
            went = power["absorbed"][c] + power["escaped"][c]
            self.assertAlmostEqual(went, emitted, delta=0.05 * emitted)

    def look_into_seconds(self, clock, processor):
        """The stages are within the process, and one that renders took time."""
        process = processor.pop("process")
        self.assertEqual(clock.keys(), processor.keys())
        self.assertGreater(process, sum(processor.values()))
        for stage in ("scene", "pilots", "photons", "maps", "image", "film", "write"):
            self.assertGreater(clock[stage], 0, stage)

    def test_the_modes_agree_and_none_is_darker(self):
        partition = self.make_partition()
        means = {mode: sum(self.render(partition, "--maps", mode, size=32).mean())
                 for mode in ("none", "global", "shared", "thesis", "hierarchical")}
        self.assertLess(means["none"], 0.9 * means["shared"])
        self.assertAlmostEqual(means["global"], means["shared"], delta=0.1 * means["shared"])
        self.assertAlmostEqual(means["thesis"], means["shared"], delta=0.1 * means["shared"])
        self.assertEqual(means["hierarchical"], means["shared"])
        plain = sum(self.render(partition, "--estimate", "thesis", size=32).mean())
        self.assertAlmostEqual(plain, means["shared"], delta=0.1 * means["shared"])
        self.assertNotEqual(plain, means["shared"])

    def test_direct_light_from_photons_is_as_bright_as_by_shadow_rays(self):
        partition = self.make_partition()
        rays = sum(self.render(partition, "--direct", "shadow-rays", size=32).mean())
        photons = sum(self.render(partition, "--direct", "photons", size=32).mean())
        self.assertAlmostEqual(photons, rays, delta=0.1 * rays)

    def test_the_number_of_threads_does_not_change_a_bit(self):
        partition = self.make_partition()
        images = []
        for threads in (1, 2, 7):
            self.render(partition, "--threads", threads, "--maps", "thesis", size=24)
            with open(self.path("image.pfm"), "rb") as file:
                images.append(file.read())
        self.assertEqual(images[0], images[1])
        self.assertEqual(images[0], images[2])

    def test_hierarchical_maps_change_no_bit_of_those_of_the_default(self):
        partition = self.make_partition()
        images = []
        hierarchical = ("--maps", "hierarchical")
        for options, maps in (((), "shared"), (hierarchical, "hierarchical"),
                              ((*hierarchical, "--tiers", "all", "--local-min", 20),
                               "hierarchical")):
            self.render(partition, *options, "--neighbours", 10, "--stats",
                        self.path("stats.json"), size=24, photons=20000)
            with open(self.path("image.pfm"), "rb") as file:
                images.append(file.read())
            stats = self.read_json("stats.json")
            self.assertEqual(stats["options"]["maps"], maps)
        self.assertEqual(images[0], images[1])
        self.assertEqual(images[0], images[2])
        tiers = [stats["photons"][kind]["local"] for kind in ("global", "caustic")]
        self.assertGreater(min(tier["candidates"] for tier in tiers), 0)
        self.assertGreater(sum(tier["searches"] for tier in tiers), 0)
        self.assertLessEqual(max(tier["saving"] for tier in tiers), 0)

    def test_clamping_leaves_the_lamp_and_is_told_as_bias(self):
        partition = self.make_partition()
        for method in ("--photons", PHOTONS), ("--integrator", "path"):
            said = self.succeed("render", Tools.scene, partition, "-o", self.path("image.pfm"),
                                "--size", 32, *method, "--passes", 4, "--clamp", 0.2, "--filter",
                                "box", "--stats", self.path("stats.json"))
            self.assertRegex(said, "accuracy: error .*; bias of --clamp [0-9]")
            rows = read_pfm(self.path("image.pfm")).rows
            brightest = sorted(max(pixel) for row in rows for pixel in row)
            self.assertGreater(brightest[-1], max(LAMP_RADIANCE) / 2)
            self.assertLess(brightest[len(brightest) // 2], 0.201)
            check = self.read_json("stats.json")["error"]["checks"][-1]
            self.assertGreater(check["clamp"], 0.1)
            self.assertGreater(check["error"], check["clamp"])
        self.refuse("render", Tools.scene, partition, "-o", self.path("a.pfm"), "--integrator",
                    "occlusion", "--clamp", 1, naming="--clamp 1 needs --integrator")

    def test_an_excluded_object_is_gone(self):
        self.succeed("preprocess", Tools.scene, "-o", self.path("less.hpm"), "--exclude", "Block")
        self.render(self.path("less.hpm"), "--exclude", "Block", "--stats",
                    self.path("stats.json"), size=8)
        stats = self.read_json("stats.json")
        self.assertEqual(stats["scene"]["faces"], FACES - 12)
        self.assertEqual(stats["partition"]["shared_maps"], SHARED_MAPS - 6)

    def test_a_scene_without_light_and_camera_is_lit_and_framed(self):
        with open(self.path("plate.obj"), "w", encoding="utf-8") as file:
            file.write("v 0 0 0\nv 3 0 0\nv 3 2 0\nv 0 2 0\nf 1 2 3\nf 1 3 4\n")
        self.succeed("preprocess", self.path("plate.obj"), "-o", self.path("plate.hpm"))
        said = self.succeed("render", self.path("plate.obj"), self.path("plate.hpm"), "-o",
                            self.path("plate.pfm"), "--size", "16x16", "--passes", 1)
        self.assertIn("camera", said)
        self.assertIn("sky", said)
        image = read_pfm(self.path("plate.pfm"))
        self.assertGreater(min(image.rows[8][8]), 0.01)


if __name__ == "__main__":
    tools.main(sys.argv)
