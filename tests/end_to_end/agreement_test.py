"""experiments/agreement measures what it says, and judges it as it should.

    agreement_test.py ROOT FOLDER_OF_TOOLS
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT, TOOLS = sys.argv[1:3]
FOLDER = os.path.join(ROOT, "experiments/agreement")
sys.path.insert(0, FOLDER)
import report
import runs

OFF = (-2, 1, 0, 1, 1, -1, -1, 1)


def case(factor=1, bias=0, off2=1):
    """Two methods with a noise of some per mille; factor: between their means; off2: between the
    square of their difference and what is stated."""
    def means(scale, shift):
        return [[scale * (1 + 0.001 * OFF[(i + shift) % 8])] * 3 for i in range(8)]
    beside = runs.side_by_side(means(factor, 0), means(1, 3))
    return {"scene": "room", "method": "progressive", "other": "path", "passes": [8, 16],
            "channels": beside, "regions": beside,
            "difference2": [off2 * (1 + 0.1 * x) for x in OFF], "stated2": [1.0] * 8,
            "bias": bias}


class Agreement(unittest.TestCase):
    def test_the_limit_is_that_of_students_distribution(self):
        for chance, freedom, limit in ((0.05, 1, 12.706), (0.05, 7, 2.3646), (0.001, 14, 4.1405)):
            self.assertAlmostEqual(report.student_limit(chance, freedom), limit, places=3)

    def test_what_is_off_is_found(self):
        right = {"means": True, "regions": True, "difference": True}
        self.assertEqual(report.judge(case()), right)
        self.assertEqual(report.judge(case(factor=1.01)),
                         {**right, "means": False, "regions": False})
        self.assertEqual(report.judge(case(factor=1.01, bias=0.01)), right)
        self.assertEqual(report.judge(case(off2=2)), {**right, "difference": False})
        self.assertEqual(report.judge(case(off2=0.5)), right)
        self.assertEqual(report.verdict_on(case(off2=2)), "**difference off**")
        self.assertEqual(report.verdict_on(case(factor=1.01, bias=0.01)), "within the bias")
        self.assertEqual(report.verdict_on(case()), report.AGREE)

    def test_regions_have_their_own_means(self):
        image = (8, [float(x // 2 + 10 * (y // 2)) + c for y in range(8) for x in range(8)
                     for c in range(3)])
        self.assertEqual(runs.block_means(image), [float(x + 10 * y) + c for y in range(4)
                                                   for x in range(4) for c in range(3)])

    def test_lamps_without_size_are_known(self):
        self.assertTrue(runs.has_lamps_without_size("fog"))
        self.assertFalse(runs.has_lamps_without_size("soft_shadows"))
        self.assertFalse(runs.has_lamps_without_size("cornell_diffuse"))

    def test_rows_and_document(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run(
                [sys.executable, "-B", os.path.join(FOLDER, "agree.py"), "--seeds", "3", "--size",
                 "8", "--scenes", "vertex_colours", "--minutes", "0.002", "--tools", TOOLS, "--to",
                 folder], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            document = pathlib.Path(folder, "agreement.md").read_text(encoding="utf-8")
            results = json.loads(pathlib.Path(folder, "agreement.json").read_text())
        self.assertEqual(document.count("| vertex_colours |"), 2)
        found = results["comparisons"][0]
        self.assertEqual((found["method"], found["other"]), ("progressive", "path"))
        self.assertEqual(len(found["regions"]), 3 * runs.BLOCKS ** 2)
        for value, _ in report.channels(found):
            self.assertAlmostEqual(value, 1, delta=0.1)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
