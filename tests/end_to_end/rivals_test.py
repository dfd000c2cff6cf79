"""experiments/rivals measures what it says, judges it by its rules, and docs/rivals.md is what it wrote.

    rivals_test.py ROOT FOLDER_OF_TOOLS
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT, TOOLS = sys.argv[1:3]
sys.path.insert(0, os.path.join(ROOT, "experiments/rivals"))
import rival_findings as findings
import rival_plan as plan
import rival_report as report

CORNELL = plan.SCENES["cornell"]
ERRORS = {plan.DIRECT: 0.1, plan.OF_ITS_TIME: 0.3, plan.PROGRESSIVE: 0.05, plan.PATH: 0.4,
          plan.PATH_EFFECTS: 0.1, plan.RADIOSITY: 0.2, plan.MAP: 0.05, plan.CACHE: 0.02,
          plan.BOTH_WAYS: 0.5, plan.FIELD: 0.1}


def made_up(errors=None, spread=0.01):
    """Results of one scene: every method has its error at all points, and its seeds about that."""
    errors = {**ERRORS, **(errors or {})}
    runs = {f"noise/cornell/{kind}": 1e-6 for kind in plan.KINDS}
    for name, method in plan.METHODS.items():
        for point in range(method.count()):
            for seed in range(3):
                error2 = (errors[name] * (1 + spread * (seed - 1))) ** 2
                runs[f"image/cornell/{name}/{point}/{seed}"] = {
                    "prepared": 1, "rendered": 4 ** point, "stored": 2 ** 20, "peak": 2 ** 25,
                    "errors2": {kind: error2 * (4 if kind == plan.WHOLE else 1)
                                for kind in method.against}}
    return {"about": {"study": {"seeds": 3, "width": 8, "photons": 1000}, "machine": "none"}, "date": "today",
            "runs": runs}


def claim(words):
    return next(one for one in findings.CLAIMS if words in one.text)


class Findings(unittest.TestCase):
    def test_errors_are_interpolated_in_logarithms_and_never_extrapolated(self):
        points = [(1, 0.4), (4, 0.2), (16, 0.3)]
        self.assertAlmostEqual(findings.after(points, 2), 0.4 / 2 ** 0.5)
        self.assertEqual(findings.after(points, 0.1), 0.4)
        self.assertEqual(findings.after(points, 100), 0.2)

    def test_claims_are_judged_by_rule(self):
        def word(words, errors=None, spread=0.01):
            return findings.verdict(claim(words), made_up(errors, spread), CORNELL)[2]
        self.assertEqual(word("`bidirectional` / `direct`"), "held")
        self.assertEqual(word("`radiosity` / `direct`"), "refuted")  # on trees of its time
        self.assertEqual(word("`radiosity` / `direct`", {plan.OF_ITS_TIME: 0.1}), "held")
        self.assertEqual(word("`radiosity` / `direct`",
                              {plan.OF_ITS_TIME: 0.1, plan.DIRECT: 0.3}), "held on trees of its time")
        self.assertEqual(word("Irradiance caching"), "held")
        self.assertEqual(word("Irradiance caching", {plan.CACHE: 0.2}), "refuted")
        self.assertEqual(word("Irradiance caching", {plan.CACHE: 0.1}), "undecided")

    def test_what_was_not_measured_is_said_so(self):
        results = made_up()
        results["runs"] = {key: run for key, run in results["runs"].items() if plan.CACHE not in key}
        self.assertEqual(findings.verdict(claim("Irradiance caching"), results, CORNELL)[2],
                         "not measured")


class Document(unittest.TestCase):
    def test_parts_are_filled_in_and_words_stay(self):
        parts = "".join(f"words\n<!-- {name} -->\nold\n<!-- end -->\n" for name in report.PARTS)
        text = report.write(parts, made_up(), {})
        self.assertNotIn("old", text)
        self.assertEqual(text.count("words\n"), len(report.PARTS))
        self.assertIn("**held**", text)
        with self.assertRaises(ValueError):
            report.write(parts.replace("<!-- claims -->", ""), made_up(), {})

    def test_the_document_is_what_the_results_say(self):
        folder = pathlib.Path(ROOT, "docs")
        results = json.loads((folder / "rivals/results.json").read_text())
        drawn = {name: f"rivals/{name}.png" for name in ("curves", "images")
                 if (folder / f"rivals/{name}.png").exists()}
        text = (folder / "rivals.md").read_text(encoding="utf-8")
        self.assertEqual(report.write(text, results, drawn), text)


class Program(unittest.TestCase):
    def render(self, *options):
        return subprocess.run([os.path.join(TOOLS, "rivals"), CORNELL.path, "--size", "8", "--samples",
                               "1", *options], capture_output=True, text=True, check=False)

    def test_every_method_renders_and_says_what_it_took(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in plan.RIVALS:
                image = pathlib.Path(folder, f"{name}.pfm")
                done = self.render("--method", name, "--cells", "100", "--rays", "1000", "--directions",
                                   "16", "--views", "2", "-o", image)
                self.assertEqual((done.returncode, done.stderr), (0, ""), name)
                self.assertLess({"prepared_s", "rendered_s"}, json.loads(done.stdout).keys())
                self.assertGreater(image.stat().st_size, 8 * 8 * 12)

    def test_an_unknown_method_is_refused_with_the_names(self):
        done = self.render("--method", "metropolis", "-o", "/dev/null")
        self.assertEqual(done.returncode, 2)
        self.assertIn("illumination-map", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
