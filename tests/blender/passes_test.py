"""Render passes in Blender: the values of `render --layers`, and those of Cycles.

    passes_test.py FOLDER_OF_TOOLS
"""

import json
import os
import sys

import inside_blender
from inside_blender import HERE, BlenderTestCase, Tools

sys.path.insert(0, os.path.join(os.path.dirname(HERE), "end_to_end"))
from exr_file import ExrFile

WIDTH, HEIGHT = 48, 32
LAYER = "Main.layer 1"
INDEX_OB, INDEX_MA = f"{LAYER}.IndexOB.X", f"{LAYER}.IndexMA.X"
OBJECTS, MATERIALS = {0, 3, 7, 300}, {0, 5, 12}


def names(name, letters):
    return [f"{LAYER}.{name}.{letter}" for letter in letters]


class Passes(BlenderTestCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        this = cls()
        this.make_addon("hipmap.zip", "--programs", Tools.folder)
        cls.said = this.blender("--python", os.path.join(HERE, "passes_inside.py"), "--",
                                this.path("hipmap.zip"), cls.folder)
        cls.ours, cls.file, cls.border, cls.cycles, cls.baked, cls.baked_cycles = (
            ExrFile(this.path(name + ".exr")).channels
            for name in ("hipmap", "layers", "border", "cycles", "baked", "baked_cycles"))

    def even_pixels(self):
        """Pixels around which Cycles has one normal, so that a mean is that of any part."""
        values = list(zip(*(self.cycles[name] for name in names("Normal", "XYZ"))))
        for y in range(2, HEIGHT - 2):
            for x in range(2, WIDTH - 2):
                around = [values[(y + v) * WIDTH + x + u] for v in range(-2, 3)
                          for u in range(-2, 3)]
                if all(max(abs(a - b) for a, b in zip(one, around[0])) < 1e-4 for one in around):
                    yield y * WIDTH + x

    def test_the_values_are_those_of_cycles(self):
        same = [i for i in range(WIDTH * HEIGHT)
                if self.ours[INDEX_OB][i] == self.cycles[INDEX_OB][i]]
        self.assertGreater(len(same), 0.99 * WIDTH * HEIGHT)
        for name in (INDEX_MA, *names("Depth", "Z"), *names("Position", "XYZ")):
            off = [abs(self.ours[name][i] - self.cycles[name][i]) for i in same]
            beyond = sum(one > 1e-4 for one in off)  # beside an edge, or where it is steep
            print(f"{name}: at most {max(off):.2g} in {len(off)} pixels")
            self.assertLess(beyond, 0.01 * len(off), name)
        even = list(self.even_pixels())
        self.assertGreater(len(even), 500)
        for name in (*names("Normal", "XYZ"), *names("DiffCol", "RGB")):
            most = max(abs(self.ours[name][i] - self.cycles[name][i]) for i in even)
            print(f"{name}: at most {most:.2g} in {len(even)} pixels")
            self.assertLess(most, 1e-3, name)

    def test_indices_are_those_of_the_objects_and_materials(self):
        self.assertEqual(set(self.ours[INDEX_OB]), OBJECTS)
        self.assertEqual(set(self.ours[INDEX_MA]), MATERIALS)

    def test_the_floor_has_its_height_and_normal(self):
        floor = [i for i in self.even_pixels() if self.ours[INDEX_OB][i] == 7]
        self.assertGreater(len(floor), 200)
        x, y, z = (self.ours[name] for name in names("Position", "XYZ"))
        up = self.ours[names("Normal", "Z")[0]]
        for i in floor:
            self.assertAlmostEqual(z[i], 0.5, 5)
            self.assertLessEqual(max(abs(x[i]), abs(y[i])), 3)
            self.assertAlmostEqual(up[i], 1, 5)

    def test_hipmaps_own_passes_are_those_of_the_file(self):
        for name in (*names("Map ID", "X"), *names("Noise", "RGB"), *names("Error", "RGB"),
                     *names("Denoising Albedo", "RGB"), *names("Combined", "RGBA")):
            self.assertEqual(self.ours[name], self.file[name], name)
            self.assertGreater(len(set(self.ours[name])), 0 if name.endswith("A") else 3, name)

    def test_baked_nodes_have_the_colours_of_cycles(self):
        even = list(self.even_pixels())
        # Veins on a cube and its twin, and tiles whose edges cross pixels.
        for indices, within in (((3, 300), 0.05), ((7,), 0.1)):
            of = [i for i in even if self.baked[INDEX_OB][i] in indices]
            self.assertGreater(len(of), 25)
            for name in names("DiffCol", "RGB"):
                values = [self.baked_cycles[name][i] for i in of]
                off = [self.baked[name][i] - self.baked_cycles[name][i] for i in of]
                span, mean = max(values) - min(values), sum(off) / len(off)
                spread = sum(map(abs, off)) / len(off)
                print(f"objects {indices}, {name}: {min(values):.2f} to {max(values):.2f}, off by "
                      f"{spread:.4f}, in the mean by {mean:.4f}")
                self.assertLess(spread, within * span)
                self.assertLess(abs(mean), 0.02 * span)
                self.assertGreater(span, 0.05)
        self.assertNotIn("cannot be expressed", self.said)

    def test_nodes_are_baked_once_and_leave_the_file_as_it_is(self):
        with open(self.path("baked.json"), encoding="utf-8") as file:
            facts = json.load(file)
        first, second = facts["made"]
        self.assertEqual(len(first), 3)  # the twin has no modifier
        self.assertEqual(first, second)
        before, after = facts["counts"]
        self.assertEqual(before, after)

    def test_a_border_is_in_its_place(self):
        name = names("Depth", "Z")[0]
        for y in range(HEIGHT):
            for x in range(WIDTH):
                inside = WIDTH // 4 <= x < WIDTH * 3 // 4 and y >= HEIGHT // 2
                i = y * WIDTH + x
                if inside:
                    self.assertAlmostEqual(self.border[name][i] / self.ours[name][i], 1, 5)
                else:  # what Blender fills a depth with
                    self.assertGreaterEqual(self.border[name][i], 1e10)


if __name__ == "__main__":
    inside_blender.main(sys.argv)
