"""The furnished scenes of bench/scenes, which are too large to be kept: written when first asked for."""

import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SCRIPTS = ROOT / "bench/scenes"
NAMES = ("kitchen", "living_room", "museum", "workshop")
FOLDER = ROOT / "build/scenes"


def is_current(path):
    """Whether the file is there and no script is newer."""
    if not path.exists():
        return False
    written = path.stat().st_mtime
    return all(script.stat().st_mtime <= written for script in SCRIPTS.glob("*.py"))


def path_of(name):
    """The file of a furnished scene; half a minute where it has to be written."""
    path = FOLDER / f"{name}.glb"
    if not is_current(path):
        FOLDER.mkdir(parents=True, exist_ok=True)
        half = path.with_suffix(".part")
        subprocess.run([sys.executable, "-B", str(SCRIPTS / f"{name}.py"), str(half)], check=True,
                       stdout=subprocess.DEVNULL)
        half.replace(path)
    return path


class Scenes(dict):
    """Files by name of scene: the given ones, and the furnished ones, which are written when they are
    looked up."""

    def __init__(self, files):
        super().__init__(files)
        self.update(dict.fromkeys(NAMES))

    def written(self):
        """The names without those of files that are not there yet."""
        return [name for name in self if name not in NAMES or (FOLDER / f"{name}.glb").exists()]

    def __getitem__(self, name):
        return path_of(name) if name in NAMES else super().__getitem__(name)
