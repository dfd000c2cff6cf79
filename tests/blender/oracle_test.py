"""The add-on's export beside that of Blender's own exporter: the same triangles, materials, lights.

    oracle_test.py FOLDER_OF_TOOLS
"""

import json
import os
import re
import sys

import inside_blender
from glb_content import Glb
from inside_blender import BLENDER_FOLDER, HERE, BlenderTestCase

SCENES = ("modifiers", "instances", "lights", "text", "glass")


class Oracle(BlenderTestCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        this = cls()
        this.blender("--python", os.path.join(HERE, "f12_scenes.py"), "--", cls.folder)
        cls.ours, cls.stock, cls.said = {}, {}, {}
        for name in SCENES:
            files = this.path(name + ".glb"), this.path(name + "_stock.glb")
            said = this.blender(this.path(name + ".blend"), "--python",
                                os.path.join(HERE, "oracle_inside.py"), "--", BLENDER_FOLDER,
                                *files)
            cls.said[name] = json.loads(re.search(r"^exported: (.*)$", said, re.MULTILINE)[1])
            cls.ours[name], cls.stock[name] = map(Glb, files)

    def same_triangles(self, name, but=()):
        ours, stock = ([t for t in glb[name].triangles() if t[0] not in but]
                       for glb in (self.ours, self.stock))
        self.assertGreater(len(stock), 10)
        self.assertEqual(ours, stock)
        print(f"{name}: {len(ours)} triangles are the same")

    def test_modifiers_and_twins_have_the_same_triangles(self):
        self.same_triangles("modifiers")

    def test_text_and_curves_have_the_same_triangles(self):
        # The exporter leaves metaballs out.
        self.same_triangles("text", but={"no material"})
        self.assertGreater(len(self.ours["text"].triangles()),
                           len(self.stock["text"].triangles()))

    def test_other_scenes_have_the_same_triangles(self):
        self.same_triangles("lights")
        self.same_triangles("glass")

    def test_instances_of_geometry_nodes_are_there_too(self):
        stone = [t for t in self.ours["instances"].triangles() if t[0] == "Stone"]
        by_exporter = [t for t in self.stock["instances"].triangles() if t[0] == "Stone"]
        self.assertEqual(len(by_exporter), (6 + 1) * 20)  # not of geometry nodes
        self.assertEqual(len(stone), (6 + 1 + 4) * 20)
        self.assertLessEqual(set(by_exporter), set(stone))

    def test_instances_share_their_mesh(self):
        nodes = [node for node in self.ours["instances"].json["nodes"] if "mesh" in node]
        self.assertEqual(len(nodes), 6 + 1 + 4 + 2 + 2)
        self.assertLessEqual(len(self.ours["instances"].json["meshes"]), 4)

    def test_lights_are_the_same(self):
        for name in ("lights", "text", "instances"):
            self.assertEqual(self.ours[name].lights(), self.stock[name].lights(), name)
            self.assertGreater(len(self.ours[name].lights()), 0)

    def test_cameras_are_the_same(self):
        for name in SCENES:
            self.assertEqual(self.ours[name].cameras(), self.stock[name].cameras(), name)

    def test_principled_materials_are_the_same(self):
        ours, stock = ({name: material["pbrMetallicRoughness"] for glb in glbs.values()
                        for name, material in glb.materials().items()}
                       for glbs in (self.ours, self.stock))
        for name in ("Red", "Ring", "Floor", "Stone", "Green", "Blue", "White"):
            for key, value in {"metallicFactor": 1, "roughnessFactor": 1, **stock[name]}.items():
                self.assertAlmostEqual(_sum(ours[name][key]), _sum(value), 5, (name, key))

    def test_nodes_beyond_the_exporter_are_expressed(self):
        text, glass = self.ours["text"].materials(), self.ours["glass"].materials()
        ink = text["Ink"]
        self.assertAlmostEqual(ink["pbrMetallicRoughness"]["baseColorFactor"][0], 0.7, 5)
        self.assertEqual(ink["pbrMetallicRoughness"]["metallicFactor"], 0)
        checker = text["Checker"]["pbrMetallicRoughness"]
        self.assertAlmostEqual(checker["baseColorFactor"][1], 0.8, 5)
        self.assertIn("KHR_texture_transform", checker["baseColorTexture"]["extensions"])
        self.assertEqual(glass["Glass"]["extensions"]["KHR_materials_transmission"],
                         {"transmissionFactor": 1.0})
        absorption = glass["Glass"]["extras"]["hipmap"]["medium"]["absorption"]
        self.assertAlmostEqual(absorption[0], (1 - 0.2) * 1.5, 5)
        self.assertEqual(glass["Fog"]["extras"]["hipmap"]["boundary"], False)
        self.assertEqual(glass["Leaf"]["alphaMode"], "BLEND")
        self.assertAlmostEqual(glass["Leaf"]["pbrMetallicRoughness"]["baseColorFactor"][3], 0.6, 5)
        self.assertAlmostEqual(
            glass["Light"]["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"], 20)

    def test_nothing_of_these_scenes_is_lost(self):
        self.assertEqual({name: self.said[name]["losses"] for name in SCENES},
                         {name: [] for name in SCENES})


def _sum(value):
    return sum(value) if isinstance(value, list) else value


if __name__ == "__main__":
    inside_blender.main(sys.argv)
