"""experiments/calibration counts what it says, and judges it as it should.

    calibration_test.py ROOT FOLDER_OF_TOOLS
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

ROOT, TOOLS = sys.argv[1:3]
FOLDER = os.path.join(ROOT, "experiments/calibration")
SCENE = "cornell_diffuse"  # the reference of this one takes the least time
sys.path.insert(0, FOLDER)
import jobs
import report
import runs


def images(inside, above, below):
    image = {"low": 0.1, "high": 0.2, "error": 0.15, "passes": 11}
    return ([{**image, "true": 0.15}] * inside + [{**image, "true": 0.3}] * above +
            [{**image, "true": 0.05}] * below)


def case(found, integrator="path"):
    return {"scene": "room", "integrator": integrator, "target": 15, "reference": "path",
            "reference_error": 0.02, "images": found}


class Calibration(unittest.TestCase):
    def test_the_chance_of_a_count_is_that_of_all_that_are_no_likelier(self):
        self.assertAlmostEqual(report.chance(2, 2, 0.9), 1)
        self.assertAlmostEqual(report.chance(1, 2, 0.9), 0.19)
        self.assertAlmostEqual(report.chance(0, 2, 0.9), 0.01)
        self.assertAlmostEqual(report.chance(50, 50), 0.1806, places=4)
        self.assertLess(report.chance(42, 50), 0.01)

    def test_too_few_and_too_many_inside_are_not_right(self):
        self.assertEqual(report.case_row(case(images(47, 2, 1)))[-4:-2], ["47 of 50", "1, 2"])
        self.assertEqual(report.case_row(case(images(47, 2, 1)))[-1], "right")
        self.assertEqual(report.case_row(case(images(40, 10, 0)))[-1], "**not right**")
        self.assertIn("95 of 100, 95.0 %: right", report.pooled([case(images(95, 5, 0))]))
        self.assertIn("99 of 100, 99.0 %: **not", report.pooled([case(images(99, 1, 0))]))

    def test_paths_are_the_truth_unless_they_cannot_find_the_light(self):
        self.assertEqual(runs.reference_method("cornell", "progressive"), runs.LONG_PATH)
        self.assertEqual(runs.reference_method("hexagonal", "path"), runs.LONG_PATH)
        self.assertEqual(runs.reference_method("hexagonal", "progressive"),
                         runs.LONG_PROGRESSIVE)
        self.assertEqual(runs.reference_method("cornell", "direct"), runs.INTEGRATORS["direct"])

    def test_what_has_no_reference_is_left_out(self):
        self.assertEqual(runs.integrators_for("cornell", runs.INTEGRATORS), list(runs.INTEGRATORS))
        self.assertEqual(runs.integrators_for("glass_globe", runs.INTEGRATORS),
                         ["progressive", "direct"])
        self.assertEqual(runs.integrators_for("carafe", list(runs.INTEGRATORS)), [])
        self.assertEqual(runs.integrators_for("museum", list(runs.INTEGRATORS)), ["progressive"])
        self.assertEqual(runs.integrators_for("kitchen", ["path", "direct"]), ["direct"])


def calibrate(folder, seeds):
    """The steps that were done, and the cases."""
    done = subprocess.run(
        [sys.executable, "-B", os.path.join(FOLDER, "calibrate.py"), "--seeds", str(seeds),
         "--size", "8", "--scenes", SCENE, "--integrators", "path", "--tools", TOOLS,
         "--to", folder, "--work", folder / "work"], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    results = json.loads((folder / "calibration.json").read_text())
    return re.findall(r"^\[\d+/\d+\]", done.stderr, re.M), results["cases"]


class Command(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory(prefix="hipmap-test-")
        cls.addClassCleanup(temporary.cleanup)
        cls.first = pathlib.Path(temporary.name, "first")
        cls.steps, (cls.whole,) = calibrate(cls.first, 2)

    def setUp(self):
        """A copy of what the first run left."""
        temporary = tempfile.TemporaryDirectory(prefix="hipmap-test-")
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name, "copy")
        shutil.copytree(self.first, self.folder)
        self.notebook = self.folder / "work/notebook.json"

    def calibrate(self, seeds):
        return calibrate(self.folder, seeds)

    def test_rows_and_document(self):
        # A target of each integrator that shares the reference, the reference, two images.
        self.assertEqual(self.steps[-1], "[5/5]")
        document = (self.folder / "calibration.md").read_text(encoding="utf-8")
        self.assertEqual(document.count(f"| {SCENE} |"), 1)
        found = self.whole
        self.assertLessEqual(found["reference_error"], found["target"] / 100 / runs.BETTER)
        self.assertEqual(len(found["images"]), 2)
        for image in found["images"]:
            self.assertLessEqual(image["error"], found["target"] / 100)
            self.assertGreater(image["true"], 0)
            self.assertGreaterEqual(image["passes"], runs.FIRST_CHECK)

    def lose(self, *names):
        """What a run that was stopped before these would have kept."""
        results = json.loads(self.notebook.read_text())
        results["runs"] = {key: value for key, value in results["runs"].items()
                           if not key.endswith(names)}
        self.notebook.write_text(json.dumps(results))

    def test_a_stopped_run_goes_on_and_finds_the_same(self):
        def told(images):
            return [{key: image[key] for key in image if key != "seconds"} for image in images]
        whole = self.whole
        self.lose("/path/1")
        steps, (found,) = self.calibrate(2)
        self.assertEqual(steps, ["[1/1]"])
        self.assertEqual(told(found["images"]), told(whole["images"]))
        self.assertEqual(found["images"][0], whole["images"][0])
        # A reference whose picture is lost is made again, and one more seed is one more image.
        for picture in (self.folder / "work").glob("*.pfm"):
            picture.unlink()
        steps, (more,) = self.calibrate(3)
        self.assertEqual(steps[-1], "[2/2]")
        self.assertEqual(more["reference_error"], whole["reference_error"])
        self.assertEqual(more["images"][:2], found["images"])

    def test_what_other_programs_found_does_not_count(self):
        results = json.loads(self.notebook.read_text())
        results["about"]["programs"] = "others"
        self.notebook.write_text(json.dumps(results))
        steps, (repeated,) = self.calibrate(2)
        self.assertEqual(steps[-1], "[5/5]")
        self.assertEqual(repeated["images"][0]["true"], self.whole["images"][0]["true"])


class Notebooks(unittest.TestCase):
    def test_a_scene_is_known_by_its_bytes(self):
        with tempfile.NamedTemporaryFile() as file:
            path = pathlib.Path(file.name)
            with unittest.mock.patch.dict(runs.SCENES, {"room": path}):
                path.write_bytes(b"a")
                first = jobs.image_key("room", "path", 0)
                path.write_bytes(b"b")
                self.assertNotEqual(jobs.image_key("room", "path", 0), first)
                path.write_bytes(b"a")
                self.assertEqual(jobs.image_key("room", "path", 0), first)

    def test_no_scene_is_written_to_look_for_what_is_known(self):
        with unittest.mock.patch.object(runs.furnished, "path_of", side_effect=AssertionError), \
                tempfile.TemporaryDirectory() as folder, \
                unittest.mock.patch.object(runs.furnished, "FOLDER", pathlib.Path(folder)):
            self.assertEqual(jobs.cases({}, 1), [])

    def test_a_reference_is_the_same_whichever_integrators_are_asked_for(self):
        self.assertEqual(jobs.sharing("cornell", runs.LONG_PATH), ["progressive", "path"])
        asked = [jobs.stages(None, None, ["cornell"], names, 1) for names in
                 (["path"], ["path", "progressive"])]
        for one, both in zip(*asked[:2]):
            keys = {job.key for job in both}
            self.assertTrue({job.key for job in one} <= keys)
        self.assertEqual(*[[job.key for job in stages[0]] for stages in asked])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
