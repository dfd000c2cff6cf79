"""Materials of the add-on's export: what glTF expresses is there, the rest is named.

    materials_test.py FOLDER_OF_TOOLS
"""

import json
import os
import re
import struct
import sys
import zlib

import inside_blender
from glb_content import Glb
from inside_blender import BLENDER_FOLDER, HERE, BlenderTestCase


def first_pixel(png):
    """The first pixel of an 8-bit PNG whose first row has no filter."""
    at, data, head = 8, b"", None
    while at < len(png):
        length, kind = struct.unpack_from(">I4s", png, at)
        body = png[at + 8:at + 8 + length]
        head = body if kind == b"IHDR" else head
        data += body if kind == b"IDAT" else b""
        at += 12 + length
    row = zlib.decompress(data)
    return list(row[1:4 + (head[9] == 6)])


class Adjustments(BlenderTestCase):
    def test_colours_change_as_in_cycles(self):
        said = self.blender("--python", os.path.join(HERE, "adjust_inside.py"), "--",
                            BLENDER_FOLDER, self.path("a.exr"))
        found = json.loads(re.search(r"^colours: (.*)$", said, re.MULTILINE)[1])
        self.assertEqual(len(found), 17)
        for kind, by_cycles, ours in found:
            # Cycles' black bodies are fits too.
            within = 0.03 * max(by_cycles) if kind == "ShaderNodeBlackbody" else 1e-3
            for a, b in zip(by_cycles, ours):
                self.assertLess(abs(a - b), within, (kind, by_cycles, ours))


class Materials(BlenderTestCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        this = cls()
        said = this.blender("--python", os.path.join(HERE, "materials_inside.py"), "--",
                            BLENDER_FOLDER, this.path("a.glb"))
        cls.losses = json.loads(re.search(r"^losses: (.*)$", said, re.MULTILINE)[1])
        cls.sky = json.loads(re.search(r"^sky: (.*)$", said, re.MULTILINE)[1])
        cls.cancelled = float(re.search(r"^cancelled after: (.*)$", said, re.MULTILINE)[1])
        cls.glb = Glb(this.path("a.glb"))

    def pbr(self, name):
        return self.glb.materials()[name]["pbrMetallicRoughness"]

    def pixel(self, info):
        texture = self.glb.json["textures"][info["index"]]
        view = self.glb.json["bufferViews"][
            self.glb.json["images"][texture["source"]]["bufferView"]]
        return first_pixel(self.glb.buffer[view["byteOffset"]:
                                           view["byteOffset"] + view["byteLength"]])

    def test_every_loss_is_named_once(self):
        self.assertEqual(sorted(self.losses), sorted([
            "light 'No file': node 'IES Texture': its file is missing: rendered without it",
            "light 'Profile Spot': node 'IES Texture' is rendered on point lights alone",
            "material 'Patchy': node 'Noise Texture' at Volume cannot be expressed: rendered "
            "without the volume",
            "material 'Two ways': node 'Add Shader' at Volume: both anisotropies are rendered as "
            "their mean",
            "object 'Volume 0': its smoke is not rendered: its volume fills the whole domain",
            "material 'Noisy': node 'Noise Texture' at Base Color cannot be expressed: rendered "
            "as its mean (Bake Nodes renders it)",
            "material 'Noisy': node 'Bump' at Normal cannot be expressed: rendered with the mesh's "
            "own normals (Bake Nodes renders it)",
            "material 'Noisy': its subsurface scattering is rendered as diffuse",
            "material 'Painted': node 'Color Attribute' at Roughness cannot be expressed: rendered "
            "with the input's own value (Bake Nodes renders it)",
            "material 'Facing': node 'Mix Shader' cannot be expressed: the shader of greater "
            "weight is rendered alone",
            "material 'Without shadow': node 'Light Path' at Fac cannot be expressed: rendered as "
            "for the camera",
            "material 'Skin tone': its subsurface scattering is rendered as diffuse",
            "material 'Velvet': node 'Velvet BSDF' cannot be expressed: rendered as diffuse",
            "object 'Hairy': its hair 'Hair' is not rendered"]))

    def test_an_unknown_node_gives_its_mean_or_leaves_the_inputs_own_value(self):
        self.assertAlmostEqual(self.pbr("Noisy")["baseColorFactor"][2], 0.5, 5)
        self.assertEqual(self.pbr("Painted")["roughnessFactor"], 1)
        self.assertAlmostEqual(self.pbr("Velvet")["baseColorFactor"][1], 0.2, 5)

    def extension(self, name, extension):
        return self.glb.materials()[name]["extensions"]["KHR_materials_" + extension]

    def test_fresnel_over_diffuse_is_a_dielectric(self):
        for name, index in (("Plastic", 1.45), ("Weighted", 2)):
            self.assertAlmostEqual(self.extension(name, "ior")["ior"], index, 5)
            self.assertAlmostEqual(self.pbr(name)["roughnessFactor"], 0.1, 5)
            self.assertEqual(self.pbr(name)["metallicFactor"], 0)
            self.assertEqual([round(c, 5) for c in self.extension(name, "specular")[
                "specularColorFactor"]], [0.8] * 3)
        # The base has what a dielectric of 1.45 leaves of even light: all but 8.4 %.
        self.assertAlmostEqual(self.pbr("Plastic")["baseColorFactor"][0], 0.5 * 0.916, 3)
        # By the mean of its factor the diffuse shader has the greater weight.
        self.assertEqual(self.pbr("Facing")["metallicFactor"], 0)

    def test_refraction_and_reflection_by_fresnel_are_glass(self):
        self.assertAlmostEqual(self.extension("Two parts of glass", "ior")["ior"], 1.3, 5)
        self.assertEqual(self.extension("Two parts of glass", "transmission")[
            "transmissionFactor"], 1)

    def test_a_curtain_reflects_and_lets_light_pass(self):
        values = self.extension("Curtain", "diffuse_transmission")
        self.assertAlmostEqual(values["diffuseTransmissionFactor"], 0.25, 5)
        self.assertEqual([round(c, 5) for c in values["diffuseTransmissionColorFactor"]],
                         [0.2, 0.4, 0.6])
        self.assertAlmostEqual(self.pbr("Curtain")["baseColorFactor"][0], 0.5, 5)

    def test_glass_that_casts_no_shadow_is_glass(self):
        self.assertEqual(self.extension("Without shadow", "transmission")["transmissionFactor"], 1)
        self.assertEqual(self.pbr("Without shadow")["baseColorFactor"][3], 1)

    def test_a_muted_node_hands_on_its_first_shader(self):
        self.assertEqual(self.pbr("Muted")["metallicFactor"], 0)
        self.assertAlmostEqual(self.pbr("Muted")["baseColorFactor"][0], 0.5, 5)

    def test_the_colour_of_subsurface_scattering_is_mixed_in(self):
        self.assertEqual([round(c, 5) for c in self.pbr("Skin tone")["baseColorFactor"]],
                         [0.7, 0.3, 0, 1])

    def test_colours_are_srgb(self):
        self.assertEqual(self.pixel(self.pbr("Image")["baseColorTexture"])[:3], [255, 64, 0])
        # 0.5 that is no colour becomes the sRGB value of 0.5.
        self.assertEqual(self.pixel(self.pbr("Linear")["baseColorTexture"])[:3], [188] * 3)

    def test_adjusted_images_are_written_adjusted(self):
        # (1, 0.25, 0) in sRGB is (1, 0.0513, 0); inverted (0, 0.949, 1), in sRGB again:
        self.assertEqual(self.pixel(self.pbr("Inverted")["baseColorTexture"])[:3], [0, 249, 255])
        # A ramp from 0 to 1 of a grey of 0.25, upside down: 0.75.
        self.assertEqual(self.pixel(self.pbr("Ramp")["metallicRoughnessTexture"])[1], 191)

    def test_channels_of_an_image_stay_where_they_are(self):
        info = self.pbr("Packed")["metallicRoughnessTexture"]
        self.assertEqual(self.pixel(info)[1:3], [64, 191])

    def test_two_images_become_one(self):
        info = self.pbr("Two images")["metallicRoughnessTexture"]
        self.assertEqual(self.pixel(info)[1:3], [128, 255])

    def test_an_image_of_alpha_alone_keeps_the_colour(self):
        material = self.glb.materials()["Cut out"]
        self.assertEqual(material["alphaMode"], "BLEND")
        self.assertEqual(self.pixel(self.pbr("Cut out")["baseColorTexture"]), [255] * 3 + [128])
        self.assertAlmostEqual(self.pbr("Cut out")["baseColorFactor"][0], 0.8, 5)

    def test_groups_are_looked_into(self):
        colour = self.pbr("Grouped")["baseColorFactor"]
        for channel, value in enumerate((0.4, 0.2, 0.1)):
            self.assertAlmostEqual(colour[channel], value, 5)

    def test_colour_layers_are_written_where_a_node_uses_them(self):
        used = [primitive for mesh in self.glb.json["meshes"] for primitive in mesh["primitives"]
                if "COLOR_0" in primitive["attributes"]]
        self.assertEqual([self.glb.material(primitive) for primitive in used], ["Painted"])
        colour = self.glb.array(used[0]["attributes"]["COLOR_0"])[0]
        for channel, value in enumerate((0.2, 0.4, 0.6)):
            self.assertAlmostEqual(colour[channel], value, 2)

    def test_a_material_without_nodes_is_diffuse(self):
        self.assertAlmostEqual(self.pbr("No nodes")["baseColorFactor"][0], 0.3, 5)
        self.assertEqual(self.pbr("No nodes")["baseColorFactor"][3], 1)
        self.assertEqual(self.pbr("No nodes")["metallicFactor"], 0)

    def test_a_number_is_grey(self):
        self.assertEqual([round(c, 5) for c in self.pbr("Grey number")["baseColorFactor"]],
                         [0.4, 0.4, 0.4, 1])
        emissive = self.glb.materials()["Grey number"]["emissiveFactor"]
        self.assertEqual([round(c, 5) for c in emissive], [0.4] * 3)

    def test_a_translucent_surface_keeps_its_image(self):
        values = self.glb.materials()["Paper"]["extensions"]["KHR_materials_diffuse_transmission"]
        self.assertEqual(self.pixel(values["diffuseTransmissionColorTexture"])[:3], [128, 153, 179])

    def test_the_world_has_its_fog(self):
        world = self.glb.json["scenes"][0]["extras"]["hipmap"]
        self.assertAlmostEqual(world["world_color"][1], 0.2, 5)
        self.assertAlmostEqual(world["medium"]["scattering"][0], 0.8 * 0.02, 5)

    def test_an_area_light_keeps_its_spread(self):
        node, = (node for node in self.glb.json["nodes"] if node["name"] == "Narrow")
        self.assertAlmostEqual(node["extras"]["hipmap"]["area_spread_deg"], 28.6478898, 5)

    def test_a_sky_is_behind_the_fog_of_its_world(self):
        self.assertGreater(self.sky[0], 1)
        self.assertAlmostEqual(self.sky[1], 0.8, 5)

    def test_a_cancelled_sky_ends_soon_and_leaves_nothing(self):
        self.assertLess(self.cancelled, 1)
        self.assertEqual([name for name in os.listdir(self.folder) if name.startswith("a.glb.")], [])

    def medium(self, name):
        return self.glb.materials()[name]["extras"]["hipmap"]["medium"]

    def test_mixed_volumes_have_their_shares(self):
        self.assertEqual([round(x, 5) for x in self.medium("Mist")["absorption"]], [1] * 3)
        self.assertEqual([round(x, 5) for x in self.medium("Mist")["scattering"]], [1] * 3)
        self.assertAlmostEqual(self.medium("Mist")["g"], 0.3, 5)
        self.assertAlmostEqual(self.medium("Two ways")["g"], 0.2, 5)

    def test_a_hot_volume_emits_as_a_black_body(self):
        # The radiance of a black body of 1000 K, by Cycles' scale of 1e-6, and red above all.
        red, green, blue = self.medium("Ember")["emission"]
        self.assertAlmostEqual(0.2126 * red + 0.7152 * green + 0.0722 * blue, 0.01805,
                               delta=0.0004)
        self.assertGreater(red, 5 * green)

    def test_a_photometric_file_is_beside_the_scene(self):
        node, = (node for node in self.glb.json["nodes"] if node["name"] == "Profile Point")
        extras = node["extras"]["hipmap"]
        self.assertAlmostEqual(extras["ies_scale"], 10 * 2 * 683 / 177.83, 3)
        with open(self.path(extras["ies"]), encoding="utf-8") as file:
            self.assertIn("100 100", file.read())

    def test_hipmap_reads_all_of_it(self):
        said = self.tool("preprocess", self.path("a.glb"), "-o", self.path("a.hpm"))
        self.assertNotIn("warning:", said)


if __name__ == "__main__":
    inside_blender.main(sys.argv)
