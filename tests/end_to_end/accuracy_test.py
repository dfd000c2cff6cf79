"""experiments/accuracy measures what it says, and judges it by its marks.

    accuracy_test.py ROOT FOLDER_OF_TOOLS
"""

import json
import math
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import unittest

ROOT, TOOLS = sys.argv[1:3]
FOLDER = os.path.join(ROOT, "experiments/accuracy")
sys.path.insert(0, FOLDER)
import arithmetic
import findings
import lab
import plan
import plots

# A law of 0.4/sqrt(t), and what stays at a bias.
CURVE = [(t, 0.4 / math.sqrt(t), 0.0, t) for t in (1, 4, 16)]
FLAT = [(1, 0.4, 0.0, 1), (4, 0.3, 0.0, 4), (16, 0.3, 0.0, 16)]


class Errors(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="hipmap-test-")
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def test_relative_mse_is_that_of_its_definition_and_of_compare_images(self):
        image, truth = (1, [1.0, 2.0, 3.0]), (1, [1.0, 1.0, 4.0])
        for constant, c in ((None, 0.2 ** 2), (0.5, 0.5)):
            by_hand = (0 / (1 + c) + 1 / (1 + c) + 1 / (16 + c)) / 3
            found = arithmetic.relative_mse(image, [truth, truth], constant)
            self.assertAlmostEqual(found, by_hand)
        self.assertEqual(arithmetic.noise_of([truth, truth]), 0)
        paths = []
        for seed in (0, 1):
            numbers = random.Random(seed)
            paths.append(self.folder / f"{seed}.pfm")
            values = arithmetic.array.array("f", [numbers.random() for _ in range(3 * 4 * 2)])
            paths[-1].write_bytes(b"PF\n4 2\n-1.0\n" + values.tobytes())
        said = subprocess.run([os.path.join(TOOLS, "compare_images"), *paths], text=True,
                              capture_output=True, check=True).stdout
        image, truth = map(arithmetic.read_pfm, paths)
        self.assertEqual(f"{arithmetic.relative_mse(image, [truth, truth]):.4g}",
                         said.split()[-1])

    def test_the_noise_of_the_halves_of_a_reference_averages_out(self):
        numbers = random.Random(7)
        pixels = 20_000
        truth = [1 + numbers.random() for _ in range(3 * pixels)]
        def noisy(deviation):
            return pixels, [x + numbers.gauss(0, deviation) for x in truth]
        image, halves = noisy(0.05), [noisy(0.1), noisy(0.1)]
        exact = arithmetic.relative_mse(image, [(pixels, truth)] * 2)
        found = arithmetic.relative_mse(image, halves)
        # Of a channel a·b - a·x - b·x, of variances 1e-4, 25e-6 and 25e-6, by a weight below 1.
        deviation = math.sqrt((1e-4 + 2 * 25e-6) / (3 * pixels))
        self.assertLess(abs(found - exact), 5 * deviation)
        # Against one half alone its noise, of four times the image's own, counts as error.
        self.assertGreater(arithmetic.relative_mse(image, halves[:1] * 2), 3 * exact)
        spread = arithmetic.noise_of(halves) / (exact * 2)  # 0.1²/2 against 0.05²
        self.assertAlmostEqual(spread, 1, delta=0.05)

    def test_half_an_image_is_filtered_as_the_whole_is(self):
        def weight(distance):  # quadratic B-spline
            x = abs(distance)
            return 0.75 - x * x if x <= 0.5 else (1.5 - x) ** 2 / 2 if x <= 1.5 else 0

        def image_of(size, sample):
            """Of one sample, 1 in all channels, at a place in units of the image."""
            across, down = ([weight(size * at - 0.5 - i) for i in range(size)] for at in sample)
            return (size, [x * y for y in down for x in across for _ in range(3)])

        places = random.Random(3)
        for _ in range(20):
            sample = [places.uniform(0.4, 0.6) for _ in range(2)]
            width, numbers = arithmetic.halved(image_of(12, sample))
            self.assertEqual(width, 6)
            for found, wanted in zip(numbers, image_of(6, sample)[1], strict=True):
                self.assertAlmostEqual(4 * found, wanted)  # as a sample fills a quarter of a pixel

    def test_half_of_an_even_image_is_even(self):
        width, numbers = arithmetic.halved((4, [2.0] * 24))
        self.assertEqual(width, 2)
        for number in numbers:
            self.assertAlmostEqual(number, 2)


class Curves(unittest.TestCase):
    def test_a_power_law_is_read_off_exactly(self):
        for seconds in (1, 2, 7.5, 16):
            error = 0.4 / math.sqrt(seconds)
            self.assertAlmostEqual(arithmetic.seconds_to(CURVE, error), seconds)
            self.assertAlmostEqual(arithmetic.error_after(CURVE, seconds), error)
        self.assertAlmostEqual(arithmetic.error_after(CURVE, 20), 0.4 / math.sqrt(20))

    def test_what_was_not_measured_is_not_known(self):
        self.assertIsNone(arithmetic.seconds_to(CURVE, 0.099))
        self.assertIsNone(arithmetic.seconds_to(FLAT, 0.29))
        self.assertIsNone(arithmetic.seconds_to([], 0.5))
        self.assertIsNone(arithmetic.error_after(CURVE, 20.1))
        self.assertIsNone(arithmetic.error_after(CURVE, 0.9))
        self.assertEqual(arithmetic.seconds_to(CURVE, 0.9), 1)

    def test_a_curve_is_the_mean_of_squares_with_its_standard_error(self):
        runs = [[[1, 1.0, 7, 0.04], [3, 2.0, 7, -1e-3]], [[1, 3.0, 7, 0.12], [3, 4.0, 7, 5e-4]]]
        (seconds, error, spread, passes), = arithmetic.mean_curve(runs, 3)
        self.assertEqual((seconds, passes), (2, 1))
        self.assertAlmostEqual(error, math.sqrt(0.08))
        self.assertAlmostEqual(spread, 0.04 / (2 * math.sqrt(0.08)))

    def test_a_schedule_spends_its_seconds_at_even_steps(self):
        passes = lab.schedule(0.5, 0.25, 30)
        self.assertEqual(passes[0], 1)
        steps = [late / early for early, late in zip(passes, passes[1:])]
        self.assertTrue(all(2 <= step <= 4 for step in steps), passes)
        self.assertEqual(passes[-1], 120)
        self.assertEqual(lab.schedule(5, 5, 1), [1])

    def test_a_schedule_has_few_points_where_each_starts_anew_for_long(self):
        self.assertEqual(lab.schedule(3, 0.25, 3.2), [1, 12])
        self.assertEqual(lab.schedule(1, 0.25, 3.2), [1, 3, 12])


class Plots(unittest.TestCase):
    def test_each_curve_has_a_style_of_its_own(self):
        for names in plots.PLOTS.values():
            styles = [plots.STYLES[name] for name in names]
            self.assertEqual(len(set(styles)), len(styles))


class Marks(unittest.TestCase):
    def test_ratio_to_path(self):
        found = {"a": CURVE, "path": [(4 * t, error, 0, n) for t, error, _, n in CURVE]}
        self.assertEqual(findings.against_path(found, "a", 0.2), (4, 16, 0.25, False))
        self.assertIsNone(findings.against_path(found, "a", 0.05))
        found["path"] = FLAT
        self.assertEqual(findings.against_path(found, "a", 0.2), (4, None, 0.25, True))
        self.assertTrue(findings.begins_better(found, "a", 0.5))
        self.assertFalse(findings.begins_better(found, "a", 0.3))
        self.assertFalse(findings.begins_better(found, "b", 0.5))

    def test_marks_are_stricter_where_there_are_caustics(self):
        caustic, diffuse = plan.SCENES["glass_globe"], plan.SCENES["cornell_diffuse"]
        self.assertIs(findings.keeps_mark(caustic, 1.2, False), False)
        self.assertIs(findings.keeps_mark(caustic, 0.9, True), True)
        self.assertIsNone(findings.keeps_mark(caustic, 1.2, True))
        self.assertIs(findings.keeps_mark(diffuse, 1.2, False), True)
        self.assertIs(findings.keeps_mark(diffuse, 1.6, False), False)

    def test_a_quote_is_kept_if_passes_and_error_are_near_it(self):
        quote = {"met": True, "error": 0.1, "error2": 0.12 ** 2, "promised_passes": (20, 20),
                 "passes": 23}
        self.assertTrue(findings.kept(quote))
        self.assertFalse(findings.kept({**quote, "met": False}))
        self.assertFalse(findings.kept({**quote, "passes": 32}))
        self.assertTrue(findings.kept({**quote, "promised_passes": (20, 32), "passes": 45}))
        self.assertFalse(findings.kept({**quote, "promised_passes": (32, 45), "passes": 20}))
        self.assertFalse(findings.kept({**quote, "passes": 11}))
        self.assertFalse(findings.kept({**quote, "error2": 0.16 ** 2}))

    def test_the_regret_of_the_defaults_is_the_time_to_the_best_error(self):
        found = {name: CURVE for name in plan.GRID}
        self.assertEqual(findings.regret(found, 4), (1, plan.BASE))
        # A fifth more error all along takes 1.44 times as long.
        found[plan.BASE] = [(t, 1.2 * e, 0.0, n) for t, e, _, n in CURVE]
        times, best = findings.regret(found, 4)
        self.assertAlmostEqual(times, 1.44)
        self.assertEqual(best, plan.GRID[1])
        self.assertEqual(findings.regret(found, 16)[0], None)  # later than it was measured
        self.assertIsNone(findings.regret({**found, plan.GRID[1]: []}, 4))

    def test_the_advice_for_all_scenes_loses_least_where_it_loses_most(self):
        def runs(curve):
            return [[n, t, error ** 2] for t, error, _, n in curve]
        fast, slow = CURVE, [(3 * t, *rest) for t, *rest in CURVE]
        slower = [(2 * t, *rest) for t, *rest in CURVE]
        by = {"cornell": (fast, slower, FLAT), "glass_globe": (slow, slower, fast)}
        names = [plan.BASE, plan.DEFAULT, plan.PATH]
        results = {"runs": {f"noise/{scene}": {} for scene in by}}
        for scene, given in by.items():
            for name, curve in zip(names, given):
                results["runs"][f"image/{scene}/{name}/0"] = runs(curve)
        name, worst, taken = findings.recommended(results, names, 0.15)
        self.assertEqual(name, plan.DEFAULT)
        self.assertAlmostEqual(worst, 2)
        self.assertEqual(len(taken), 2)
        self.assertIsNone(findings.recommended(results, names, 0.01))


class Command(unittest.TestCase):
    def measure(self, folder, *options):
        done = subprocess.run(
            [sys.executable, "-B", os.path.join(FOLDER, "measure_accuracy.py"), "--quick",
             "--scenes", "cornell_diffuse", "--tools", TOOLS, "--to", folder, "--work",
             os.path.join(folder, "work"), *options], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stderr

    def test_results_and_document_and_going_on(self):
        with tempfile.TemporaryDirectory() as folder:
            said = self.measure(folder)
            document = pathlib.Path(folder, "accuracy.md").read_text(encoding="utf-8")
            file = pathlib.Path(folder, "accuracy/results.json")
            results = json.loads(file.read_text())
            jobs = len(results["runs"])
            self.assertIn(f"[{jobs}/{jobs}]", said)
            kept = pathlib.Path(folder, "work/results.json")
            shorter = json.loads(kept.read_text())
            del shorter["runs"]["image/cornell_diffuse/path/1"]
            kept.write_text(json.dumps(shorter))
            self.assertEqual(re.findall(r"^\[.*\]", self.measure(folder), re.M), ["[1/1]"])
            again = json.loads(file.read_text())
        scene = plan.SCENES["cornell_diffuse"]
        for setting in plan.SETTINGS.values():
            runs = findings.runs(results, "image", scene, setting)
            self.assertEqual(len(runs), plan.QUICK.seeds)
            self.assertEqual(*[[passes for passes, *_ in run] for run in runs])
            self.assertEqual(document.count(f"| cornell_diffuse | {setting.name} | "),
                             2 if setting.name in plan.MINUTE_SETTINGS else 1)
        # The image by the same seed and passes has the same bits, whenever it is rendered.
        key = "image/cornell_diffuse/path/1"
        self.assertEqual([point[2] for point in again["runs"][key]],
                         [point[2] for point in results["runs"][key]])
        self.assertEqual(document.count("verdict"), 2)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
