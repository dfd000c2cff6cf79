"""experiments/run_experiment.py measures what it says, in the quick form, on scene 1.

    experiment_test.py ROOT FOLDER_OF_TOOLS
"""

import json
import math
import os
import pathlib
import random
import statistics
import subprocess
import sys
import tempfile
import unittest

ROOT, TOOLS = sys.argv[1:3]
SCRIPT = os.path.join(ROOT, "experiments/run_experiment.py")
sys.path.insert(0, os.path.dirname(SCRIPT))
import claims
import identical
import measure
import ratios
import run_experiment
import tables


def run(tools, folder, *more):
    command = [sys.executable, "-B", SCRIPT, "--quick", "--scenes", "1", "--tests", "2", "4",
               "--tools", tools, "--to", folder, *more]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def row(mode, net, **others):
    """A row with the net costs of its rounds, of a quarter of an image."""
    return {"scene": 1, "test": 5, "tree": "balanced", "mode": mode, **tables.USUAL,
            "share": 0.25, "kinds": {}, "empty_runs": [1.0] * len(net),
            "image_runs": [1 + cost / 4 for cost in net], **others}


def rows_of(costs, above="global", below="shared"):
    """Rows of test 5 on both kinds of trees; costs: {tree: (of above, of below)}."""
    return [row(mode, net, tree=tree) for tree, both in costs.items()
            for mode, net in zip((above, below), both)]


class Experiment(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="hipmap-test-")
        self.addCleanup(temporary.cleanup)
        self.folder = temporary.name

    def test_rows_and_document(self):
        done = run(TOOLS, self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("[6/6]", done.stderr)
        document = pathlib.Path(self.folder, "experiments.md").read_text(encoding="utf-8")
        results = json.loads(pathlib.Path(self.folder, "experiments/results.json").read_text())
        rows = [row_ for row_ in tables.usual(results["rows"]) if row_["tree"] in measure.TREES]
        self.assertEqual(len(rows), 2 * 4 * 3)
        self.check_rows(rows, document)
        for rebuilt in results["rebuilds"]:
            self.assertLess(rebuilt["median"], rebuilt["largest"])
            self.assertLess(rebuilt["largest"], rebuilt["photons"])
        self.assertEqual({rebuilt["tree"] for rebuilt in results["rebuilds"]},
                         {*measure.TREES, "midpoint"})
        self.assertEqual(document.count("| **"), len(claims.judge(results)))
        for name in results["pictures"].values():
            self.assertIn(f"(experiments/{name})", document)
            self.assertTrue(pathlib.Path(self.folder, "experiments", name).exists())
        self.check_that_it_goes_on(document)

    def check_rows(self, rows, document):
        self.assertEqual([row["emitted"] for row in rows[::12]], [2500, 15000])
        for tree in range(0, len(rows), 4):
            one, shared, thesis, tiers = rows[tree:tree + 4]
            self.assertEqual({row_["stored"] for row_ in rows[tree // 12 * 12:][:12]},
                             {one["stored"]})
            counts = [[measure.maps(row_, "global", level) for level in measure.LEVELS[:2]]
                      for row_ in (one, shared, thesis, tiers)]
            self.assertEqual(counts[1][0], counts[3][0])
            self.assertEqual(counts[0][0], 1)
            self.assertGreater(counts[1][0], 6)
            self.assertEqual(counts[1][1], 0)
            self.assertGreater(counts[2][1], 0)
            self.assertIn(f"| {one['stored']:,} |", document)
        for row_ in rows:
            self.assertAlmostEqual(row_["net_s"], row_["image_s"] - row_["empty_s"])

    def check_that_it_goes_on(self, document):
        """What was measured is not measured again, and without a result the document says so."""
        again = run(TOOLS, self.folder)
        self.assertNotIn("[1/", again.stderr)
        work = pathlib.Path(self.folder, "work/measured.json")
        kept = json.loads(work.read_text())
        del kept["runs"]["costs of scene 1, test 4"]
        work.write_text(json.dumps(kept))
        self.assertEqual(run(TOOLS, self.folder, "--so-far").returncode, 0)
        partial = pathlib.Path(self.folder, "experiments.md").read_text(encoding="utf-8")
        self.assertIn("costs of scene 1, test 4", partial)
        self.assertNotIn("Not all of it", document)
        self.assertIn("[1/1] costs of scene 1, test 4", run(TOOLS, self.folder).stderr)

    def test_photons_and_maps_are_those_that_render_has(self):
        scene, tools = measure.scene_path(1), pathlib.Path(TOOLS)
        bench = measure.Bench(tools, pathlib.Path(self.folder), size=64, most_rounds=1, divide=10)
        found, = measure.measure(bench, 1, 2, [measure.Setting("thesis", "balanced")])
        measure.make_partition(bench, 1)
        stats = bench.folder / "stats.json"
        measure.run_tool(
            bench, "render", scene, measure.partition_path(bench, 1), "-o", bench.folder / "i.pfm",
            "--stats", stats, "--maps", "thesis", "--tree", "balanced", "--estimate", "thesis",
            "--photons", found["emitted"], "--neighbours", found["k"], "--local-min", 10 * found["k"],
            "--integrator", "direct", "--direct", "photons", "--look", "gltf", "--passes", 1,
            "--samples", 1, "--size", 64)
        photons = json.loads(stats.read_text())["photons"]
        self.assertEqual(found["stored"], photons["stored"])
        self.assertEqual(found["aimed"], photons["aimed"])
        for kind in ("caustic", "global"):
            for level in measure.LEVELS:
                self.assertEqual(measure.maps(found, kind, level), photons[kind][level])

    def test_caustic_photons_together_are_in_the_maps_of_the_others(self):
        bench = measure.Bench(pathlib.Path(TOOLS), pathlib.Path(self.folder), size=32, most_rounds=1,
                              divide=50)
        apart, together = measure.measure(bench, 1, 2, [
            measure.Setting("shared", "wide"), measure.Setting("shared", "wide", together=True)])
        self.assertGreater(apart["kinds"]["caustic"]["stored"], 0)
        self.assertEqual(together["kinds"]["caustic"]["stored"], 0)
        self.assertEqual(apart["stored"], together["kinds"]["global"]["stored"])
        self.assertEqual(len(apart["errors"]), 2)

    def test_a_ratio_is_the_mean_of_the_rounds_with_its_interval(self):
        found = measure.ratio(row("global", [4, 6, 5]), row("shared", [2, 3, 5]))
        logs = [math.log(2), math.log(2), 0]
        self.assertAlmostEqual(found.log, 2 * math.log(2) / 3)
        self.assertAlmostEqual(found.error, statistics.stdev(logs) / math.sqrt(3))
        low, high = found.bounds()  # Student's limit of two degrees of freedom
        self.assertAlmostEqual(math.log(high / low) / 2, 4.3027 * found.error, places=3)
        self.assertAlmostEqual(measure.net_runs(row("global", [4]))[0], 4)
        self.assertEqual(ratios.written(measure.ratio(row("global", [4]), row("shared", [2]))),
                         "2.00 (one round)")
        self.assertEqual(ratios.written(measure.ratio(row("global", [4, -1]),
                                                      row("shared", [2, 2]))), "lost in noise")

    def test_intervals_hold_the_true_ratio_as_often_as_they_say(self):
        draw = random.Random(3)

        def runs(mean):
            return [mean * math.exp(draw.gauss(0, 0.1)) for _ in range(5)]
        found = [ratios.of_rounds(runs(3), runs(2)).bounds() for _ in range(2000)]
        held = sum(low <= 1.5 <= high for low, high in found) / len(found)
        self.assertAlmostEqual(held, 0.95, delta=0.015)

    def test_a_verdict_has_four_values(self):
        def judged(balanced, wide):
            rows = rows_of({tree: ([ratio * 0.99, ratio, ratio * 1.01], [1, 1, 1])
                            for tree, ratio in (("balanced", balanced), ("wide", wide))})
            shown = [claims.far_ahead(rows, 1, "shared", "").shown(tree)
                     for tree in ("balanced", "wide")]
            return claims.verdict(*shown)
        self.assertEqual(judged(2, 2), claims.HELD)
        self.assertEqual(judged(2, 1.2), claims.THEN)
        self.assertEqual(judged(2, 1.5), claims.THEN)
        self.assertEqual(judged(1.2, 2), claims.REFUTED)
        self.assertEqual(judged(1.5, 2), claims.UNDECIDED)
        self.assertIsNone(claims.far_ahead([row("global", [1])], 1, "shared", "").shown("wide"))
        self.assertEqual(claims.verdict(None, None), claims.UNKNOWN)

    def test_a_claim_that_one_loses_holds_below_its_threshold(self):
        rows = rows_of({"balanced": ([0.9, 0.91, 0.89], [1, 1, 1])}, "shared", "thesis")
        lost = claims.local_maps(rows, (1, 5), ("lose", "", 1, True))
        self.assertTrue(lost.shown("balanced").holds)
        self.assertFalse(claims.local_maps(rows, (1, 5), ("gain", "", 1, False))
                         .shown("balanced").holds)

    def test_claims_are_judged_on_the_scenes_they_were_made_for(self):
        rows = rows_of({"balanced": ([2, 2], [1, 1]), "wide": ([2, 2], [1, 1])})
        judged = claims.judge({"rows": rows, "creases": []})
        made_for = [line[1] for line in judged if "far ahead" in line[0]]
        self.assertEqual(made_for, ["1", "2", "1", "2"])
        self.assertNotIn("-", [line[2] for line in judged if line[1] != "-"])

    def test_identical_computations_that_differ_are_found(self):
        def found(thesis, **kinds):
            rows = [row("shared", [1.0, 1.01, 0.99, 1.0]), row("thesis", thesis, **kinds)]
            return identical.complaints({"rows": rows})
        slower = [1.2, 1.21, 1.19, 1.2]
        self.assertEqual(found([1.01, 1.0, 1.0, 0.99]), [])
        self.assertEqual(len(found(slower)), 1)
        self.assertIn("shared and thesis", found(slower)[0])
        used = {"kinds": {"global": {"local_maps": 3}}}
        self.assertIn("no identical", found(slower, **used)[0])

    def test_a_leak_is_judged_by_its_interval(self):
        def verdict(split, error):
            crease = {"dark global": "0.25", "dark global error": "0.001", "dark shared": str(split),
                      "dark shared error": str(error)}
            return claims.leaks([crease])[2]
        self.assertEqual(verdict(0, 0), claims.HELD)
        self.assertEqual(verdict(0.2, 0.001), claims.REFUTED)
        self.assertEqual(verdict(0.002, 0.001), claims.UNDECIDED)
        self.assertEqual(claims.leaks([])[2], claims.UNKNOWN)

    def test_a_run_ends_when_its_ratios_are_precise(self):
        def is_precise(*nets):
            return measure.is_precise([row("shared", net) for net in nets])
        self.assertTrue(is_precise([1, 1.01, 0.99], [2, 2.02, 2.0]))
        self.assertFalse(is_precise([1, 1.1, 0.9], [2, 2, 2]))
        self.assertFalse(is_precise([1], [2]))

    def test_light_primitives_are_glowing_triangles_and_lamps(self):
        counts = [measure.light_primitives(measure.scene_path(scene)) for scene in measure.SCENES]
        self.assertEqual(counts, [5, 2, 98, 98])

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
