"""Frames of an animation: each is what it is when it is asked for alone.

    frames_test.py FOLDER_OF_TOOLS SCENE
"""

import json
import os
import struct
import subprocess
import sys

import tools
from tools import Tools, ToolsTestCase

SMALL = ("--size", "16", "--photons", "2000")


class Frames(ToolsTestCase):
    def content(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def preprocess(self, *options, output="scene.hpm"):
        return self.succeed("preprocess", Tools.scene, "-o", self.path(output), "--verbose",
                            *options)

    def render(self, image, *options, passes=2):
        return self.succeed("render", Tools.scene, self.path("scene.hpm"), "-o", self.path(image),
                            *SMALL, "--passes", passes, "--verbose", *options)

    def test_a_frame_alone_is_the_frame_of_the_row(self):
        said = self.preprocess("--frames", "6:8")
        self.assertIn("this frame is at 0.25 s", said)
        self.assertIn("this frame is at 0.333 s", said)
        self.render("row.pfm", "--frames", "6:8")
        for frame in (6, 7, 8):
            row = self.content(f"scene.{frame:04}.hpm"), self.content(f"row.{frame:04}.pfm")
            self.preprocess("--frames", frame, output="one.hpm")
            self.render("one.pfm", "--frames", frame)
            one = self.content(f"one.{frame:04}.hpm"), self.content(f"one.{frame:04}.pfm")
            self.assertEqual(row[0], one[0], frame)
            self.assertEqual(row[1], one[1], frame)
        self.assertNotEqual(self.content("row.0006.pfm"), self.content("row.0008.pfm"))

    def test_a_partition_serves_until_something_moves(self):
        said = self.preprocess("--frames", "23:26")
        self.assertEqual(said.count("frame unchanged: reusing the previous partition"), 2)
        for frame in (24, 25, 26):
            self.preprocess("--frames", frame, output="one.hpm")
            self.assertEqual(self.content(f"one.{frame:04}.hpm"),
                             self.content(f"scene.{frame:04}.hpm"))

    def test_an_image_serves_until_something_moves(self):
        self.preprocess("--frames", "24:26")
        said = self.render("row.pfm", "--frames", "24:26")
        self.assertEqual(said.count("frame unchanged: reusing the previous image"), 2)
        self.render("one.pfm", "--frames", "26")
        self.assertEqual(self.content("one.0026.pfm"), self.content("row.0026.pfm"))

    def write_flight(self):
        """A scene in which only the camera moves."""
        sys.path.append(os.path.dirname(os.path.dirname(os.path.abspath(Tools.scene))))
        import effects
        glb = effects.stage()
        glb.animate("Camera", translation=("LINEAR", (0, 1), [(0, 0.95, 3), (0.5, 0.95, 3)]))
        glb.write(self.path("flight.glb"))
        return self.path("flight.glb"), self.path("flight.hpm")

    def test_photons_serve_as_long_as_only_the_camera_moves(self):
        scene, partition = self.write_flight()
        self.succeed("preprocess", scene, "-o", partition, "--frames", "3:5")

        def fly(image, *options):
            return self.succeed("render", scene, partition, "-o", self.path(image), *SMALL,
                                "--passes", 2, "--verbose", *options)

        said = fly("row.pfm", "--frames", "3:5")
        self.assertEqual(said.count("reused the photon maps of 2 passes"), 2)
        said = fly("anew.pfm", "--frames", "3:5", "--photon-cache", "0")
        self.assertNotIn("reused the photon maps", said)
        fly("one.pfm", "--frames", "5")
        for frame in (4, 5):
            self.assertEqual(self.content(f"row.{frame:04}.pfm"),
                             self.content(f"anew.{frame:04}.pfm"))
        self.assertEqual(self.content("row.0005.pfm"), self.content("one.0005.pfm"))
        self.assertNotEqual(self.content("row.0004.pfm"), self.content("row.0005.pfm"))

    def test_a_server_reuses_photons_while_requests_differ_in_the_camera(self):
        scene, partition = self.write_flight()
        with open(scene, "rb") as file:
            first = file.read()
        x, y, z = (struct.pack("<f", value) for value in (0.0, 0.95, 3.0))
        self.assertEqual(first.count(x + y + z), 1)  # the first key; all requests show one frame
        self.succeed("preprocess", scene, "-o", partition, "--frames", "0")
        words = [scene, partition, "-o", self.path("served.pfm"), *SMALL, "--passes", "2",
                 "--frames", "0", "--verbose"]
        with subprocess.Popen([os.path.join(Tools.folder, "render"), "serve"],
                              stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True) as server:
            images = []
            for moved in (0.0, 0.25):
                with open(scene, "wb") as file:
                    file.write(first.replace(x + y + z, struct.pack("<f", moved) + y + z))
                for options in ([], ["--seed", "1"] if moved else []):
                    server.stdin.write(json.dumps([*words, *options]) + "\n")
                    server.stdin.flush()
                    self.assertEqual(json.loads(server.stdout.readline()),
                                     {"event": "done", "code": 0})
                    images.append(self.content("served.0000.pfm"))
            said, errors = server.communicate(json.dumps([*words, "--mpi"]) + '\n["--wrong"]\nno words\n')
        self.assertEqual([json.loads(line) for line in said.splitlines()],
                         2 * [{"event": "done", "code": 2}])
        self.assertEqual(errors.count("error: --mpi: render serve renders in one process; leave it out\n"), 1)
        self.assertEqual(server.returncode, 2)
        self.assertIn("error: standard input: not a command line", errors)
        reports = errors.split("done\n")
        self.assertIn("frame unchanged: reusing the previous image", reports[1])
        self.assertIn("reused the photon maps of 2 passes", reports[2])
        self.assertNotIn("reus", reports[3])  # of other options
        self.assertEqual(images[0], images[1])
        self.render_alone(words, "alone.pfm")
        self.assertEqual(self.content("alone.0000.pfm"), images[2])
        self.assertNotEqual(images[0], images[2])

    def render_alone(self, words, image):
        self.succeed("render", *words[:3], self.path(image), *words[4:])

    def test_frames_print_a_line_each_the_audit_once_and_a_total(self):
        self.succeed("preprocess", Tools.scene, "-o", self.path("scene.hpm"), "--frames", "6:8",
                     "--quiet")
        said = self.succeed("render", Tools.scene, self.path("scene.hpm"), "-o",
                            self.path("row.pfm"), *SMALL, "--passes", 2, "--frames", "6:8")
        lines = said.splitlines()
        self.assertEqual([line.split(":")[0] for line in lines if not line.startswith("assumed")],
                         ["scene", "frame 1 of 3", "frame 2 of 3", "frame 3 of 3",
                          "all 3 frames"], said)
        self.assertRegex(said, r"frame 2 of 3: 2 passes, error .* %; all frames .* left\n")
        self.assertRegex(said, r"frame 3 of 3: 2 passes, error [0-9.]+ %\nall 3 frames: .* s, "
                               r"errors .* % to .* %\n")

    def test_fps_says_when_a_frame_is(self):
        self.preprocess("--frames", "6")
        self.preprocess("--frames", "3", "--fps", "12", output="slow.hpm")
        self.assertEqual(self.content("scene.0006.hpm"), self.content("slow.0003.hpm"))

    def test_a_shutter_blurs_what_moves_the_same_way_at_any_thread_count(self):
        self.preprocess("--frames", "3")
        frame = ("--frames", "3")
        blurred = (*frame, "--shutter", "0.5")
        said = self.render("one.pfm", *blurred, "--threads", "1")
        self.assertIn("motion-blur", said)
        self.render("two.pfm", *blurred, "--threads", "2")
        self.assertEqual(self.content("one.0003.pfm"), self.content("two.0003.pfm"))
        self.render("sharp.pfm", *frame)
        self.assertNotEqual(self.content("one.0003.pfm"), self.content("sharp.0003.pfm"))
        self.render("off.pfm", *blurred, "--effects", "-motion-blur")
        self.assertEqual(self.content("off.0003.pfm"), self.content("sharp.0003.pfm"))
        self.assertIn("motion-blur: on; 'Ball' moves", self.render("a.pfm", *blurred, "--explain"))

    def test_killed_frames_resume_with_a_state_each(self):
        self.preprocess("--frames", "6:7")
        frames = ("--frames", "6:7", "--state", self.path("kept.state"))
        self.render("whole.pfm", *frames[:2], passes=3)
        command = [os.path.join(Tools.folder, "render"), Tools.scene, self.path("scene.hpm"), "-o",
                   self.path("row.pfm"), *SMALL, "--passes", "100000", "--progress", "json",
                   *frames]
        self.render("row.pfm", *frames, passes=1)
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as killed:
            while json.loads(killed.stdout.readline())["passes"] < 2:
                pass
            killed.kill()
        said = self.render("row.pfm", *frames, passes=3)
        self.assertRegex(said, r"frame 1 of 2: \d+ passes \(\d+ of them resumed\), error")
        self.assertIn("frame 2 of 2: 3 passes (1 of them resumed), error", said)
        self.assertEqual(self.content("row.0007.pfm"), self.content("whole.0007.pfm"))
        if "frame 1 of 2: 3 passes" in said:  # the killed run kept no more
            self.assertEqual(self.content("row.0006.pfm"), self.content("whole.0006.pfm"))
        before = self.content("row.0006.pfm")
        said = self.render("row.pfm", *frames, passes=3)
        self.assertIn("frame 2 of 2: 3 passes (3 of them resumed)", said)
        self.assertNotIn("left", said)  # nothing is known of frames that take passes
        self.assertEqual(self.content("row.0006.pfm"), before)

    def test_a_state_goes_on_with_the_same_shutter_only(self):
        self.preprocess("--frames", "3")
        state = ("--frames", "3", "--state", self.path("kept"))
        self.render("a.pfm", *state, "--shutter", "0.5", passes=1)
        self.render("a.pfm", *state, "--shutter", "0.5")
        self.render("b.pfm", "--frames", "3", "--shutter", "0.5")
        self.assertEqual(self.content("a.0003.pfm"), self.content("b.0003.pfm"))
        for shutter in ("0.25", "0"):
            self.refuse("render", Tools.scene, self.path("scene.hpm"), "-o", self.path("c.pfm"),
                        *SMALL, *state, "--shutter", shutter, naming="kept.0003")

    def test_nothing_blurs_where_nothing_moves(self):
        self.preprocess("--frames", "48")
        said = self.render("a.pfm", "--frames", "48", "--shutter", "1", "--explain")
        self.assertIn("motion-blur: off; nothing moves while the shutter is open", said)

    def test_what_makes_no_sense_is_refused(self):
        self.preprocess("--frames", "2:3")
        image = ("-o", self.path("refused.pfm"))
        partition = self.path("scene.hpm")
        for frames, naming in (("3:2", "ends before"), ("x", "not a range"), ("1:2:3", "not a range"),
                               ("-1:2", "--frames"), ("4", "scene.0004.hpm")):
            self.refuse("render", Tools.scene, partition, *image, "--frames", frames,
                        naming=naming)
        for option in ("--fps", "--shutter"):
            self.refuse("render", Tools.scene, partition, *image, option, "1", naming="--frames")
        self.refuse("render", Tools.scene, partition, *image, "--frames", "2", "--fps", "25",
                    naming="scene.0002.hpm")


if __name__ == "__main__":
    tools.main(sys.argv)
