"""The preview in a 3D viewport of a Blender with a window, under Xvfb.

    preview_test.py FOLDER_OF_TOOLS
"""

import json
import os
import shutil
import sys

import inside_blender
from inside_blender import HERE, BlenderTestCase, Tools


class Preview(BlenderTestCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        this = cls()
        this.make_addon("hipmap.zip", "--programs", Tools.folder)
        this.blender_window("--python", os.path.join(HERE, "preview_window.py"), "--",
                            this.path("hipmap.zip"), cls.folder)
        with open(this.path("facts.json"), encoding="utf-8") as file:
            cls.facts = json.load(file)

    def test_the_viewport_shows_the_scene(self):
        self.assertGreater(min(self.facts["mean"]), 0.03)
        self.assertGreater(min(self.facts["part"]), 50)
        self.assertGreater(os.path.getsize(self.path("window.png")), 10_000)

    def test_a_moved_view_needs_no_export(self):
        self.assertFalse(self.facts["scene_exported_again"])

    def test_a_brighter_light_is_seen(self):
        self.assertGreater(self.facts["brighter"], 1.1)

    def test_another_shading_ends_the_program(self):
        self.assertEqual(self.facts["children"], [1, 0])

    def test_the_button_renders_in_the_background(self):
        self.assertEqual(self.facts["quote"], ["RUNNING_MODAL"])
        self.assertEqual(self.facts["asked"], [True, False])
        self.assertGreater(len(self.facts["costs"]), 0)


if __name__ == "__main__":
    if shutil.which("xvfb-run") is None:
        print("skipped: xvfb-run is not installed; apt-get install xvfb runs these tests")
        sys.exit(inside_blender.SKIPPED)
    inside_blender.main(sys.argv)
