"""What instances promise: a scene whose trees are instances of one mesh looks and counts like one whose trees
are meshes of their own, in a fraction of the memory.

    instances_test.py FOLDER_OF_TOOLS
"""

import json
import math
import os
import random
import shutil
import struct
import sys
import tempfile

import pictures
import tools
from tools import ToolsTestCase

SIDE = 7
PASSES = 4
SIZE, PHOTONS = 32, 8000
INTEGRATORS = "progressive", "path", "direct"


def tree():
    """A trunk that goes into the ground, and a wrinkled crown: vertices and corners."""
    vertices, corners = [], []

    def add_grid(columns, rows, place):
        first = len(vertices)
        for j in range(rows + 1):
            for i in range(columns + 1):
                vertices.append(place(2 * math.pi * (i % columns) / columns, j / rows))
        for j in range(rows):
            for i in range(columns):
                a = first + j * (columns + 1) + i
                b = a + columns + 1
                corners.extend([(a, b, b + 1), (a, b + 1, a + 1)])

    add_grid(8, 10, lambda phi, v: (0.05 * math.cos(phi), 0.6 * v - 0.1, -0.05 * math.sin(phi)))

    def crown(phi, v):
        theta = math.pi * (0.02 + 0.96 * v)
        radius = 0.3 + 0.02 * math.sin(8 * theta) * math.sin(6 * phi)
        return (radius * math.sin(theta) * math.cos(phi), 0.7 - radius * math.cos(theta),
                -radius * math.sin(theta) * math.sin(phi))

    add_grid(36, 30, crown)
    return vertices, corners


def nodes(numbers):
    """Trees on a lawn, so close that some crowns meet; mesh i of tree i is mesh_of(i)."""
    out = []
    for i in range(SIDE * SIDE):
        angle = math.pi * numbers.random()
        out.append({"translation": [0.62 * (i % SIDE - SIDE / 2) + 0.1 * numbers.random(), 0,
                                    0.62 * (i // SIDE - SIDE / 2) + 0.1 * numbers.random()],
                    "rotation": [0, math.sin(angle), 0, math.cos(angle)],
                    "scale": [0.8 + 0.4 * numbers.random()] * 3})
    return out


def grove(one_mesh):
    """The bytes of a .glb file."""
    vertices, corners = tree()
    lawn = [(-3, 0, -3), (-3, 0, 3), (3, 0, 3), (3, 0, -3)], [(0, 1, 2), (0, 2, 3)]
    binary, views, accessors = b"", [], []
    for values, kind, layout in ((vertices, "VEC3", "f"), (corners, "SCALAR", "I"),
                                 (lawn[0], "VEC3", "f"), (lawn[1], "SCALAR", "I")):
        data = b"".join(struct.pack(f"<3{layout}", *value) for value in values)
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(data)})
        accessors.append({"bufferView": len(views) - 1, "componentType": 5126 if layout == "f" else 5125,
                          "type": kind, "count": len(values) * (1 if layout == "f" else 3)})
        if layout == "f":
            accessors[-1]["min"] = [min(v[axis] for v in values) for axis in range(3)]
            accessors[-1]["max"] = [max(v[axis] for v in values) for axis in range(3)]
        binary += data
    trees = nodes(random.Random(1))
    green = {"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}
    meshes = [green] * (1 if one_mesh else len(trees))
    for i, node in enumerate(trees):
        node["mesh"] = 0 if one_mesh else i
    meshes.append({"primitives": [{"attributes": {"POSITION": 2}, "indices": 3, "material": 1}]})
    rest = [{"mesh": len(meshes) - 1},
            {"camera": 0, "translation": [0, 2.4, 4.4], "rotation": [-0.2588, 0, 0, 0.9659]},
            {"translation": [1, 3, 1], "extensions": {"KHR_lights_punctual": {"light": 0}}}]
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "extensionsUsed": ["KHR_lights_punctual"],
        "scenes": [{"nodes": list(range(len(trees) + 3))}], "nodes": trees + rest,
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.8, "znear": 0.1}}],
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": 4000}]}},
        "materials": [{"doubleSided": True, "pbrMetallicRoughness":
                       {"metallicFactor": 0, "baseColorFactor": [0.3, 0.8, 0.2, 1]}},
                      {"pbrMetallicRoughness": {"metallicFactor": 0, "baseColorFactor": [0.8, 0.7, 0.5, 1]}}],
        "meshes": meshes, "accessors": accessors, "bufferViews": views,
        "buffers": [{"byteLength": len(binary)}]}
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    return (struct.pack("<5I", 0x46546c67, 2, 28 + len(text) + len(binary), len(text), 0x4e4f534a) + text +
            struct.pack("<2I", len(binary), 0x004e4942) + binary)


def difference(a, b):
    """The root mean square over pixels, of the mean of channels."""
    pairs = list(zip(a.pixels(), b.pixels()))
    return math.sqrt(sum(((sum(x) - sum(y)) / 3) ** 2 for x, y in pairs) / len(pairs))


class Instances(ToolsTestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory(prefix="hipmap-test-")
        cls.addClassCleanup(temporary.cleanup)
        cls.scenes = temporary.name
        for name in "instances", "meshes":
            with open(os.path.join(cls.scenes, name + ".glb"), "wb") as file:
                file.write(grove(name == "instances"))

    def scene(self, name):
        return os.path.join(self.scenes, name + ".glb")

    def preprocess(self, name, *options):
        """Without options, once for all tests."""
        made = os.path.join(self.folder if options else self.scenes, name)
        if options or not os.path.exists(made + ".hpm"):
            self.succeed("preprocess", self.scene(name), "-o", made + ".hpm", "--json", made + ".json", *options)
        if not options:
            for suffix in ".hpm", ".json":
                shutil.copy(made + suffix, self.path(name + suffix))
        with open(self.path(name + ".json"), encoding="utf-8") as file:
            return json.load(file)

    def render(self, name, seed, *options):
        image = self.path(f"{name}{seed}.pfm")
        self.succeed("render", self.scene(name), self.path(name + ".hpm"), "-o", image, "--size", SIZE,
                     "--passes", PASSES, "--photons", PHOTONS, "--seed", seed, "--stats",
                     self.path(name + "-stats.json"), *options)
        with open(self.path(name + "-stats.json"), encoding="utf-8") as file:
            return pictures.read_pfm(image), json.load(file)

    def test_the_partition_is_that_of_separate_meshes(self):
        shared, separate = self.preprocess("instances"), self.preprocess("meshes")
        for what in "faces", "shared_maps", "closed_faces", "joined_maps", "bridged_edges":
            self.assertEqual(shared[what], separate[what], what)
        # Rounding of positions decides of a few edges at the threshold, and of short contacts.
        for what in "connected", "unconnected", "border", "non_manifold":
            self.assertAlmostEqual(shared["edges"][what], separate["edges"][what],
                                   delta=0.001 * separate["edges"][what] + 1)
        self.assertGreater(separate["contacts"], 1000)
        self.assertAlmostEqual(shared["contacts"], separate["contacts"], delta=0.02 * separate["contacts"])

    def test_images_differ_by_no_more_than_noise(self):
        self.preprocess("instances")
        self.preprocess("meshes")
        for integrator in INTEGRATORS:
            with self.subTest(integrator):
                options = "--integrator", integrator
                copied, of_copied = self.render("instances", 1, *options)
                stored, of_stored = self.render("meshes", 1, *options)
                other, _ = self.render("meshes", 2, *options)
                self.assertLess(difference(copied, other), 1.3 * difference(stored, other))
                for a, b in zip(copied.mean(), stored.mean()):
                    self.assertAlmostEqual(a, b, delta=0.02 * b)
                self.assertEqual(of_copied["scene"]["faces"], of_stored["scene"]["faces"])
                self.assertEqual(of_copied["scene"]["faces"], SIDE ** 2 * 2 * (80 + 1080) + 2)

    def test_what_shows_or_needs_every_face_stores_the_copies(self):
        self.preprocess("instances", "--images", self.path("images"), "--size", SIZE, "--coloured",
                        self.path("coloured.glb"))
        copied, _ = self.render("instances", 1, "--integrator", "direct", "--maps", "thesis")
        self.preprocess("meshes")
        stored, _ = self.render("meshes", 1, "--integrator", "direct", "--maps", "thesis")
        for a, b in zip(copied.mean(), stored.mean()):
            self.assertAlmostEqual(a, b, delta=0.02 * b)

    def test_a_partition_of_separate_meshes_is_refused(self):
        self.preprocess("meshes")
        self.refuse("render", self.scene("instances"), self.path("meshes.hpm"), "-o", self.path("x.png"),
                    naming="made for another scene")

    def test_the_image_is_the_same_at_any_number_of_threads(self):
        self.preprocess("instances", "--threads", 1)
        with open(self.path("instances.hpm"), "rb") as file:
            one = file.read()
        self.preprocess("instances", "--threads", 4)
        with open(self.path("instances.hpm"), "rb") as file:
            self.assertEqual(file.read(), one)
        a, _ = self.render("instances", 1, "--threads", 1)
        b, _ = self.render("instances", 1, "--threads", 4)
        self.assertEqual(a.rows, b.rows)


if __name__ == "__main__":
    tools.Tools.folder = sys.argv[1]
    tools.unittest.main(argv=sys.argv[:1], verbosity=2)
