"""What the tools left in the folder of a render."""

import base64
import json
import os
import struct

SIGNATURE = b"\x89PNG\r\n\x1a\n"


class ReportError(Exception):
    """One line: file, what is wrong, what to do."""


class Picture:
    """A .png file.  width, height: of what it shows, without the legend below it, pixels.
    legend: entries with "colours" and "text"."""

    def __init__(self, path, listed=None):
        self.name = os.path.splitext(os.path.basename(path))[0]
        self.data = read(path)
        if self.data[:8] != SIGNATURE or len(self.data) < 24:
            raise ReportError(f"{path}: is not a PNG picture; run pipeline.sh again")
        size = struct.unpack_from(">II", self.data, 16)
        listed = listed or {}
        self.width = listed.get("width", size[0])
        self.height = listed.get("height", size[1])
        self.legend = listed.get("legend", [])

    def uri(self):
        return "data:image/png;base64," + base64.b64encode(self.data).decode("ascii")


class Results:
    """stats, partition: what render --stats and preprocess --json wrote; the latter may be {}.
    image: the picture.  overlays: pictures of the same view, to lay over it.  others: of another
    shape, as where render was given a --size that preprocess was not."""

    def __init__(self, folder):
        self.stats = read_json(os.path.join(folder, "stats.json"), "error", "passes_done")
        path = os.path.join(folder, "partition.json")
        self.partition = read_json(path, "maps") if os.path.exists(path) else {}
        self.image = Picture(find_image(folder, self.stats))
        listed = self.stats.get("pictures", []) + self.partition.get("pictures", [])
        pictures = [Picture(path, entry) for entry in listed
                    if os.path.exists(path := beside(folder, entry["file"]))]
        self.overlays = [picture for picture in pictures if self.is_same_view(picture)]
        self.others = [picture for picture in pictures if not self.is_same_view(picture)]

    def is_same_view(self, picture):
        """Heights are whole, so shapes agree to a pixel."""
        across = picture.width * self.image.height - picture.height * self.image.width
        return abs(across) <= max(self.image.width, picture.width)

    def title(self):
        scene = self.stats.get("scene", {}).get("file") or self.image.name
        return os.path.basename(scene)


def read(path):
    try:
        with open(path, "rb") as file:
            return file.read()
    except OSError as problem:
        raise ReportError(f"{path}: {problem.strerror}; run pipeline.sh, or render with --stats "
                          "and -o, into this folder") from problem


def read_json(path, *needed):
    try:
        found = json.loads(read(path))
    except ValueError as problem:
        raise ReportError(f"{path}: is not JSON ({problem}); render again") from problem
    missing = [name for name in needed if not isinstance(found, dict) or name not in found]
    if missing:
        raise ReportError(f"{path}: has no '{missing[0]}'; render again with this version")
    return found


def beside(folder, path):
    """Files keep their names when the folder is moved."""
    return os.path.join(folder, os.path.basename(path))


def find_image(folder, stats):
    names = [name for name in stats.get("image", {}).get("files", [])
             if name.lower().endswith(".png")]
    if not names:
        raise ReportError(f"{folder}: no .png picture was rendered; render with -o NAME.png too")
    return beside(folder, names[0])
