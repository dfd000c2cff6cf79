"""Builds the scenes of some folders again and compares them with what is committed.

    rebuild_assets_test.py FOLDER...

NAME.glb is built by NAME.py beside it, those of the folder effects by effects.py beside that folder.

Exits 77 (skipped) after those that need no Blender where Blender is not installed, or has no numpy, without which it exports nothing.
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

from glb_file import GlbFile

SKIPPED = 77
POSITION_TOLERANCE = 1e-6  # metres, in a scene of 2 m: a last bit or so
NORMAL_TOLERANCE = 1e-4  # smooth normals are sums in an order that varies
BY_PYTHON_ALONE = ("carafe", "hall_of_lamps", "sixty_rooms", "wide_plane", "window_room")


def run_blender(blender, arguments):
    # Debian's Blender takes the libraries of the first python3 on the path; only the system's has
    # the numpy that the exporter needs.
    return subprocess.run(
        [blender, "-b", "--factory-startup", "--python-exit-code", "1", *arguments],
        env={**os.environ, "PATH": "/usr/bin:/bin"}, stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT, text=True, check=False)


def build(blender, pairs):
    """pairs: (script, output).  All in one Blender, which starts slowly; each empties it first.  Returns whether it
    has what it needs."""
    lines = ["import importlib.util, os, runpy, sys",
             f"if not importlib.util.find_spec('numpy'): os._exit({SKIPPED})"]
    for script, output in pairs:
        lines += [f"sys.argv = ['blender', '--', {output!r}]",
                  f"runpy.run_path({script!r}, run_name='__main__')"]
    run = run_blender(blender, ["--python-expr", "\n".join(lines)])
    if run.returncode == SKIPPED:
        return False
    for script, output in pairs:
        assert run.returncode == 0 and os.path.exists(output), f"{script} failed:\n{run.stdout}"
    return True


def near(a, b, tolerance):
    """Whether two parts of JSON are alike but for rounding."""
    if a == b:  # most are, and this is quick
        return True
    if isinstance(a, dict) and isinstance(b, dict):
        return a.keys() == b.keys() and all(near(a[key], b[key], tolerance) for key in a)
    if isinstance(a, (list, tuple)) and isinstance(b, (list, tuple)):
        return len(a) == len(b) and all(near(x, y, tolerance) for x, y in zip(a, b))
    if isinstance(a, float) or isinstance(b, float):
        return abs(a - b) <= tolerance
    return a == b


def compare(committed, rebuilt):
    for key in ("scenes", "nodes", "meshes", "materials", "cameras", "accessors", "extensions"):
        old, new = committed.json.get(key), rebuilt.json.get(key)
        assert near(old, new, POSITION_TOLERANCE), f"{key} differ:\n{old}\n{new}"
    for mesh in committed.json["meshes"]:
        for primitive in mesh["primitives"]:
            accessors = [("indices", primitive["indices"], 0)]
            for name, index in primitive["attributes"].items():
                tolerance = NORMAL_TOLERANCE if name == "NORMAL" else POSITION_TOLERANCE
                accessors.append((name, index, tolerance))
            for name, index, tolerance in accessors:
                assert near(committed.values(index), rebuilt.values(index), tolerance), \
                    f"{name} of {mesh['name']} differ"


def rebuild(blender, scenes):
    """scenes: (folder, name without suffix).  blender: None for scripts that need none.  Returns whether Blender has
    what it needs."""
    with tempfile.TemporaryDirectory() as temporary:
        pairs = [(os.path.join(folder, name + ".py"), os.path.join(temporary, name + ".glb"))
                 for folder, name in scenes]
        if blender is not None and not build(blender, pairs):
            return False
        for (script, rebuilt), (folder, name) in zip(pairs, scenes):
            if blender is None:
                subprocess.run([sys.executable, "-B", script, rebuilt], check=True)
            compare(GlbFile(os.path.join(folder, name + ".glb")), GlbFile(rebuilt))
            print(f"{name}.glb: the script builds what is committed")
    return True


def pictures(glb):
    views = (glb.json["bufferViews"][image["bufferView"]] for image in glb.json.get("images", []))
    return [glb.binary[view["byteOffset"]:view["byteOffset"] + view["byteLength"]]
            for view in views]


def rebuild_effects(folder):
    committed = os.path.join(folder, "effects")
    with tempfile.TemporaryDirectory() as temporary:
        subprocess.run([sys.executable, "-B", os.path.join(folder, "effects.py"), temporary],
                       check=True)
        assert sorted(os.listdir(temporary)) == sorted(os.listdir(committed))
        for name in sorted(os.listdir(committed)):
            if not name.endswith(".glb"):
                old, new = (pathlib.Path(at, name).read_bytes() for at in (committed, temporary))
                assert old == new, f"{name} differs"
                continue
            old, new = (GlbFile(os.path.join(at, name)) for at in (committed, temporary))
            compare(old, new)
            assert pictures(old) == pictures(new), f"pictures of {name} differ"
            print(f"effects/{name}: the script builds what is committed")


def main():
    for folder in sys.argv[1:]:
        if os.path.exists(os.path.join(folder, "effects.py")):
            rebuild_effects(folder)
        for name in BY_PYTHON_ALONE:
            if os.path.exists(os.path.join(folder, name + ".py")):
                rebuild(None, [(folder, name)])
    blender = shutil.which("blender")
    if blender is None:
        print("SKIP: Blender is not installed")
        return SKIPPED
    scenes = []
    for folder in sys.argv[1:]:
        names = sorted(name[:-4] for name in os.listdir(folder)
                       if name.endswith(".glb") and name[:-4] not in BY_PYTHON_ALONE)
        assert names, f"no scene in {folder}"
        scenes += [(folder, name) for name in names]
    if not rebuild(blender, scenes):
        print("SKIP: Blender's exporter has no numpy (Debian: python3-numpy)")
        return SKIPPED
    return 0


if __name__ == "__main__":
    sys.exit(main())
