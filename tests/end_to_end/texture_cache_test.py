"""--texture-cache: memory for textures changes no image.

    texture_cache_test.py FOLDER_OF_TOOLS SCENE_WITH_TEXTURES
"""

import os
import sys
from unittest import mock

import tools
from tools import Tools, ToolsTestCase


class TextureCache(ToolsTestCase):
    def setUp(self):
        super().setUp()
        self.write_partition()

    def command(self, name, *options):
        return [Tools.scene, self.path("scene.hpm"), "--size", 48, "--photons", 3000, "--samples", 1, "--passes", 2,
                "--verbose", "-o", self.path(name), *options]

    def temporary_files(self, name):
        return mock.patch.dict(os.environ, {"TMPDIR": self.path(name)})

    def test_one_tile_in_memory_gives_the_same_image_and_leaves_no_file(self):
        os.mkdir(self.path("temporary"))
        self.assertNotIn("temporary file", self.succeed("render", *self.command("all.pfm")))
        with self.temporary_files("temporary"):
            said = self.succeed("render", *self.command("tile.pfm", "--texture-cache", 0, "--threads", 5))
        self.assertRegex(said, r"textures of \d+ MiB are in a temporary file")
        self.assertEqual(os.listdir(self.path("temporary")), [])
        self.same("all.pfm", "tile.pfm")

    def test_a_state_resumes_with_another_limit(self):
        state = "--state", self.path("image.state")
        self.succeed("render", *self.command("all.pfm", *state, "--texture-cache", 0))
        self.assertIn("resuming with 2 passes", self.succeed("render", *self.command("all.pfm", *state)))

    def test_a_folder_for_temporary_files_that_is_missing_is_an_error(self):
        with self.temporary_files("gone"):
            self.refuse("render", *self.command("x.pfm", "--texture-cache", 0), naming="TMPDIR")


if __name__ == "__main__":
    tools.main(sys.argv)
