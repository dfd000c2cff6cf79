#!/usr/bin/env python3
"""Writes a room of wrinkled balls whose faces are divided without changing their shape.

    bench/subdivided_room.py OUT.glb PARTS

Every face is divided into PARTS x PARTS faces in its plane, so that scenes of 66,570 PARTS^2 faces
differ in nothing else.  Of the balls one is diffuse and one of rough metal, both sunk into the
floor, one is glass and a small one is the lamp.  Normals are interpolated, so that shading is the
same too.
"""

import array
import itertools
import json
import math
import struct
import sys

DIVISIONS = 5  # of an icosahedron: 20 * 4^5 faces a ball
LAMP_DIVISIONS = 4
MATERIALS = [
    ("Wall", {"baseColorFactor": [0.7, 0.7, 0.7, 1], "metallicFactor": 0}, {}),
    ("Clay", {"baseColorFactor": [0.7, 0.4, 0.3, 1], "metallicFactor": 0}, {}),
    ("Glass", {"roughnessFactor": 0, "metallicFactor": 0}, {
        "KHR_materials_transmission": {"transmissionFactor": 1},
        "KHR_materials_ior": {"ior": 1.5}, "KHR_materials_volume": {"thicknessFactor": 1}}),
    ("Metal", {"baseColorFactor": [0.8, 0.7, 0.5, 1], "roughnessFactor": 0.25}, {}),
    ("Lamp", {"baseColorFactor": [0, 0, 0, 1], "metallicFactor": 0}, {}),
]


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return tuple(x / length for x in v)


def geodesic_sphere(divisions):
    """(points, faces) of an icosahedron divided onto the unit sphere."""
    golden = (1 + math.sqrt(5)) / 2
    points = [unit(v[s:] + v[:s]) for s in range(3)
              for v in ((0, a, b * golden) for a, b in itertools.product((-1, 1), repeat=2))]
    near = 1.1  # of edges of the unit icosahedron, 1.05, and nothing else
    faces = []
    for a, b, c in itertools.combinations(range(12), 3):
        if max(math.dist(points[i], points[j]) for i, j in ((a, b), (b, c), (c, a))) < near:
            outside = determinant(points[a], points[b], points[c]) > 0
            faces.append((a, b, c) if outside else (a, c, b))
    for _ in range(divisions):
        faces = divide(points, faces)
    return points, faces


def determinant(a, b, c):
    return (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
            a[2] * (b[0] * c[1] - b[1] * c[0]))


def divide(points, faces):
    middles = {}

    def middle(a, b):
        key = (min(a, b), max(a, b))
        if key not in middles:
            middles[key] = len(points)
            points.append(unit(tuple(x + y for x, y in zip(points[a], points[b]))))
        return middles[key]

    out = []
    for a, b, c in faces:
        ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
        out += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return out


def ball(centre, radius, wrinkle, divisions=DIVISIONS):
    """(positions, normals, faces); normals are those of the sphere."""
    points, faces = geodesic_sphere(divisions)

    def place(p):
        r = radius * (1 + wrinkle * math.sin(9 * p[0]) * math.sin(8 * p[1]) * math.sin(7 * p[2]))
        return tuple(c + r * x for c, x in zip(centre, p))

    return [place(p) for p in points], points, faces


def quads(corners_of):
    """A mesh of single flat quads, each given by its corners counter-clockwise from the front."""
    positions, normals, faces = [], [], []
    for corners in corners_of:
        u = [b - a for a, b in zip(corners[0], corners[1])]
        v = [b - a for a, b in zip(corners[0], corners[3])]
        normal = unit((u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                       u[0] * v[1] - u[1] * v[0]))
        first = len(positions)
        positions += corners
        normals += [normal] * 4
        faces += [(first, first + 1, first + 2), (first, first + 2, first + 3)]
    return positions, normals, faces


def room():
    x, y, z = 4.0, 3.0, 4.0
    corner = [(i, j, k) for k in (0, z) for j in (0, y) for i in (0, x)]
    sides = [(0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3), (0, 1, 3, 2)]
    return quads([[corner[i] for i in side] for side in sides])


def subdivided(mesh, parts):
    """Each face as parts x parts in its plane, corners shared within a face's old edges."""
    positions, normals, faces = mesh
    out_p, out_n, out_f, numbers = array.array("f"), array.array("f"), array.array("I"), {}

    def number(face, i, j):
        weights = [(parts - i - j, face[0]), (i, face[1]), (j, face[2])]
        key = tuple(sorted((corner, w) for w, corner in weights if w > 0))
        if len(key) == 3:
            key = (face, i, j)
        if key not in numbers:
            numbers[key] = len(out_p) // 3
            ordered = sorted(weights, key=lambda entry: entry[1])
            for k in range(3):
                out_p.append(sum(w * positions[c][k] for w, c in ordered) / parts)
            out_n.extend(unit([sum(w * normals[c][k] for w, c in ordered) for k in range(3)]))
        return numbers[key]

    for face in faces:
        for i in range(parts):
            for j in range(parts - i):
                a, b, c = number(face, i, j), number(face, i + 1, j), number(face, i, j + 1)
                out_f.extend((a, b, c))
                if i + j + 2 <= parts:
                    out_f.extend((b, number(face, i + 1, j + 1), c))
    return out_p, out_n, out_f


class Writer:
    """Collects meshes into one binary chunk."""

    def __init__(self):
        self.binary = bytearray()
        self.root = {
            "asset": {"version": "2.0", "generator": "hipmap bench/subdivided_room.py"},
            "scene": 0, "scenes": [{"nodes": []}], "nodes": [], "meshes": [], "accessors": [],
            "bufferViews": [], "cameras": [{"type": "perspective", "perspective": {
                "yfov": 0.8, "aspectRatio": 1.5, "znear": 0.1}}],
            "extensionsUsed": ["KHR_materials_transmission", "KHR_materials_ior",
                               "KHR_materials_volume"],
            "materials": [{"name": name, "pbrMetallicRoughness": pbr, "extensions": extensions}
                          for name, pbr, extensions in MATERIALS]}
        self.root["materials"][-1]["emissiveFactor"] = [1, 1, 1]
        self.root["materials"][-1]["extensions"] = {
            "KHR_materials_emissive_strength": {"emissiveStrength": 20}}
        self.root["extensionsUsed"].append("KHR_materials_emissive_strength")
        self.add_node({"name": "Camera", "camera": 0, "translation": [2, 1.5, 9.5]})

    def add_node(self, node):
        self.root["scenes"][0]["nodes"].append(len(self.root["nodes"]))
        self.root["nodes"].append(node)

    def accessor(self, data, kind, component):
        size = {"VEC3": 3, "SCALAR": 1}[kind]
        entry = {"bufferView": len(self.root["bufferViews"]), "componentType": component,
                 "count": len(data) // size, "type": kind}
        if kind == "VEC3":
            entry["min"] = [min(data[k::3]) for k in range(3)]
            entry["max"] = [max(data[k::3]) for k in range(3)]
        self.root["bufferViews"].append({"buffer": 0, "byteOffset": len(self.binary),
                                         "byteLength": 4 * len(data)})
        self.binary += data.tobytes()
        self.root["accessors"].append(entry)
        return len(self.root["accessors"]) - 1

    def add(self, name, mesh, material):
        positions, normals, faces = mesh
        self.root["meshes"].append({"name": name, "primitives": [{
            "attributes": {"POSITION": self.accessor(positions, "VEC3", 5126),
                           "NORMAL": self.accessor(normals, "VEC3", 5126)},
            "indices": self.accessor(faces, "SCALAR", 5125), "material": material}]})
        self.add_node({"name": name, "mesh": len(self.root["meshes"]) - 1})

    def write(self, path):
        self.root["buffers"] = [{"byteLength": len(self.binary)}]
        text = json.dumps(self.root).encode()
        text += b" " * (-len(text) % 4)
        with open(path, "wb") as file:
            file.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(self.binary)))
            file.write(struct.pack("<I4s", len(text), b"JSON") + text)
            file.write(struct.pack("<I4s", len(self.binary), b"BIN\0") + self.binary)


def main():
    path, parts = sys.argv[1], int(sys.argv[2])
    writer = Writer()
    writer.add("Room", subdivided(room(), parts), 0)
    writer.add("Lamp", subdivided(ball((2.2, 2.5, 2), 0.2, 0, LAMP_DIVISIONS), parts), 4)
    for i, (x, y, material) in enumerate(((0.8, 0.42, 1), (2.0, 0.7, 2), (3.2, 0.42, 3))):
        mesh = ball((x, y, 1.2 + 0.8 * i), 0.5, 0.15)
        writer.add(f"Ball {i + 1}", subdivided(mesh, parts), material)
    writer.write(path)


if __name__ == "__main__":
    main()
