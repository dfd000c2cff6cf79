"""Builds the smallest scenes that show an effect each (docs/effects.md), by Python alone.

    python3 assets/effects.py FOLDER

Metres; glTF's axes (y up).  Each is a stage of floor, wall, lamp and camera with something on it.
"""

import json
import math
import os
import struct
import sys
import zlib

WHITE = (0.74, 0.74, 0.72)
FLOAT, SHORT = 5126, 5123
STORED_LIMIT = 65535  # bytes in a stored block of deflate


def png(width, height, pixel):
    """pixel(x, y): RGBA, 0 to 255, from the top left.  Not compressed, so that every zlib writes the
    same bytes."""
    rows = b"".join(b"\0" + bytes(v for x in range(width) for v in pixel(x, y))
                    for y in range(height))
    assert len(rows) <= STORED_LIMIT
    block = b"\x01" + struct.pack("<HH", len(rows), len(rows) ^ 0xFFFF) + rows
    stream = b"\x78\x01" + block + struct.pack(">I", zlib.adler32(rows))

    def chunk(kind, data):
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))

    header = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", stream) +
            chunk(b"IEND", b""))


def byte(value):
    return max(0, min(255, round(255 * value)))


class Glb:
    """A glTF file in the making."""

    def __init__(self):
        self.root = {"asset": {"version": "2.0", "generator": "hipmap assets/effects.py"},
                     "scene": 0, "scenes": [{"nodes": []}], "nodes": [], "meshes": [],
                     "materials": [], "accessors": [], "bufferViews": []}
        self.binary = b""

    def view(self, data):
        self.root["bufferViews"].append(
            {"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data)})
        self.binary += data + b"\0" * (-len(data) % 4)
        return len(self.root["bufferViews"]) - 1

    def accessor(self, rows, kind, component=FLOAT):
        flat = [number for row in rows for number in row]
        letter = "f" if component == FLOAT else "H"
        accessor = {"bufferView": self.view(struct.pack(f"<{len(flat)}{letter}", *flat)),
                    "componentType": component, "count": len(rows), "type": kind}
        if kind == "VEC3":
            accessor["min"] = [min(row[i] for row in rows) for i in range(3)]
            accessor["max"] = [max(row[i] for row in rows) for i in range(3)]
        self.root["accessors"].append(accessor)
        return len(self.root["accessors"]) - 1

    def node(self, name, **parts):
        self.root["nodes"].append({"name": name, **parts})
        self.root["scenes"][0]["nodes"].append(len(self.root["nodes"]) - 1)

    def texture(self, data, **sampler):
        for key, value in (("images", {"bufferView": self.view(data), "mimeType": "image/png"}),
                           ("samplers", sampler)):
            self.root.setdefault(key, []).append(value)
        index = len(self.root["images"]) - 1
        self.root.setdefault("textures", []).append({"source": index, "sampler": index})
        return {"index": index}

    def material(self, name, color, **parts):
        """Matt unless `parts` says otherwise."""
        base = {"baseColorFactor": [*color, 1], "metallicFactor": 0, "roughnessFactor": 1}
        base.update(parts.pop("base", {}))
        extensions = {"KHR_materials_specular": {"specularFactor": 0}}
        extensions.update(parts.pop("extensions", {}))
        if "KHR_materials_ior" in extensions:
            del extensions["KHR_materials_specular"]
        used = self.root.setdefault("extensionsUsed", [])
        used.extend(sorted(extensions.keys() - set(used)))
        self.root["materials"].append(
            {"name": name, "pbrMetallicRoughness": base, "extensions": extensions, **parts})
        return len(self.root["materials"]) - 1

    def mesh(self, name, material, shape, **attributes):
        """shape: positions, normals, texture coordinates and faces."""
        positions, normals, uvs, faces = shape
        described = {"POSITION": self.accessor(positions, "VEC3"),
                     "NORMAL": self.accessor(normals, "VEC3"),
                     "TEXCOORD_0": self.accessor(uvs, "VEC2")}
        for key, rows in attributes.items():
            described[key] = self.accessor(rows, "VEC4")
        indices = self.accessor([(i,) for face in faces for i in face], "SCALAR", SHORT)
        self.root["meshes"].append({"name": name, "primitives": [
            {"attributes": described, "indices": indices, "material": material}]})
        self.node(name, mesh=len(self.root["meshes"]) - 1)

    def write(self, path):
        self.root["buffers"] = [{"byteLength": len(self.binary)}]
        text = json.dumps(self.root, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        with open(path, "wb") as file:
            file.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(self.binary)))
            file.write(struct.pack("<I4s", len(text), b"JSON") + text)
            file.write(struct.pack("<I4s", len(self.binary), b"BIN\0") + self.binary)


def quad(corner, right, up):
    """From its lower left corner; the front is where `right` and `up` run counter-clockwise."""
    normal = (right[1] * up[2] - right[2] * up[1], right[2] * up[0] - right[0] * up[2],
              right[0] * up[1] - right[1] * up[0])
    length = math.hypot(*normal)
    normal = tuple(n / length for n in normal)
    positions = [tuple(c + i * r + j * u for c, r, u in zip(corner, right, up))
                 for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
    return positions, [normal] * 4, [(0, 1), (1, 1), (1, 0), (0, 0)], [(0, 1, 2), (0, 2, 3)]


def sphere(centre, radius, segments=32, rings=16):
    positions, normals, uvs, faces = [], [], [], []
    for ring in range(rings + 1):
        down = math.pi * ring / rings
        for segment in range(segments + 1):
            turn = 2 * math.pi * (segment % segments) / segments
            across = 0.0 if ring in (0, rings) else math.sin(down)
            n = (across * math.sin(turn), math.cos(down), across * math.cos(turn))
            normals.append(n)
            positions.append(tuple(c + radius * v for c, v in zip(centre, n)))
            uvs.append((segment / segments, ring / rings))
    for ring in range(rings):
        for segment in range(segments):
            a = ring * (segments + 1) + segment
            b = a + segments + 1
            if ring > 0:
                faces.append((a, b, a + 1))
            if ring < rings - 1:
                faces.append((a + 1, b, b + 1))
    return positions, normals, uvs, faces


def stage(radiance=20):
    glb = Glb()
    white = glb.material("White", WHITE)
    glb.mesh("Floor", white, quad((-1.5, 0, 1.5), (3, 0, 0), (0, 0, -3)))
    glb.mesh("Wall", white, quad((-1.5, 0, -1), (3, 0, 0), (0, 2.5, 0)))
    if radiance > 0:
        lamp = glb.material(
            "Lamp", (0, 0, 0), emissiveFactor=[1, 1, 1],
            extensions={"KHR_materials_emissive_strength": {"emissiveStrength": radiance}})
        glb.mesh("Lamp", lamp, quad((-0.9, 2, 0.6), (0.5, 0, 0), (0, 0, 0.5)))
    glb.root["cameras"] = [{"type": "perspective", "name": "Camera", "perspective": {
        "yfov": 0.68, "aspectRatio": 1, "znear": 0.01}}]
    tilt = math.radians(-9)
    glb.node("Camera", camera=0, translation=[0, 0.95, 3],
             rotation=[math.sin(tilt / 2), 0, 0, math.cos(tilt / 2)])
    return glb


def add_alpha(glb):
    """A lattice with holes, and a red pane that lets half of the light pass."""
    def lattice(x, y):
        bar = x % 16 < 5 or y % 16 < 5
        return (200, 160, 90, 255 if bar else 0)

    picture = glb.texture(png(64, 64, lattice))
    lattice = glb.material("Lattice", (1, 1, 1), alphaMode="MASK", doubleSided=True,
                           base={"baseColorTexture": picture})
    pane = glb.material("Pane", (0.8, 0.1, 0.08), alphaMode="BLEND", doubleSided=True,
                        base={"baseColorFactor": [0.8, 0.1, 0.08, 0.5]})
    glb.mesh("Lattice", lattice, quad((-0.75, 0.02, 0.2), (0.7, 0, 0), (0, 0.9, 0)))
    glb.mesh("Pane", pane, quad((0.1, 0.02, 0.2), (0.6, 0, -0.3), (0, 0.9, 0)))


def add_normal_maps(glb):
    """Domes on a panel and on a ball."""
    def dome(x, y):
        u, v = ((x + 0.5) % 16) / 8 - 1, ((y + 0.5) % 16) / 8 - 1
        inside = u * u + v * v < 0.8
        nx, ny = (0.8 * u, -0.8 * v) if inside else (0, 0)
        nz = math.sqrt(1 - nx * nx - ny * ny)
        return (byte((nx + 1) / 2), byte((ny + 1) / 2), byte((nz + 1) / 2), 255)

    picture = glb.texture(png(64, 64, dome))
    bumpy = glb.material("Bumpy", (0.7, 0.6, 0.45), normalTexture=picture)
    glb.mesh("Panel", bumpy, quad((-0.85, 0.02, -0.1), (0.8, 0, -0.2), (0, 0.9, 0)))
    shiny = glb.material("Shiny bumps", (0.9, 0.75, 0.4), normalTexture=picture,
                         base={"metallicFactor": 1, "roughnessFactor": 0.25})
    glb.mesh("Ball", shiny, sphere((0.5, 0.4, 0.1), 0.38))


def add_vertex_colours(glb):
    plain = glb.material("Plain", (0.9, 0.9, 0.9))
    panel = quad((-0.85, 0.02, -0.1), (0.8, 0, -0.2), (0, 0.9, 0))
    glb.mesh("Panel", plain, panel,
             COLOR_0=[(1, 0, 0, 1), (0, 1, 0, 1), (0, 0, 1, 1), (1, 1, 0, 1)])
    ball = sphere((0.5, 0.4, 0.1), 0.38)
    glb.mesh("Ball", plain, ball,
             COLOR_0=[tuple(0.5 + 0.5 * c for c in n) + (1,) for n in ball[1]])


def add_emissive_picture(glb):
    """A sign of four colours is the only light."""
    def sign(x, y):
        if (x % 8 < 2) or (y % 8 < 2):
            return (0, 0, 0, 255)
        return ((255, 60, 30, 255), (40, 255, 80, 255), (50, 90, 255, 255),
                (255, 230, 120, 255))[(x // 8 + y // 8) % 4]

    picture = glb.texture(png(32, 16, sign), magFilter=9728)
    glowing = glb.material(
        "Sign", (0.02, 0.02, 0.02), emissiveFactor=[1, 1, 1], emissiveTexture=picture,
        extensions={"KHR_materials_emissive_strength": {"emissiveStrength": 6}})
    glb.mesh("Sign", glowing, quad((-0.8, 0.15, -0.5), (1.6, 0, 0), (0, 0.8, 0)))
    glb.mesh("Ball", 0, sphere((0.1, 0.2, 0.2), 0.2))


def add_clearcoat(glb):
    """The same rough red metal, bare and with a smooth clear coat."""
    paint = {"metallicFactor": 1, "roughnessFactor": 0.5}
    bare = glb.material("Bare paint", (0.6, 0.06, 0.05), base=paint)
    coated = glb.material("Coated paint", (0.6, 0.06, 0.05), base=paint, extensions={
        "KHR_materials_clearcoat": {"clearcoatFactor": 1, "clearcoatRoughnessFactor": 0}})
    glb.mesh("Bare ball", bare, sphere((-0.45, 0.38, 0), 0.38, 40, 20))
    glb.mesh("Coated ball", coated, sphere((0.45, 0.38, 0), 0.38, 40, 20))


def add_depth_of_field(glb):
    """Balls at different distances; the middle one is sharp."""
    colors = ((0.7, 0.15, 0.1), (0.75, 0.6, 0.2), (0.2, 0.55, 0.25), (0.15, 0.3, 0.7))
    for i, color in enumerate(colors):
        material = glb.material(f"Ball {i}", color)
        glb.mesh(f"Ball {i}", material, sphere((0.42 * i - 0.63, 0.17, 0.9 - 0.55 * i), 0.17))
    glb.root["nodes"][-5]["extras"] = {"hipmap": {"aperture_radius": 0.06, "focus_distance": 2.2}}


def add_soft_shadows(glb):
    """A sphere lamp over a ball, a mirror and a pole."""
    glb.root["extensions"] = {"KHR_lights_punctual": {"lights": [
        {"type": "point", "intensity": 683 * 4, "extras": {"hipmap": {"radius": 0.2}}}]}}
    glb.root["extensionsUsed"].append("KHR_lights_punctual")
    glb.node("Lamp", translation=[-0.6, 1.7, 0.6],
             extensions={"KHR_lights_punctual": {"light": 0}})
    glb.mesh("Ball", 0, sphere((-0.35, 0.3, 0.1), 0.3))
    mirror = glb.material("Mirror", (0.9, 0.9, 0.9),
                          base={"metallicFactor": 1, "roughnessFactor": 0})
    glb.mesh("Mirror ball", mirror, sphere((0.45, 0.35, 0.2), 0.35, 64, 32))


SCENES = {
    "alpha": (add_alpha, 20),
    "clearcoat": (add_clearcoat, 20),
    "depth_of_field": (add_depth_of_field, 20),
    "emissive_picture": (add_emissive_picture, 0),
    "normal_maps": (add_normal_maps, 20),
    "soft_shadows": (add_soft_shadows, 0),
    "vertex_colours": (add_vertex_colours, 20),
}


def build_all(folder):
    """Writes NAME.glb of every scene; returns the names."""
    for name, (add, radiance) in SCENES.items():
        glb = stage(radiance)
        add(glb)
        glb.write(os.path.join(folder, name + ".glb"))
    return sorted(SCENES)


if __name__ == "__main__":
    build_all(sys.argv[1])
