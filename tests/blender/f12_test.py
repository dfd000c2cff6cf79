"""F12 in Blender: the pixels of the command line, bit for bit.

    f12_test.py FOLDER_OF_TOOLS
"""

import array
import json
import os
import sys
import time

import inside_blender
from glb_content import Glb
from inside_blender import HERE, BlenderTestCase, Tools

STILL = ("modifiers", "instances", "lights", "sky", "text", "glass", "media")
MOTION = ("--frames", 1, "--fps", 1, "--shutter", 1)
OPTIONS = ("--photons", 5000, "--threads", 2)
WIDTH, HEIGHT = 48, 32
PIXEL = 12  # bytes


class F12(BlenderTestCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        this = cls()
        this.blender("--python", os.path.join(HERE, "f12_scenes.py"), "--", cls.folder)
        this.make_addon("hipmap.zip", "--programs", Tools.folder)
        began = time.monotonic()
        cls.said = this.blender("--python", os.path.join(HERE, "f12_inside.py"), "--",
                                this.path("hipmap.zip"), cls.folder, cls.folder)
        print(f"24 renders in Blender: {time.monotonic() - began:.1f} s")
        with open(this.path("facts.json"), encoding="utf-8") as file:
            cls.facts = json.load(file)

    def content(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def by_command_line(self, folder, *options, size=(WIDTH, HEIGHT)):
        """The pixels of the scene that F12 exported, with a partition of its own."""
        scene = self.path(os.path.join(folder, "Scene_ViewLayer", "scene.glb"))
        of_frame = options[:4] if "--frames" in options else ()
        self.tool("preprocess", scene, "-o", self.path("own.hpm"), *of_frame)
        self.tool("render", scene, self.path("own.hpm"), "-o", self.path("own.pfm"), *OPTIONS,
                  "--size", f"{size[0]}x{size[1]}", *options)
        made = "own.0001.pfm" if of_frame else "own.pfm"
        return self.content(made)[-size[0] * size[1] * PIXEL:]

    def channels(self, folder):
        """What moves of an exported scene: (name of the node, path) and its keys."""
        glb = Glb(self.path(os.path.join(folder, "Scene_ViewLayer", "scene.glb")))
        animation, = glb.json["animations"]
        return {(glb.json["nodes"][channel["target"]["node"]]["name"], channel["target"]["path"]):
                glb.array(animation["samplers"][channel["sampler"]]["output"])
                for channel in animation["channels"]}

    def red_by_column(self, pixels):
        """How much more red than blue is in each column."""
        values = array.array("f", pixels)
        return [sum(values[3 * (row * WIDTH + x)] - values[3 * (row * WIDTH + x) + 2]
                    for row in range(HEIGHT)) for x in range(WIDTH)]

    def test_motion_is_blurred_as_on_the_command_line(self):
        self.assertEqual(self.content("motion.f32"),
                         self.by_command_line("motion", *MOTION, "--passes", 2))
        self.assertNotIn("motion blur", self.said)

    def test_an_object_that_moves_is_spread_along_its_path(self):
        blurred, still = (self.red_by_column(self.by_command_line("motion", *options, "--passes",
                                                                  32, "--integrator", "path"))
                          for options in (MOTION, MOTION[:4]))
        self.assertAlmostEqual(sum(blurred) / sum(still), 1, delta=0.05)
        self.assertLess(max(blurred), 0.75 * max(still))
        columns = [sum(value > 0.05 * max(still) for value in one) for one in (blurred, still)]
        # A ball of diameter 0.8 moves by 1 while the shutter is open.
        self.assertAlmostEqual(columns[0] / columns[1], 1.8 / 0.8, delta=0.35)

    def test_the_shutters_time_is_that_of_the_scene(self):
        for folder, first in (("motion", -0.5), ("motion_start", 0)):
            keys = self.channels(folder)[("Ball", "translation")]
            for at, (x, y, z) in enumerate(keys):  # two metres a frame, open for half a frame
                self.assertAlmostEqual(x, first + 0.25 * at, 5)
                self.assertEqual((y, z), (1, -2))
        self.assertEqual(self.facts["frame_after_motion"], [1, 0])
        self.assertEqual(self.facts["ball_after_motion"], 0)

    def test_what_moves_has_keys_and_nothing_else(self):
        found = self.channels("motion")
        self.assertEqual(set(found), {("Ball", "translation"), ("Blade", "rotation"),
                                      ("Box", "weights")})
        self.assertEqual([w for w, in found["Box", "weights"]][:4], [1, 0, 0, 0])

    def test_a_scene_in_which_nothing_moves_is_no_animation(self):
        self.assertEqual(self.content("motionless.f32"),
                         self.by_command_line("modifiers", "--passes", 1))

    def test_a_volume_object_is_a_medium_in_a_box(self):
        self.assertIn("object 'Turned cloud': the volume is not rendered: it is turned", self.said)
        if not os.path.isfile(os.path.join(Tools.folder, "vdb_to_vol")):
            self.assertIn("no program 'vdb_to_vol'", self.said)
            return
        self.assertNotIn("object 'Cloud'", self.said)
        self.assertFalse(self.facts["volume_of_another_frame"])
        self.assertNotEqual(self.content("volume.f32"), self.content("motionless.f32"))
        self.assertEqual(self.content("volume.f32"), self.by_command_line("volume", "--passes", 1))
        scene = Glb(self.path("volume/Scene_ViewLayer/scene.glb"))
        medium = scene.materials()["Cloud"]["extras"]["hipmap"]["medium"]
        self.assertAlmostEqual(medium["scattering"][0], 0.5 * (3 / (1 + 4 + 1)) ** 0.5, 5)
        node, = (node for node in scene.json["nodes"] if node["name"] == "Cloud")
        primitive = scene.json["meshes"][node["mesh"]]["primitives"][0]
        corners = scene.array(primitive["attributes"]["POSITION"])
        for at, value in enumerate((-0.75 - 0.3, 0.1 - 0.3, -0.6 - 0.3)):  # a voxel around it
            self.assertAlmostEqual(corners[0][at], value, 5)

    def test_scenes(self):
        for name in STILL:
            pixels = self.content(name + ".f32")
            self.assertGreater(len(set(pixels[i:i + PIXEL] for i in range(0, len(pixels), PIXEL))),
                               100, name)
            self.assertEqual(pixels, self.by_command_line(name, "--passes", 2), name)
            print(f"{name}: {len(pixels) // PIXEL} pixels are equal")

    def test_the_partition_serves_until_a_face_moves(self):
        first, again, moved = self.facts["partitions"]
        self.assertEqual(first, again)
        self.assertNotEqual(again, moved)
        self.assertNotEqual(self.content("again.f32"), self.content("first.f32"))
        self.assertEqual(self.content("moved.f32"), self.by_command_line("again", "--passes", 2))

    def test_continue_adds_passes(self):
        self.assertNotEqual(self.content("proceed_2.f32"), self.content("proceed_4.f32"))
        self.assertEqual(self.content("proceed_4.f32"),
                         self.by_command_line("proceed", "--passes", 4))
        self.assertIn("rendering from the first pass", self.said)
        self.assertEqual(self.content("proceed_new.f32"),
                         self.by_command_line("proceed", "--passes", 2, "--seed", 1))

    def test_passes_are_kept_on_request_alone(self):
        self.assertFalse(self.facts["kept"])
        self.assertEqual(self.content("proceed_none.f32"), self.content("proceed_new.f32"))

    def test_a_quote_lists_costs_and_keeps_its_passes(self):
        rows = self.facts["costs"]
        print(rows)
        self.assertGreater(len(rows), 1)
        self.assertEqual(rows[0][1], "4 passes")
        self.assertIn("0.5 %", [error for error, _, _ in rows])
        errors = [float(error.split()[0]) for error, _, _ in rows]
        self.assertEqual(errors, sorted(errors, reverse=True))
        passes = self.facts["quoted_passes"]
        self.assertGreaterEqual(passes, 2)
        self.assertEqual(self.content("quoted.f32"),
                         self.by_command_line("quote", "--passes", passes + 2))

    def test_a_border_is_rendered_alone_in_its_place(self):
        part = self.content("crop.f32")
        self.assertEqual(len(part), WIDTH // 2 * HEIGHT // 2 * PIXEL)
        whole = self.content("border.f32")
        self.assertEqual(len(whole), WIDTH * HEIGHT * PIXEL)
        for row in range(HEIGHT // 2):
            begin = ((row + HEIGHT // 2) * WIDTH + WIDTH // 4) * PIXEL
            length = WIDTH // 2 * PIXEL
            self.assertEqual(whole[begin:begin + length], part[row * length:(row + 1) * length])
        self.assertEqual(whole[:WIDTH * HEIGHT // 2 * PIXEL], bytes(WIDTH * HEIGHT // 2 * PIXEL))

    def test_borders_have_blenders_size(self):
        self.assertEqual(len(self.facts["sizes"]), 60)
        for blender, ours in self.facts["sizes"]:
            self.assertEqual(blender, ours)

    def test_view_layers_are_rendered_each(self):
        sizes = [os.path.getsize(self.path(f"layers/Scene_{layer}/scene.glb"))
                 for layer in ("ViewLayer", "Other")]
        self.assertGreater(sizes[0], sizes[1] + 1000)

    def test_a_percentage_makes_the_image_smaller(self):
        size = WIDTH // 2, HEIGHT // 2
        self.assertEqual(self.content("half.f32"),
                         self.by_command_line("border", "--passes", 2, size=size))

    def test_frames(self):
        frames = [self.content(f"frame_{frame}.f32") for frame in range(1, 6)]
        self.assertEqual(len(set(frames)), 5)
        self.assertEqual(frames[-1], self.by_command_line("frames", "--passes", 2))

    def test_frames_share_photon_maps_while_only_the_camera_moves(self):
        self.assertEqual(self.facts["flight"], 3 * [False, True])
        self.assertEqual(self.facts["states_of_flight"],
                         ["scene.state", "scene_0001.state", "scene_0002.state"])
        self.assertEqual(self.facts["children_after_flight"], 0)
        self.assertEqual(self.content("flight_2.f32"),
                         self.by_command_line("flight", "--passes", 2))
        self.assertRegex(self.said, r"frame 2: 2 passes, error .* %, .* s; errors so far .* to ")

    def test_the_menu_exports(self):
        self.assertEqual(self.facts["export"], ["FINISHED"])
        self.assertIn("area light 'Square', 'Rectangle', 'Disk' and 'Ellipse'",
                      self.tool("preprocess", self.path("menu.glb"), "-o", self.path("menu.hpm")))

    def test_the_button_lists_effects(self):
        self.assertIn("depth-of-field: on; the camera 'Camera' has a lens", self.facts["effects"])

    def test_the_same_files_make_the_same_zip(self):
        self.make_addon("again.zip", "--programs", Tools.folder)
        self.assertEqual(self.content("again.zip"), self.content("hipmap.zip"))

    def test_colours_of_maps_come_and_go(self):
        self.assertEqual(self.facts["shown"], ["FINISHED"])
        print(self.facts["maps"])
        self.assertEqual(self.facts["maps"]["Floor"], 1)
        self.assertEqual(self.facts["maps"]["Cutter"], 2)  # in the cut and elsewhere
        self.assertEqual(self.facts["maps"]["Twin 0"], 6)
        self.assertEqual(self.facts["left"], [["Paint"]])
        self.assertEqual(self.content("maps.f32"), self.content("modifiers.f32"))

    def test_the_viewports_camera_is_that_of_f12(self):
        self.assertEqual(len(self.facts["cameras"]), 6)
        for viewport, f12 in self.facts["cameras"]:
            self.assertEqual(viewport.keys(), f12.keys())
            for name, value in f12.items():
                self.assertAlmostEqual(viewport[name], value, 4, name)

    def test_a_preview_is_what_the_command_line_renders(self):
        self.assertEqual(self.facts["preview"]["size"], [96, 64])
        scene = self.path("preview/kept.glb")
        self.tool("preprocess", scene, "-o", self.path("own.hpm"))
        self.tool("render", scene, self.path("own.hpm"), "-o", self.path("own.pfm"), "--threads",
                  2, "--integrator", "direct", "--size", "96x64", "--samples", 1, "--photons",
                  100000, "--passes", 2)
        pixels = self.content("preview/shown.f32")
        self.assertEqual(pixels, self.content("own.pfm")[-96 * 64 * PIXEL:])

    def test_a_preview_follows_the_camera_and_ends(self):
        facts = self.facts["preview"]
        self.assertEqual(facts["same"], [False, True])
        self.assertFalse(facts["partition_again"])
        self.assertEqual(facts["children"], [1, 0])
        self.assertLess(facts["seconds_to_end"], 1)
        print(f"a preview ends after {facts['seconds_to_end']:.2f} s")

    def test_failures_are_one_line(self):
        panoramic, without = self.facts["failures"]
        self.assertIn("hipmap renders no panoramic cameras", panoramic)
        self.assertIn("camera", without)

    def test_what_is_lost_is_named(self):
        self.assertNotIn("Traceback", self.said)
        print("\n".join(sorted({line for line in self.said.splitlines() if "Warning:" in line})))


if __name__ == "__main__":
    inside_blender.main(sys.argv)
