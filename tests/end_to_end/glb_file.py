"""Reads the parts of a .glb file that the tests compare."""

import json
import struct

COMPONENTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
FORMATS = {5121: "B", 5123: "H", 5125: "I", 5126: "f"}


class GlbFile:
    """json: the document.  values(accessor): its numbers, flat."""

    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        magic, version, length = struct.unpack_from("<4sII", data)
        assert (magic, version, length) == (b"glTF", 2, len(data)), f"{path}: not a .glb"
        json_length, json_type = struct.unpack_from("<I4s", data, 12)
        assert json_type == b"JSON", f"{path}: no JSON chunk"
        self.json = json.loads(data[20:20 + json_length])
        self.binary = data[28 + json_length:]

    def values(self, index):
        accessor = self.json["accessors"][index]
        view = self.json["bufferViews"][accessor["bufferView"]]
        count = accessor["count"] * COMPONENTS[accessor["type"]]
        layout = f"<{count}{FORMATS[accessor['componentType']]}"
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        return struct.unpack_from(layout, self.binary, start)
