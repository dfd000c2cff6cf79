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
import measure


def run(tools, folder):
    command = [sys.executable, "-B", SCRIPT, "--quick", "--scenes", "1", "--tools", tools,
               "--to", folder]
    return subprocess.run(command, capture_output=True, text=True, check=False)


class Experiment(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="hipmap-test-")
        self.addCleanup(temporary.cleanup)
        self.folder = temporary.name

    def test_rows_and_tables(self):
        done = run(TOOLS, self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("[20/20]", done.stderr)
        document = pathlib.Path(self.folder, "experiments.md").read_text(encoding="utf-8")
        rows = json.loads(pathlib.Path(self.folder, "experiments.json").read_text())["rows"]
        self.assertEqual([row["emitted"] for row in rows[::4]], [1250, 2500, 7500, 15000, 30000])
        for one, shared, thesis, tiers in zip(*(rows[mode::4] for mode in range(4))):
            self.assertEqual(one["stored"], shared["stored"])
            self.assertEqual(one["stored"], thesis["stored"])
            self.assertEqual(shared["shared_maps"], tiers["shared_maps"])
            self.assertLessEqual(one["shared_maps"], 2)
            self.assertGreater(shared["shared_maps"], 6)
            self.assertEqual(shared["local_maps"], 0)
            self.assertGreater(thesis["local_maps"], 0)
            self.assertEqual(document.count(f"| {one['stored']:,} |"), 5)
        for row in rows:
            self.assertAlmostEqual(row["net_s"], row["image_s"] - row["empty_s"])

    def test_light_primitives_are_glowing_triangles_and_lamps(self):
        counts = [measure.light_primitives(measure.scene_path(scene)) for scene in (1, 2, 3)]
        self.assertEqual(counts, [5, 2, 98])

    def test_missing_tools_and_failing_tools_are_one_line(self):
        failing = os.path.join(self.folder, "failing")
        os.mkdir(failing)
        for name in ("preprocess", "render"):
            path = pathlib.Path(failing, name)
            path.write_text("#!/bin/sh\necho 'error: out of luck' >&2; exit 2\n")
            path.chmod(0o755)
        for tools, naming in ((self.folder, "pipeline.sh"), (failing, "out of luck")):
            done = run(tools, self.folder)
            self.assertEqual(done.returncode, 1)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            self.assertIn(naming, done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
