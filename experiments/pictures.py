"""Renders the scenes and their partitions for the document."""

import shutil

from measure import ANGLE_DEG, partition_path, run_tool, scene_path

# Fine enough to look at, in some tens of seconds each.
RENDER = {"photons": 500_000, "neighbours": 100, "passes": 4, "samples": 9, "size": 480}
QUICK_RENDER = {"photons": 20_000, "neighbours": 50, "passes": 1, "samples": 1, "size": 96}


def draw_scene(bench, scene, folder, settings):
    """{name: file name}"""
    drawn = {f"render_{scene}": f"render_scene_{scene}.png",
             f"maps_{scene}": f"maps_scene_{scene}.png"}
    run_tool(bench, "render", scene_path(scene), partition_path(bench, scene),
             "-o", folder / drawn[f"render_{scene}"], "--integrator", "direct",
             *(word for name, value in settings.items() for word in (f"--{name}", value)))
    images = bench.folder / f"pictures_{scene}"
    images.mkdir()
    maps_size = ("--size", settings["size"]) if settings is QUICK_RENDER else ()
    run_tool(bench, "preprocess", scene_path(scene), "-o", bench.folder / f"pictures_{scene}.hpm",
             "--angle", ANGLE_DEG, "--images", images, *maps_size)
    shutil.copy(images / "shared_maps.png", folder / drawn[f"maps_{scene}"])
    return drawn
