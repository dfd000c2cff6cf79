"""render --crop: the pixels of the whole image, and a state that knows its part.

    crop_test.py FOLDER_OF_TOOLS SCENE
"""

import struct
import sys

import tools
from exr_file import ExrFile
from pictures import read_pfm
from tools import Tools, ToolsTestCase

WIDTH, HEIGHT = 40, 24
PARTS = [(13, 7, 34, 21), (16, 16, 32, 17), (0, 0, 1, 1), (30, 18, 40, 24)]


def text_of(part):
    return ",".join(map(str, part))


def cut(rows, part):
    left, top, right, bottom = part
    return [row[left:right] for row in rows[top:bottom]]


class Crop(ToolsTestCase):
    def setUp(self):
        super().setUp()
        self.write_partition()

    def command(self, *options):
        return [Tools.scene, self.path("scene.hpm"), "--size", f"{WIDTH}x{HEIGHT}", "--photons", 3000,
                "--passes", 2, *options]

    def render(self, *options):
        return self.succeed("render", *self.command(*options))

    def rows(self, *options):
        self.render("-o", self.path("a.pfm"), *options)
        return read_pfm(self.path("a.pfm")).rows

    def test_its_pixels_have_the_bits_of_the_whole_image(self):
        for options in ((), ("--integrator", "direct", "--filter", "box", "--clamp", 1)):
            whole = self.rows(*options)
            for part in PARTS:
                self.assertEqual(self.rows(*options, "--crop", text_of(part)), cut(whole, part))
        self.assertEqual(self.rows(*options, "--crop", "25%,50%,62.6%,100%"),
                         cut(whole, (10, 12, 25, 24)))

    def test_exr_files_say_where_the_part_lies(self):
        whole = self.path("whole.exr")
        names = ("--layer-names", "combined,depth,denoising-albedo")
        self.render("--layers", whole, *names)
        part = PARTS[0]
        files = self.path("a.exr"), self.path("layers.exr")
        self.render("-o", files[0], "--layers", files[1], *names, "--crop", text_of(part))
        for path in files:
            file = ExrFile(path)
            self.assertEqual(struct.unpack("<4i", file.attributes["displayWindow"]),
                             (0, 0, WIDTH - 1, HEIGHT - 1))
            self.assertEqual(struct.unpack("<4i", file.attributes["dataWindow"]),
                             (part[0], part[1], part[2] - 1, part[3] - 1))
        found = ExrFile(files[1]).channels
        for name, values in ExrFile(whole).channels.items():
            rows = [values[y * WIDTH:(y + 1) * WIDTH] for y in range(HEIGHT)]
            self.assertEqual(sum(cut(rows, part), []), found[name], name)

    def test_a_state_keeps_its_part(self):
        state, other = self.path("a.state"), self.path("b.state")
        part = text_of(PARTS[0])
        self.render("-o", self.path("a.exr"), "--crop", part, "--state", state)
        self.render("--crop", text_of(PARTS[1]), "--state", other, "-o", self.path("b.pfm"),
                    "--first-pass", 2)
        self.refuse("render", "merge", state, other, "-o", self.path("c.pfm"), naming="crop=13,7,34,21")
        self.refuse("render", *self.command("-o", self.path("c.pfm"), "--state", state),
                    naming="crop=none")
        self.render("-o", self.path("b.pfm"), "--crop", part, "--state", other, "--replace-state",
                    "--first-pass", 2)
        self.succeed("render", "merge", state, other, "-o", self.path("merged.exr"))
        self.assertEqual(ExrFile(self.path("merged.exr")).attributes["dataWindow"],
                         ExrFile(self.path("a.exr")).attributes["dataWindow"])

    def test_no_part_of_the_image_is_refused(self):
        for wrong, naming in {"0,0,9": "X0,Y0,X1,Y1", "0,0,1.5,2": "X0,Y0,X1,Y1",
                              "-1,0,3,3": "X0,Y0,X1,Y1", "0,0,101%,3": "X0,Y0,X1,Y1",
                              "5,5,5,9": "holds no pixel of the image of 40x24",
                              "0,0,41,9": "reaches beyond the image of 40x24"}.items():
            self.refuse("render", *self.command("-o", self.path("a.pfm"), "--crop=" + wrong),
                        naming=naming)


if __name__ == "__main__":
    tools.main(sys.argv)
