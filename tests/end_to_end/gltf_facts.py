"""What a glTF file says of its materials and lights, read without hipmap's loader."""

import base64
import json
import os
import struct
from collections import Counter
from itertools import permutations

from glb_file import COMPONENTS

FORMATS = {5120: "b", 5121: "B", 5122: "h", 5123: "H", 5125: "I", 5126: "f"}
RENDERED = ("transmissionTexture", "specularTexture", "specularColorTexture", "clearcoatTexture",
            "clearcoatRoughnessTexture", "sheenColorTexture", "sheenRoughnessTexture",
            "anisotropyTexture", "diffuseTransmissionTexture", "diffuseTransmissionColorTexture")


def lies_in(point, triangles):
    """By the number of them that a ray from the point meets."""
    way, met = (0.2371, 0.8963, 0.3747), 0
    for a, b, c in triangles:
        # Cramer's rule for point + t way = a + u (b - a) + v (c - a).
        u, v, p = ([x - y for x, y in zip(end, a)] for end in (b, c, point))
        across = cross(way, v)
        whole = dot(u, across)
        if whole == 0:
            continue
        first, turned = dot(p, across) / whole, cross(p, u)
        second, along = dot(way, turned) / whole, dot(v, turned) / whole
        met += first >= 0 and second >= 0 and first + second <= 1 and along > 0
    return met % 2 == 1


def may_touch(a, b):
    """Whether the boxes of triangles overlap."""
    boxes = [[(min(axis), max(axis)) for axis in zip(*(c for corners in shape for c in corners))]
             for shape in (a, b)]
    return all(low <= top and bottom <= high for (low, high), (bottom, top) in zip(*boxes))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


class GltfFacts:
    """materials: the numbers of those that faces wear, by name."""

    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        self.folder, self.binary = os.path.dirname(path), b""
        if data[:4] == b"glTF":
            length = struct.unpack_from("<I", data, 12)[0]
            self.binary = data[28 + length:]
            data = data[20:20 + length]
        self.json, self.read = json.loads(data), {}
        self.primitives = [p for mesh in self.meshes() for p in mesh["primitives"]
                           if p.get("mode", 4) >= 4]
        worn = {p.get("material", -1) for p in self.primitives}
        self.materials = [self.material(i) for i in sorted(worn)]

    def nodes(self):
        """Those of the scene shown."""
        scene = self.json["scenes"][self.json.get("scene", 0)]
        waiting = list(scene.get("nodes", []))
        while waiting:
            node = self.json["nodes"][waiting.pop()]
            waiting.extend(node.get("children", []))
            yield node

    def meshes(self):
        return [self.json["meshes"][i] for i in sorted({n["mesh"] for n in self.nodes()
                                                        if "mesh" in n})]

    def lone_box(self):
        """Whether one mesh of as many corners as a box of triangles is all there is.  Its positions may be compressed."""
        if len([n for n in self.nodes() if "mesh" in n]) != 1 or len(self.primitives) != 1:
            return False
        primitive = self.primitives[0]
        counts = [self.json["accessors"][i]["count"]
                  for i in (primitive["attributes"]["POSITION"], primitive.get("indices", -1)) if i >= 0]
        return counts == [24, 36]

    def lamps(self):
        return [n for n in self.nodes() if "KHR_lights_punctual" in n.get("extensions", {})]

    def sized_lamps(self):
        """Names of those that hipmap's own keys give a size."""
        lights = self.json.get("extensions", {}).get("KHR_lights_punctual", {}).get("lights", [])

        def has_size(thing):
            own = thing.get("extras", {}).get("hipmap", {})
            return any(own.get(key, 0) > 0 for key in ("radius", "angle_deg", "area_power"))

        sized = [n for n in self.lamps()
                 if has_size(n) or has_size(lights[n["extensions"]["KHR_lights_punctual"]["light"]])]
        sized += [n for n in self.nodes() if has_size(n) and n not in sized]
        return [n["name"] for n in sized]

    def has_lens(self):
        """The first camera, by hipmap's own key."""
        cameras = [n for n in self.nodes() if "camera" in n]
        lens = cameras[0].get("extras", {}).get("hipmap", {}) if cameras else {}
        return lens.get("aperture_radius", 0) > 0 and lens.get("focus_distance", 0) > 0

    def around(self):
        """What hipmap's own keys say of the scene."""
        scene = self.json["scenes"][self.json.get("scene", 0)]
        return scene.get("extras", {}).get("hipmap", {})

    def has_world(self):
        world = self.around()
        return any(world.get("world_color", [0])) and world.get("world_strength", 1) > 0

    def values(self, index):
        """Rows of an accessor that is neither sparse nor compressed."""
        if index not in self.read:
            self.read[index] = self.unpacked(index)
        return self.read[index]

    def unpacked(self, index):
        accessor = self.json["accessors"][index]
        view = self.json["bufferViews"][accessor["bufferView"]]
        buffer = self.json["buffers"][view["buffer"]]
        data, uri = self.binary, buffer.get("uri", "")
        if uri.startswith("data:"):
            data = base64.b64decode(uri.partition(",")[2])
        elif uri:
            with open(os.path.join(self.folder, uri), "rb") as file:
                data = file.read()
        layout = struct.Struct(f"<{COMPONENTS[accessor['type']]}"
                               f"{FORMATS[accessor['componentType']]}")
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        stride = view.get("byteStride", layout.size)
        return [layout.unpack_from(data, start + i * stride) for i in range(accessor["count"])]

    def vertex_colours(self):
        """Some are not white."""
        for primitive in self.primitives:
            index = primitive["attributes"].get("COLOR_0")
            if index is not None:
                kind = self.json["accessors"][index]["componentType"]
                white = {5121: 255, 5123: 65535}.get(kind, 1)
                if any(v != white for row in self.values(index) for v in row):
                    return True
        return False

    def closed(self, material):
        """Some mesh that wears it has two faces at each edge."""
        for mesh in self.meshes():
            edges = Counter()
            if all(p.get("material", -1) != material for p in mesh["primitives"]):
                continue
            for primitive in mesh["primitives"]:
                positions = self.values(primitive["attributes"]["POSITION"])
                corners = [row[0] for row in self.values(primitive["indices"])]
                for i in range(0, len(corners), 3):
                    points = [positions[c] for c in corners[i:i + 3]]
                    for a, b in zip(points, points[1:] + points[:1]):
                        edges[min(a, b), max(a, b)] += 1
            if edges and set(edges.values()) == {2}:
                return True
        return False

    def triangles(self, mesh):
        for primitive in mesh["primitives"]:
            positions = self.values(primitive["attributes"]["POSITION"])
            corners = [row[0] for row in self.values(primitive["indices"])]
            for i in range(0, len(corners), 3):
                yield [positions[c] for c in corners[i:i + 3]]

    def nested(self):
        """Whether a corner of a closed mesh that transmits lies in another one; None: not judged, as
        nodes move them, or a mesh has several materials that transmit."""
        solid = {m["index"] for m in self.materials if m["solid"]}
        if any(len(solid & {p.get("material", -1) for p in m["primitives"]}) > 1
               for m in self.meshes()):
            return None
        meshes = [m for m in self.meshes()
                  if any(p.get("material", -1) in solid for p in m["primitives"])]
        if len(meshes) < 2:
            return False
        if any(key in node for node in self.nodes() if "mesh" in node or "children" in node
               for key in ("translation", "rotation", "scale", "matrix")):
            return None
        shapes = [list(self.triangles(mesh)) for mesh in meshes]
        return any(lies_in(corner, b) for a, b in permutations(shapes, 2)
                   if may_touch(a, b) for corner in {triangle[0] for triangle in a})

    def material(self, index):
        """The numbers of one, with glTF's defaults; those of layers in `extensions`."""
        written = self.json["materials"][index] if index >= 0 else {}
        base = written.get("pbrMetallicRoughness", {})
        extensions = written.get("extensions", {})

        def number(extension, key, otherwise):
            return extensions.get("KHR_materials_" + extension, {}).get(key, otherwise)

        textures = {key for holder in (written, base, *extensions.values())
                    for key in holder if key.endswith("Texture")}
        own = written.get("extras", {}).get("hipmap", {})
        own = own if isinstance(own, dict) else {}
        bare = not own.get("boundary", True)  # an inside without a surface
        unlit = "KHR_materials_unlit" in extensions or bare
        metallic = 0 if unlit else base.get("metallicFactor", 1)
        transmission = 0 if unlit else number("transmission", "transmissionFactor", 0)
        step = number("ior", "ior", 1.5)
        f0 = ((step - 1) / (step + 1)) ** 2 * max(number("specular", "specularColorFactor", [1]))
        f0 *= 0 if unlit else number("specular", "specularFactor", 1)
        anisotropy = 0 if unlit else number("anisotropy", "anisotropyStrength", 0)
        attenuation = extensions.get("KHR_materials_volume", {})
        through = transmission == 0 and metallic < 1 and not unlit and number(
            "diffuse_transmission", "diffuseTransmissionFactor", 0) > 0
        solid = ((1 - metallic) * transmission > 0 or through) and self.closed(index)
        scatters = any(own["medium"].get("scattering", [0])) if "medium" in own else any(
            number("volume_scatter", "multiscatterColor", [0]))
        facts = {
            "name": written.get("name") or (f"material {index}" if index >= 0
                                            else "(no material)"),
            "textures": textures, "unlit": unlit, "anisotropy": anisotropy,
            "roughness": max(base.get("roughnessFactor", 1), 0.03 if anisotropy > 0 else 0),
            "directed": self.directed(index),
            "matt": (1 - metallic) * (1 - transmission) > 0 and
                    not unlit and any(base.get("baseColorFactor", [1, 1, 1])[:3]),
            "reflects": (metallic > 0 and any(base.get("baseColorFactor", [1])[:3])) or
                        ((1 - metallic) * (1 - transmission) > 0 and f0 > 0),
            "glass": (1 - metallic) * transmission > 0,
            "index": index, "solid": solid and not through, "holds": solid,
            "subsurface": solid and scatters,
            "medium": bare or ("medium" in own and solid and not scatters),
            "absorbs": "attenuationDistance" in attenuation and "medium" not in own and
                       not scatters and min(attenuation.get("attenuationColor", [1])) < 1,
            "glows": any(base.get("baseColorFactor", [1, 1, 1])[:3] if unlit and not bare
                         else written.get("emissiveFactor", [0])),
            "alpha_mode": written.get("alphaMode", "OPAQUE"),
            "alpha": base.get("baseColorFactor", [1] * 4)[3],
            "cutoff": written.get("alphaCutoff", 0.5),
            "coat": number("clearcoat", "clearcoatFactor", 0),
            "coat_roughness": max(
                number("clearcoat", "clearcoatRoughnessFactor", 0),
                0.03 if textures & {"normalTexture", "clearcoatNormalTexture"} else 0),
            "sheen": any(number("sheen", "sheenColorFactor", [0])) and transmission == 0 and not unlit,
            "through": through and any(
                number("diffuse_transmission", "diffuseTransmissionColorFactor", [1])),
            "dispersion": number("dispersion", "dispersion", 0),
            "model": "" if unlit else own.get("reflection", ""), "mirror": False,
        }
        return self.modelled(facts, own, base) if facts["model"] else facts

    @staticmethod
    def modelled(facts, own, base):
        """The same of a material that reflects by a model of hipmap's own key, which has no layers."""
        colour = base.get("baseColorFactor", [1, 1, 1])[:3]
        facts.update(glass=False, solid=False, holds=False, subsurface=False, medium=False,
                     coat=0, sheen=False, through=False)
        model = facts["model"]
        facts["textures"] &= {"baseColorTexture", "normalTexture", "emissiveTexture"} | (
            {"metallicRoughnessTexture"} if model == "schlick" else set()) | (
            {"anisotropyTexture"} if model != "phong" else set())
        if model != "schlick":
            facts.update(
                reflects=any(own["specular"]),
                matt=any(c * (1 - s) > 0 for c, s in zip(colour, own["specular"])), anisotropy=0)
        if model in ("phong", "lafortune"):
            facts["roughness"] = (2 * own["exponent"] + 1) ** -0.25
        if model == "lafortune":
            facts["anisotropy"] = abs(own["coefficients"][0] - own["coefficients"][1])
        if model == "ward":
            facts.update(roughness=min(own["slopes"]) ** 0.5,
                         anisotropy=max(own["slopes"]) - min(own["slopes"]))
        if model != "schlick":
            return facts
        roughness = base.get("roughnessFactor", 1)
        facts.update(roughness=roughness ** 0.25, reflects=True, mirror=roughness < 0.5,
                     matt=roughness > 0.5 and any(colour), anisotropy=1 - own.get("isotropy", 1))
        return facts

    def directed(self, index):
        """Something says along what reflections are stretched."""
        return any(key in p["attributes"] for p in self.primitives if p.get("material", -1) == index
                   for key in ("TANGENT", "TEXCOORD_0", "TEXCOORD_1"))

    def rendered_pictures(self, material):
        """Pictures that are multiplied into the factors."""
        plain = {"baseColorTexture", "metallicRoughnessTexture", "emissiveTexture"}
        if material["unlit"]:
            plain = {"baseColorTexture"}
        return material["textures"] & (plain | set(RENDERED))
