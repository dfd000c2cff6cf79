"""Writes glTF files of a few meshes, materials and pictures, by Python alone; see effects.py."""

import json
import math
import struct
import zlib

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
        if kind == "VEC3" or kind == "SCALAR" and component == FLOAT:
            accessor["min"] = [min(row[i] for row in rows) for i in range(len(rows[0]))]
            accessor["max"] = [max(row[i] for row in rows) for i in range(len(rows[0]))]
        self.root["accessors"].append(accessor)
        return len(self.root["accessors"]) - 1

    def node(self, name, **parts):
        self.root["nodes"].append({"name": name, **parts})
        self.root["scenes"][0]["nodes"].append(len(self.root["nodes"]) - 1)

    def animate(self, name, **parts):
        """Moves a node: for each part of its transform an interpolation, times in seconds, and rows
        of numbers."""
        node = next(i for i, node in enumerate(self.root["nodes"]) if node["name"] == name)
        animation = {"name": name, "channels": [], "samplers": []}
        for part, (interpolation, times, rows) in parts.items():
            animation["channels"].append({"sampler": len(animation["samplers"]),
                                          "target": {"node": node, "path": part}})
            animation["samplers"].append({
                "input": self.accessor([(time,) for time in times], "SCALAR"),
                "output": self.accessor(rows, "VEC4" if part == "rotation" else "VEC3"),
                "interpolation": interpolation})
        self.root.setdefault("animations", []).append(animation)

    def spot(self, name, place, rotation, candela, angle):
        """Along -Z of `rotation`, of even intensity in all but the outer tenth of its cone."""
        self.root.setdefault("extensionsUsed", []).append("KHR_lights_punctual")
        self.root["extensions"] = {"KHR_lights_punctual": {"lights": [
            {"type": "spot", "name": name, "intensity": candela,
             "spot": {"innerConeAngle": 0.9 * angle, "outerConeAngle": angle}}]}}
        self.node(name, translation=list(place), rotation=list(rotation),
                  extensions={"KHR_lights_punctual": {"light": 0}})

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


def box(low, high):
    """Seen from outside."""
    (x, y, z), (dx, dy, dz) = low, (b - a for a, b in zip(low, high))
    sides = [quad((x, y, z + dz), (dx, 0, 0), (0, dy, 0)),
             quad((x + dx, y, z), (-dx, 0, 0), (0, dy, 0)),
             quad((x, y, z), (0, 0, dz), (0, dy, 0)),
             quad((x + dx, y, z + dz), (0, 0, -dz), (0, dy, 0)),
             quad((x, y + dy, z + dz), (dx, 0, 0), (0, 0, -dz)),
             quad((x, y, z), (dx, 0, 0), (0, 0, dz))]
    positions, normals, uvs, faces = ([row for side in sides for row in side[i]] for i in range(4))
    return positions, normals, uvs, [tuple(4 * (i // 2) + c for c in face)
                                     for i, face in enumerate(faces)]


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
