"""What a .glb shows: triangles in the world with their materials, lights and cameras."""

import json
import math
import struct

_FORMATS = {5121: "B", 5123: "H", 5125: "I", 5126: "f"}
_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


class Glb:
    """A .glb in memory."""

    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        length, = struct.unpack_from("<I", data, 12)
        self.json = json.loads(data[20:20 + length])
        self.buffer = data[28 + length:]

    def array(self, index):
        """The elements of an accessor, as tuples."""
        accessor = self.json["accessors"][index]
        view = self.json["bufferViews"][accessor["bufferView"]]
        width = _WIDTHS[accessor["type"]]
        layout = f"<{width}{_FORMATS[accessor['componentType']]}"
        begin = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        size = struct.calcsize(layout) * accessor["count"]
        return list(struct.iter_unpack(layout, self.buffer[begin:begin + size]))

    def placed_nodes(self):
        """Every node with its matrix to the world, three rows of four."""
        waiting = [(root, _IDENTITY) for root in self.json["scenes"][0]["nodes"]]
        while waiting:
            index, parent = waiting.pop()
            node = self.json["nodes"][index]
            matrix = _times(parent, _local(node))
            yield node, matrix
            waiting += [(child, matrix) for child in node.get("children", [])]

    def triangles(self, digits=3):
        """Sorted (material, corners) of all triangles in the world, rounded to a millimetre, each
        beginning with its least corner."""
        found = []
        for node, matrix in self.placed_nodes():
            for primitive in self.json["meshes"][node["mesh"]]["primitives"] \
                    if "mesh" in node else ():
                points = [_rounded(_apply(matrix, p), digits) for p in
                          self.array(primitive["attributes"]["POSITION"])]
                corners = [points[i] for i, in self.array(primitive["indices"])]
                name = self.material(primitive)
                found += [(name, _from_least(corners[i:i + 3]))
                          for i in range(0, len(corners), 3)]
        return sorted(found)

    def material(self, primitive):
        """The name of a primitive's material; "no material" without one."""
        if "material" not in primitive:
            return "no material"
        return self.json["materials"][primitive["material"]]["name"]

    def materials(self):
        """Materials by their names."""
        return {material["name"]: material for material in self.json.get("materials", [])}

    def lights(self):
        """Sorted (type, intensity, colour, position) of the lights of KHR_lights_punctual."""
        found = []
        for node, matrix in self.placed_nodes():
            punctual = node.get("extensions", {}).get("KHR_lights_punctual")
            if punctual:
                light = self.json["extensions"]["KHR_lights_punctual"]["lights"][punctual["light"]]
                # The exporter leaves colours unscaled, the add-on the intensity.
                power = [round(c * light["intensity"], 1) for c in light.get("color", (1, 1, 1))]
                found.append((light["type"], power, _rounded((row[3] for row in matrix), 3),
                              _rounded((-row[2] for row in matrix), 3)))
        return sorted(found)

    def cameras(self):
        """(entry without names, position, direction) of the cameras."""
        return [({key: _numbers(value) for key, value in self.json["cameras"][node["camera"]].items()
                  if key != "name"}, _rounded((row[3] for row in matrix), 3),
                 _rounded((-row[2] for row in matrix), 3))
                for node, matrix in self.placed_nodes() if "camera" in node]


_IDENTITY = ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0))


def _numbers(value):
    return {k: round(v, 5) for k, v in value.items()} if isinstance(value, dict) else value


# So that no plain number lies where rounding turns.
_OFF = 0.000123


def _rounded(values, digits):
    return tuple(round(v + _OFF, digits) + 0.0 for v in values)


def _from_least(corners):
    at = corners.index(min(corners))
    return tuple(corners[at:] + corners[:at])


def _apply(matrix, point):
    return tuple(sum(row[i] * point[i] for i in range(3)) + row[3] for row in matrix)


def _times(a, b):
    return tuple(tuple(sum(row[k] * b[k][j] for k in range(3)) + (row[3] if j == 3 else 0)
                       for j in range(4)) for row in a)


def _local(node):
    if "matrix" in node:
        m = node["matrix"]
        return tuple(tuple(m[4 * column + row] for column in range(4)) for row in range(3))
    x, y, z, w = node.get("rotation", (0, 0, 0, 1))
    length = math.sqrt(x * x + y * y + z * z + w * w)
    x, y, z, w = x / length, y / length, z / length, w / length
    turn = ((1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
            (2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
            (2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)))
    scale, move = node.get("scale", (1, 1, 1)), node.get("translation", (0, 0, 0))
    return tuple((*(turn[r][c] * scale[c] for c in range(3)), move[r]) for r in range(3))
