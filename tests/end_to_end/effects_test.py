"""Which effects are rendered, as a user sees it.

    effects_test.py FOLDER_OF_TOOLS SCENE
"""

import json
import sys

from tools import Tools, ToolsTestCase, main

SMALL = ("--size", "24", "--passes", "1", "--photons", "2000")


class Effects(ToolsTestCase):
    def setUp(self):
        super().setUp()
        self.partition = self.write_partition()

    def render(self, *arguments):
        return self.succeed("render", Tools.scene, self.partition, *SMALL, *arguments)

    def statistics(self, *arguments):
        self.render("-o", self.path("image.pfm"), "--stats", self.path("stats.json"), *arguments)
        with open(self.path("stats.json"), encoding="utf-8") as file:
            return json.load(file)

    def test_explain_says_all_and_writes_nothing(self):
        printed = self.render("--explain")
        self.assertIn("caustics: on; specular surfaces send light to others:", printed)
        self.assertIn("sheen: off; no material has one", printed)
        self.assertNotIn("photons:", printed)

    def test_a_run_names_what_is_on(self):
        printed = self.render("-o", self.path("image.pfm"), "--verbose")
        self.assertIn("effects: soft-shadows, indirect, mirror, refraction, caustics (", printed)

    def test_statistics_hold_the_plan(self):
        plan = {effect["name"]: effect for effect in self.statistics()["effects"]}
        self.assertTrue(plan["caustics"]["on"] and plan["caustics"]["cost"])
        self.assertIn("Glass", plan["caustics"]["reason"])
        self.assertFalse(plan["textures"]["on"] or plan["textures"]["cost"])

    def test_what_is_left_out_is_not_traced(self):
        photons = self.statistics("--effects", "-caustics")["photons"]
        self.assertEqual((photons["aimed"], photons["caustic"]["stored"]), (0, 0))
        self.assertGreater(photons["global"]["stored"], 0)
        photons = self.statistics("--effects", "-indirect")["photons"]
        self.assertEqual((photons["emitted"], photons["global"]["stored"]), (0, 0))
        self.assertGreater(photons["caustic"]["stored"], 0)

    def test_a_state_goes_on_with_the_same_effects_only(self):
        state = ("-o", self.path("image.pfm"), "--state", self.path("state"))
        self.render("--effects", "-caustics", *state)
        self.refuse("render", Tools.scene, self.partition, *SMALL, *state, naming="caustics")

    def test_energy_compensation_is_said_and_part_of_a_state(self):
        self.assertFalse(self.statistics()["options"]["energy_compensation"])
        state = ("--state", self.path("state"))
        asked = self.statistics("--energy-compensation", *state)
        self.assertTrue(asked["options"]["energy_compensation"])
        self.refuse("render", Tools.scene, self.partition, *SMALL, "-o", self.path("image.pfm"),
                    *state, naming="the scene and options that it was started with")

    def test_unknown_names_are_refused_with_those_there_are(self):
        self.refuse("render", Tools.scene, self.partition, "--explain", "--effects", "-glow",
                    naming="where NAME is one of indirect, caustics")


if __name__ == "__main__":
    main(sys.argv)
