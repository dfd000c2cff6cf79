"""What --quote promises: costs of errors, of other integrators and of effects, in little time.

    quote_test.py FOLDER_OF_TOOLS SCENE
"""

import json
import os
import re
import sys

import tools
from pictures import read_pfm
from tools import Tools, ToolsTestCase

SIZE = 32
PHOTONS = 6000
MOST_PRACTICAL_SECONDS = 24 * 3600  # of render/describe_error.h
ROW = re.compile(r"^(--\S+(?: \w+)?): (.*)$", re.M)


class Quote(ToolsTestCase):
    long_quote = None

    def setUp(self):
        super().setUp()
        self.write_partition()

    def render(self, *options):
        return self.succeed("render", Tools.scene, self.path("scene.hpm"), "--size", SIZE, "--photons", PHOTONS,
                            *options)

    def quote(self, *options):
        said = self.render("--quote", "--stats", self.path("quote.json"), *options)
        with open(self.path("quote.json"), encoding="utf-8") as file:
            return said, json.load(file)

    def quote_with_time(self):
        """The words and statistics of a quote with time for all comparisons, made once."""
        if Quote.long_quote is None:
            Quote.long_quote = self.quote("--error", "0.2%")
        return Quote.long_quote

    def look_into_effect(self, text, row):
        """Seconds are named up to a day of them; slow builds need more."""
        if abs(row["seconds_saved"]) <= MOST_PRACTICAL_SECONDS:
            self.assertRegex(text, r"(saves|takes) .* on the way to 0\.2 % error, and adds about \d+ % error")
        else:
            self.assertRegex(text, r"(saves|takes) .* pass, and adds about \d+ % error")

    def image(self, name, *options):
        self.render("-o", self.path(name), *options)
        return [channel for pixel in read_pfm(self.path(name)).pixels() for channel in pixel]

    def test_integrators_and_effects_are_compared_where_there_is_time(self):
        said, stats = self.quote_with_time()
        quote = stats["quote"]
        rows = dict(ROW.findall(said))
        self.assertRegex(rows["--integrator path"], r"^0\.2 % error would take about [\d,]+ passes, ")
        self.assertIn(" error of noise alone ", rows["--integrator direct"])
        self.look_into_effect(rows["--effects=-caustics"], next(
            row for row in quote["effects"] if row["option"] == "--effects=-caustics"))
        self.assertEqual(quote["not_compared"], [])
        self.assertEqual(set(rows), {row["option"] for row in quote["integrators"] + quote["effects"]})
        self.assertIn("30 % error would take about ", said)
        predicted = next(price for price in stats["error"]["prices"] if price["error"] == 0.002)
        spent = quote["seconds"] + stats["error"]["checks"][-1]["seconds"]
        self.assertLess(spent, 0.05 * predicted["seconds"])

    def test_path_is_not_compared_where_it_cannot_find_a_light_and_says_so(self):
        scene, partition = os.path.join(os.path.dirname(Tools.scene), "effects/dispersion.glb"), self.path("spot.hpm")
        self.succeed("preprocess", scene, "-o", partition)
        small = ("render", scene, partition, "--size", 16, "--photons", 2000, "-o", self.path("a.pfm"))
        self.assertIn("may lack the light of spot light 'Spot' off mirrors",
                      self.succeed(*small, "--integrator", "path", "--passes", 2))
        said = self.succeed(*small, "--quote", "--error", "0.2%")
        self.assertIn("--integrator direct: ", said)
        self.assertNotIn("--integrator path", said)
        self.assertNotIn("may lack the light of", said + self.succeed(*small, "--integrator", "path", "--passes", 2,
                                                                    "--effects=-caustics"))

    def test_what_there_is_no_time_for_is_named(self):
        said, stats = self.quote("--error", "30%")
        self.assertEqual(stats["passes_done"], 2)
        self.assertEqual(stats["quote"]["seconds"], 0)
        self.assertRegex(said, r"not compared, for lack of time: --integrator direct, .*--effects=-caustics")

    def test_the_error_that_an_effect_adds_is_that_of_the_images(self):
        _, stats = self.quote_with_time()
        whole = self.image("whole.pfm", "--passes", 24)
        dark = 0.1 * sum(whole) / len(whole)
        for row in stats["quote"]["effects"]:
            if row["option"] not in ("--effects=-caustics", "--effects=-indirect"):
                continue
            with self.subTest(option=row["option"]):
                other = self.image("without.pfm", "--passes", 24, row["option"])
                true = sum((a - b) ** 2 / (a * a + dark * dark) for a, b in zip(whole, other)) / len(whole)
                self.assertLess(abs(row["error2_added"] ** 0.5 / true ** 0.5 - 1), 0.25)

    def test_passes_of_a_quote_are_those_of_the_render(self):
        _, stats = self.quote("--error", "20%", "--state", self.path("a.state"))
        passes = stats["passes_done"]
        self.render("-o", self.path("resumed.pfm"), "--passes", 8, "--state", self.path("a.state"))
        self.render("-o", self.path("whole.pfm"), "--passes", 8)
        self.assertLess(passes, 8)
        self.same("resumed.pfm", "whole.pfm")


if __name__ == "__main__":
    sys.exit(tools.main(sys.argv))
