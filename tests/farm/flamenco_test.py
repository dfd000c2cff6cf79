"""farm/hipmap_flamenco.js: its tasks, compiled by a stand-in for Flamenco Manager and run in any order that
their dependencies allow, make the images of one render.

    flamenco_test.py FOLDER_OF_TOOLS ROOT

Exit code 77 where node is missing.
"""

import json
import os
import random
import shutil
import subprocess
import sys
import tempfile
import unittest

TOOLS, ROOT = sys.argv[1:3]
SCENE = os.path.join(ROOT, "assets/effects/motion.glb")
STAND_IN = os.path.join(os.path.dirname(os.path.abspath(__file__)), "flamenco_stand_in.js")
OPTIONS = ["--size", "12x8", "--photons", "500"]
SEED = 2


class Flamenco(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="hipmap-test-")
        self.addCleanup(temporary.cleanup)
        self.folder = temporary.name

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def compile(self, **changed):
        settings = {"scene": SCENE, "frames": "1, 3", "fps": 24, "passes": 5, "chunk_size": 3,
                    "tiles": "2x1", "size": "12x8", "options": "--photons  500", "output": self.path("farm"),
                    "preview_video": True, **changed}
        with open(self.path("settings.json"), "w", encoding="utf-8") as file:
            json.dump(settings, file)
        return subprocess.run(["node", STAND_IN, os.path.join(ROOT, "farm/hipmap_flamenco.js"),
                               self.path("settings.json")], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True, check=False)

    def run_command(self, command):
        parameters = command["parameters"]
        if command["name"] == "frames-to-video":
            return
        self.assertEqual((command["name"], sorted(parameters)), ("exec", ["args", "exe"]))
        exe = parameters["exe"]
        for variable, tool in (("{hipmapRender}", "render"), ("{hipmapPreprocess}", "preprocess")):
            exe = exe.replace(variable, os.path.join(TOOLS, tool))
        done = subprocess.run([exe, *parameters["args"]], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, check=False)
        self.assertEqual(done.returncode, 0, (parameters, done.stdout))
        self.assertNotIn("warning: missing", done.stdout if "--passes" in parameters["args"] else "")

    def test_tasks_in_any_order_make_the_images_of_one_render(self):
        done = self.compile()
        self.assertEqual(done.returncode, 0, done.stderr)
        tasks = {task["name"]: task for task in json.loads(done.stdout)["tasks"]}
        self.assertEqual(len(tasks), 2 * (1 + 2 * 2 + 1 + 1) + 1)
        self.assertEqual(sorted(tasks["preview-video"]["dependencies"]), ["merge-1", "merge-3"])
        self.assertEqual(len(tasks["merge-3"]["dependencies"]), 4)
        chance, finished = random.Random(SEED), set()
        while len(finished) < len(tasks):
            ready = [name for name, task in tasks.items()
                     if name not in finished and finished.issuperset(task["dependencies"])]
            name = chance.choice(sorted(ready))
            for command in tasks[name]["commands"]:
                self.run_command(command)
            finished.add(name)
        subprocess.run([os.path.join(TOOLS, "preprocess"), SCENE, "-o", self.path("a.hpm"), "--frames", "3"],
                       stderr=subprocess.DEVNULL, check=True)
        subprocess.run([os.path.join(TOOLS, "render"), SCENE, self.path("a.hpm"), "--frames", "3",
                        "-o", self.path("a.exr"), "--passes", "5", *OPTIONS], stderr=subprocess.DEVNULL,
                       check=True)
        with open(self.path("a.0003.exr"), "rb") as one, open(self.path("farm/image.0003.exr"), "rb") as other:
            self.assertEqual(one.read(), other.read())
        self.assertTrue(os.path.exists(self.path("farm/preview.0001.png")))

    def test_settings_that_make_no_sense_are_refused(self):
        for changed, naming in (({"tiles": "2"}, "COLUMNSxROWS"), ({"passes": 0}, "whole numbers"),
                                ({"output": ""}, "folder"), ({"frames": "a"}, "range")):
            done = self.compile(**changed)
            self.assertEqual(done.returncode, 1)
            self.assertIn(naming, done.stderr)

    def test_each_setting_has_a_kind_and_a_description(self):
        for setting in json.loads(self.compile().stdout)["type"]["settings"]:
            self.assertIn(setting["type"], ("string", "int32", "float", "bool"))
            self.assertTrue(setting["description"])


if __name__ == "__main__":
    if not shutil.which("node"):
        print("skipped: no node (apt-get install nodejs)")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1], verbosity=2)
