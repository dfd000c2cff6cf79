"""Fails on an include against the direction of data flow (docs/architecture.md).

    check_includes.py [--self-test]

Prints file:line of every such include, and of files in folders it does not know.
"""

import os
import re
import sys

from source_files import lines_of, source_files

# Folder -> folders it may include besides itself and the leaves.  Files directly in common/ count
# as leaves.  A leaf includes only itself and the leaves left of it.
LEAVES = ["common", "common/math", "common/file", "common/image"]
COMMON = ["common/scene", "common/rays", "common/partition", "common/command_line"]
PREPROCESS = ["preprocess/mesh", "preprocess/partition", "preprocess/prediction",
              "preprocess/colouring"]
RENDER = ["render/lobes", "render/media", "render/lights", "render/shading", "render/effects", "render/paths",
          "render/photons", "render/maps", "render/dissertation", "render/film", "render/integrator", "render/layers", "render/many"]

# Folder -> its headers that others in render may include, where these are not all.
DOORS = {"render/dissertation": {"render/dissertation/dissertation.h"}}

INCLUDE = re.compile(r'\s*#\s*include\s*"([^"]+)"')
GENERATED = "_generated.h"


def allowed_folders():
    allowed = {folder: set(LEAVES[:i + 1]) for i, folder in enumerate(LEAVES)}
    for tool, stages in (("preprocess", PREPROCESS), ("render", RENDER)):
        order = COMMON + stages + [tool]  # files directly in a tool's folder come last
        for i, folder in enumerate(order):
            allowed[folder] = set(LEAVES) | set(order[:i + 1])
    allowed["convert"] = set(LEAVES) | set(COMMON) | {"convert"}
    allowed["experiments/rivals"] = (set(allowed["preprocess"]) | set(allowed["render"])
                                     | {"experiments/rivals"})
    allowed["bench"] = set(allowed["preprocess"]) | set(allowed["render"]) | {"bench"}
    return allowed


def check_line(folder, text, allowed):
    """What is wrong with a line of a file in `folder`, or None."""
    match = INCLUDE.match(text)
    if not match:
        return None
    target = match.group(1)
    target_folder = os.path.dirname(target)
    if ".." in target.split("/") or not target_folder:
        generated = target.endswith(GENERATED)
        return None if generated else f'"{target}": give the path from the root'
    if folder == "tests" or folder.startswith("tests/"):
        return None
    if target_folder in allowed[folder]:
        inside = target_folder == folder or not folder.startswith("render")
        shut = not inside and target not in DOORS.get(target_folder, {target})
        return f'"{target}" is not what {target_folder} shows to others' if shut else None
    known = target_folder in allowed
    reason = "is against the direction of data flow" if known else "is in a folder with no place"
    return f'"{target}" {reason}, seen from {folder}'


def check_file(name, lines, allowed):
    folder = os.path.dirname(name)
    if folder not in allowed and not (folder == "tests" or folder.startswith("tests/")):
        return [f"{name}:1: the folder {folder} has no place in .ci/check_includes.py"]
    problems = ((i, check_line(folder, text, allowed)) for i, text in enumerate(lines, 1))
    return [f"{name}:{i}: {problem}" for i, problem in problems if problem]


def self_test(allowed):
    """What must be found is found, and what is right is let through."""
    wrong = [("common/scene/a.h", "render/maps/photon_tree.h"),
             ("common/image/a.h", "common/scene/scene.h"),
             ("common/report.cpp", "common/math/rgb.h"),
             ("common/file/a.cpp", "common/image/image.h"),
             ("preprocess/mesh/a.cpp", "preprocess/partition/share_maps.h"),
             ("preprocess/main.cpp", "render/maps/photon_tree.h"),
             ("render/shading/a.cpp", "preprocess/mesh/half_edges.h"),
             ("render/photons/a.cpp", "render/maps/photon_tree.h"),
             ("render/maps/a.cpp", "render/dissertation/dissertation.h"),
             ("render/integrator/a.cpp", "render/dissertation/kd_tree.h"),
             ("render/maps/a.cpp", "photon_tree.h"),
             ("render/maps/a.cpp", "../shading/bsdf.h"),
             ("render/maps/a.cpp", "render/utils/a.h"),
             ("render/integrator/a.cpp", "experiments/rivals/rival.h"),
             ("render/maps/a.cpp", "tests/support/tiny_meshes.h")]
    right = [("render/integrator/a.cpp", "render/shading/bsdf.h"),
             ("render/integrator/a.cpp", "render/dissertation/dissertation.h"),
             ("render/dissertation/a.cpp", "render/dissertation/kd_tree.h"),
             ("bench/a.cpp", "render/dissertation/kd_tree.h"),
             ("render/main.cpp", "render/integrator/render_image.h"),
             ("experiments/rivals/a.cpp", "render/integrator/path_tracer.h"),
             ("preprocess/colouring/a.cpp", "common/rays/embree_scene.h"),
             ("common/image/a.cpp", "common/file/output_file.h"),
             ("common/image/a.cpp", "common/input_error.h"),
             ("tests/render/maps/a.cpp", "preprocess/mesh/half_edges.h"),
             ("bench/a.cpp", "render/maps/photon_tree.h")]

    def blame(pair):
        return check_file(pair[0], [f'#include "{pair[1]}"'], allowed)

    missed = [pair for pair in wrong if not blame(pair)]
    blamed = [pair for pair in right if blame(pair)]
    unknown = check_file("common/utils/a.h", [], allowed)
    assert not missed and not blamed and unknown, f"missed {missed}, blamed {blamed}, {unknown}"


def main():
    allowed = allowed_folders()
    if "--self-test" in sys.argv[1:]:
        self_test(allowed)
        return 0
    problems = []
    for name in source_files():
        problems += check_file(name, lines_of(name), allowed)
    print("\n".join(problems) if problems else "every include follows the data")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
