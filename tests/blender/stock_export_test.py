"""blender/export_hipmap.py: hipmap reads what glTF lacks, and its light is Cycles'.

    stock_export_test.py FOLDER_OF_TOOLS
"""

import json
import os
import re
import struct
import sys

import inside_blender
from inside_blender import BLENDER_FOLDER, HERE, BlenderTestCase

# Cycles' spots fall off otherwise than glTF's (docs/cycles.md); the one here is weak.
_SAME_LIGHT = 0.03


def read_json(path):
    with open(path, "rb") as file:
        length = struct.unpack("<12xI4x", file.read(20))[0]
        return json.loads(file.read(length))


def mean_of_pfm(path):
    with open(path, "rb") as file:
        file.readline()
        width, height = map(int, file.readline().split())
        file.readline()
        values = struct.unpack(f"<{3 * width * height}f", file.read())
    return [sum(values[c::3]) / (width * height) for c in range(3)]


class StockExport(BlenderTestCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        this = cls()
        said = this.blender("--python", os.path.join(HERE, "stock_export_scene.py"), "--",
                            this.path("a.blend"), this.path("cycles.exr"))
        cls.by_cycles = [float(x) for x in
                         re.search(r"^mean radiance: (.+)$", said, re.MULTILINE)[1].split()]
        cls.said = this.blender(this.path("a.blend"), "--python",
                                os.path.join(BLENDER_FOLDER, "export_hipmap.py"), "--",
                                this.path("a.glb"))
        cls.audit = this.tool("preprocess", this.path("a.glb"), "-o", this.path("a.hpm"))

    def extras(self, name):
        nodes = read_json(self.path("a.glb"))["nodes"]
        return next(node for node in nodes if node["name"] == name)["extras"]["hipmap"]

    def test_every_light_is_read(self):
        for line in ("point light 'Bulb'", "sun (directional light) 'Sun'", "spot light 'Nodes'",
                     "area light 'Square', 'Rectangle', 'Disc' and 'Ellipse'"):
            self.assertIn(line, self.audit)
        self.assertNotIn("warning:", self.audit)

    def test_lights_keep_their_sizes(self):
        self.assertAlmostEqual(self.extras("Bulb")["radius"], 0.12, 6)
        self.assertAlmostEqual(self.extras("Sun")["angle_deg"], 5.7295780, 5)
        self.assertEqual(self.extras("Disc")["area_shape"], "disc")
        self.assertEqual(self.extras("Ellipse")["area_height"], 0.5)
        self.assertAlmostEqual(self.extras("Square")["area_power"], 78.5398163, 5)

    def test_a_lights_colour_and_its_nodes_multiply(self):
        light = next(light for light in
                     read_json(self.path("a.glb"))["extensions"]["KHR_lights_punctual"]["lights"]
                     if light["name"] == "Nodes")
        self.assertEqual(light["color"], [0.5, 0.5, 1.0])
        self.assertAlmostEqual(light["intensity"], 50 * 2 / (4 * 3.14159265) * 683, 2)

    def test_the_scenes_camera_comes_first_with_its_lens(self):
        said = self.tool("render", self.path("a.glb"), self.path("a.hpm"), "--explain")
        self.assertIn("using 'Camera'", said)
        self.assertIn("environment map", said)
        self.assertRegex(said, "depth-of-field: on")
        self.assertRegex(said, "soft-shadows: on")
        self.assertAlmostEqual(self.extras("Camera")["aperture_radius"], 0.05 / 2.8, 6)

    def test_what_is_lost_is_named(self):
        self.assertIn("camera 'Camera': its aperture is round: its blades are not rendered",
                      self.said)
        self.assertIn("object 'Floor': its hair 'Grass' is not rendered", self.said)
        self.assertIn("object 'Pebbles': its instances of geometry nodes are not exported; F12 "
                      "renders them", self.said)

    def test_what_is_not_lost_is_not_named(self):
        self.assertEqual(self.said.count("warning:"), 3)
        for doubt in ("hidden objects", "no depth of field", "nothing in", "modifiers"):
            self.assertNotIn(doubt, self.audit)

    def test_the_light_is_cycles_light(self):
        self.tool("render", self.path("a.glb"), self.path("a.hpm"), "-o", self.path("a.pfm"),
                  "--size", "64x32", "--passes", 8, "--photons", 20000)
        ours = mean_of_pfm(self.path("a.pfm"))
        print("hipmap / Cycles:", [round(a / b, 4) for a, b in zip(ours, self.by_cycles)])
        for a, b in zip(ours, self.by_cycles):
            self.assertLess(abs(a / b - 1), _SAME_LIGHT)


if __name__ == "__main__":
    inside_blender.main(sys.argv)
