"""experiments/run_experiment.py measures what it says, in the quick form, on scene 1.

    experiment_test.py ROOT FOLDER_OF_TOOLS
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT, TOOLS = sys.argv[1:3]
SCRIPT = os.path.join(ROOT, "experiments/run_experiment.py")
sys.path.insert(0, os.path.dirname(SCRIPT))
import claims
import measure
import run_experiment


def run(tools, folder):
    command = [sys.executable, "-B", SCRIPT, "--quick", "--scenes", "1", "--tests", "2", "4",
               "--tools", tools, "--to", folder]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def row(mode, net, **others):
    """A row with the net costs of its rounds."""
    return {"scene": 1, "test": 5, "tree": "balanced", "mode": mode, "empty_s": 1.0,
            "image_runs": [1 + cost for cost in net], **others}


class Experiment(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="hipmap-test-")
        self.addCleanup(temporary.cleanup)
        self.folder = temporary.name

    def test_rows_and_document(self):
        done = run(TOOLS, self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("[34/34]", done.stderr)
        document = pathlib.Path(self.folder, "experiments.md").read_text(encoding="utf-8")
        results = json.loads(pathlib.Path(self.folder, "experiments/results.json").read_text())
        rows = results["rows"]
        self.assertEqual(len(rows), 2 * 4 * 3)
        self.assertEqual([row["emitted"] for row in rows[::12]], [2500, 15000])
        for tree in range(0, len(rows), 4):
            one, shared, thesis, tiers = rows[tree:tree + 4]
            self.assertEqual(one["stored"], rows[tree // 12 * 12]["stored"])
            self.assertEqual(one["stored"], shared["stored"])
            self.assertEqual(one["stored"], thesis["stored"])
            self.assertEqual(shared["shared_maps"], tiers["shared_maps"])
            self.assertLessEqual(one["shared_maps"], 2)
            self.assertGreater(shared["shared_maps"], 6)
            self.assertEqual(shared["local_maps"], 0)
            self.assertGreater(thesis["local_maps"], 0)
            self.assertIn(f"| {one['stored']:,} |", document)
        for row_ in rows:
            self.assertAlmostEqual(row_["net_s"], row_["image_s"] - row_["empty_s"])
        self.assertEqual(document.count("| **"), len(claims.judge(rows, results["creases"])))
        for name in results["pictures"].values():
            self.assertIn(f"(experiments/{name})", document)
            self.assertTrue(pathlib.Path(self.folder, "experiments", name).exists())

    def test_a_ratio_is_of_the_fastest_runs_and_spans_the_rounds(self):
        middle, low, high = measure.ratio(row("global", [4, 6]), row("shared", [3, 2]))
        self.assertAlmostEqual(middle, 2)
        self.assertAlmostEqual(low, 4 / 3)
        self.assertAlmostEqual(high, 3)

    def test_a_claim_is_held_on_both_trees_or_only_on_the_weaker_or_not(self):
        def judged(balanced, wide):
            rows = [row("global", [1]), row("shared", [1 / balanced]),
                    row("global", [1], tree="wide"), row("shared", [1 / wide], tree="wide")]
            return claims.far_ahead(rows, [1], "shared")[-1]
        self.assertEqual(judged(2, 2), claims.HELD)
        self.assertEqual(judged(2, 1.2), claims.WEAKER)
        self.assertEqual(judged(1.2, 2), claims.NOT)
        self.assertEqual(claims.far_ahead([row("global", [1])], [1], "shared")[-1], claims.UNKNOWN)

    def test_light_primitives_are_glowing_triangles_and_lamps(self):
        counts = [measure.light_primitives(measure.scene_path(scene)) for scene in (1, 2, 3)]
        self.assertEqual(counts, [5, 2, 98])

    def test_missing_tools_and_failing_tools_are_one_line(self):
        failing = os.path.join(self.folder, "failing")
        os.mkdir(failing)
        for name in run_experiment.PROGRAMS:
            path = pathlib.Path(failing, name)
            path.write_text("#!/bin/sh\necho 'error: out of luck' >&2; exit 2\n")
            path.chmod(0o755)
        for tools, naming in ((self.folder, "cmake --build"), (failing, "out of luck")):
            done = run(tools, self.folder)
            self.assertEqual(done.returncode, 1)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            self.assertIn(naming, done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
