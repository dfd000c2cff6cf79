"""8-bit images through a view transform are those that Blender makes of the same radiance.

    view_test.py FOLDER_OF_TOOLS SCENE

Skipped (exit code 77) where Blender is missing or the tools are built without OpenColorIO.
"""

import os
import shutil
import subprocess
import sys

import tools
from pictures import read_png
from tools import Tools, ToolsTestCase, run

SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "view_in_blender.py")


class View(ToolsTestCase):
    def setUp(self):
        super().setUp()
        self.write_partition()

    def render(self, name, *options):
        return self.succeed("render", Tools.scene, self.path("scene.hpm"), "-o", self.path(name),
                            "--size", "48x48", "--photons", 3000, "--passes", 2, *options)

    def in_blender(self, views):
        """What Blender makes of VIEW.exr, by view."""
        # Debian's Blender takes the first python3 on the PATH, which must be Debian's too.
        environment = {"PATH": "/usr/bin:/bin", "HOME": self.folder}
        done = subprocess.run(["blender", "-b", "--factory-startup", "--python-exit-code", "1",
                               "--python", SCRIPT, "--",
                               *(word for view in views for word in (
                                   self.path(view + ".exr"), view, self.path(view + "_blender.png")))],
                              env=environment, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return {view: read_png(self.path(view + "_blender.png")) for view in views}

    def test_views_are_those_of_blender(self):
        views = ("Filmic", "Standard")
        for view in views:
            self.render(view + ".png", "-o", self.path(view + ".exr"), "--exposure", 0, "--ocio",
                        "blender", "--view", view)
        for view, theirs in self.in_blender(views).items():
            ours = read_png(self.path(view + ".png"))
            self.assertEqual((ours.width, ours.height), (theirs.width, theirs.height))
            differences = [abs(a - b) for mine, other in zip(ours.pixels(), theirs.pixels())
                           for a, b in zip(mine, other)]
            self.assertLessEqual(max(differences), 1, view)
            self.assertGreater(len(set(ours.pixels())), 300)

    def test_the_view_changes_no_radiance_and_plain_srgb_is_the_default(self):
        self.render("plain.png", "-o", self.path("plain.exr"), "--exposure", 0)
        self.render("filmic.png", "-o", self.path("filmic.exr"), "--exposure", 0, "--ocio",
                    "blender", "--view", "Filmic")
        contents = {}
        for name in ("plain.png", "filmic.png", "plain.exr", "filmic.exr"):
            with open(self.path(name), "rb") as file:
                contents[name] = file.read()
        self.assertEqual(contents["plain.exr"], contents["filmic.exr"])
        self.assertNotEqual(contents["plain.png"], contents["filmic.png"])

    def test_an_unknown_view_is_refused_before_the_render(self):
        wrong = ("--ocio", "blender", "--view", "Filmik")
        self.refuse("render", Tools.scene, self.path("scene.hpm"), "-o", self.path("a.png"),
                    *wrong, naming="'Filmik', but 'Standard', 'Filmic'")
        self.refuse("render", Tools.scene, self.path("scene.hpm"), "-o", self.path("a.png"),
                    "--view", "Filmic", naming="--ocio")


if __name__ == "__main__":
    Tools.folder = sys.argv[1]
    if shutil.which("blender") is None:
        print("skipped: blender is not installed")
        sys.exit(77)
    if "no OpenColorIO" in run("render", "a.glb", "a.hpm", "-o", "a.png", "--ocio", "b").stderr:
        print("skipped: the tools are built without OpenColorIO")
        sys.exit(77)
    tools.main(sys.argv)
