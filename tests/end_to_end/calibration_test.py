"""experiments/calibration counts what it says, and judges it as it should.

    calibration_test.py ROOT FOLDER_OF_TOOLS
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT, TOOLS = sys.argv[1:3]
FOLDER = os.path.join(ROOT, "experiments/calibration")
sys.path.insert(0, FOLDER)
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

    def test_rows_and_document(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run(
                [sys.executable, "-B", os.path.join(FOLDER, "calibrate.py"), "--seeds", "2",
                 "--size", "8", "--scenes", "hexagonal", "--integrators", "direct", "--tools",
                 TOOLS, "--to", folder], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("[3/3]", done.stderr)
            document = pathlib.Path(folder, "calibration.md").read_text(encoding="utf-8")
            results = json.loads(pathlib.Path(folder, "calibration.json").read_text())
        self.assertEqual(document.count("| hexagonal |"), 1)
        found = results["cases"][0]
        self.assertLessEqual(found["reference_error"], found["target"] / 100 / runs.BETTER)
        self.assertEqual(len(found["images"]), 2)
        for image in found["images"]:
            self.assertLessEqual(image["error"], found["target"] / 100)
            self.assertGreater(image["true"], 0)
            self.assertGreaterEqual(image["passes"], runs.FIRST_CHECK)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
