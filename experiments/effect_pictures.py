#!/usr/bin/env python3
"""Renders the pictures of docs/effects.md: each scene as it is, and with an effect left out.

    experiments/effect_pictures.py --to docs/images/effects                 # all of them
    experiments/effect_pictures.py --to OUT fog milk                        # those whose names begin so

Both pictures of a pair have the exposure of the first.
"""

import argparse
import json
import pathlib
import sys
import tempfile

from programs import run

ROOT = pathlib.Path(__file__).resolve().parent.parent
ASSETS = ROOT / "assets"
BLURRED = ("--frames", "3:3", "--shutter", "1")


def left_out(*effects):
    return ("--effects", ",".join("-" + effect for effect in effects))


# name of the picture: scene, options of the first, options of the second (None: there is none)
PAIRS = {
    "absorption": ("absorption", (), left_out("absorption")),
    "alpha": ("alpha", (), left_out("alpha")),
    "anisotropy": ("anisotropy", (), left_out("anisotropy")),
    "caustics": ("../cornell", (), left_out("caustics")),
    "clearcoat": ("clearcoat", (), left_out("clearcoat")),
    "clearcoat_normal": ("clearcoat_normal", (), left_out("normal-maps")),
    "depth_of_field": ("depth_of_field", (), left_out("depth-of-field")),
    "diffuse_transmission": ("diffuse_transmission", (), left_out("diffuse-transmission")),
    "dispersion": ("dispersion", (), left_out("dispersion")),
    "emissive_picture": ("emissive_picture", (), left_out("textures")),
    "energy_compensation": ("rough_metal", ("--energy-compensation",), ()),
    "environment": ("environment", (), left_out("environment")),
    "fog": ("fog", (), left_out("media")),
    "indirect": ("../cornell", (), left_out("indirect")),
    "milk": ("milk", (), left_out("media", "subsurface")),
    "motion": ("motion", BLURRED, BLURRED + left_out("motion-blur")),
    "nested_dielectrics": ("nested_dielectrics", (), left_out("nested-dielectrics")),
    "normal_maps": ("normal_maps", (), left_out("normal-maps")),
    "reflection_models": ("reflection_models", (), left_out("reflection-models")),
    "reflections": ("reflections", (), None),
    "sheen": ("sheen", (), left_out("sheen")),
    "smoke": ("smoke", (), left_out("media")),
    "soft_shadows": ("soft_shadows", (), ()),
    "subsurface": ("subsurface", (), left_out("subsurface")),
    "textures": ("textures", (), left_out("textures")),
    "vertex_colours": ("vertex_colours", (), left_out("vertex-colours")),
    "ward_lafortune": ("ward_lafortune", (), left_out("reflection-models")),
}


def without_radius(folder):
    """The scene of soft shadows with a lamp that has no size."""
    sys.path.append(str(ASSETS))
    import effects
    glb = effects.stage(0)
    effects.add_soft_shadows(glb)
    for lamp in glb.root["extensions"]["KHR_lights_punctual"]["lights"]:
        del lamp["extras"]
    glb.write(folder / "soft_shadows.glb")
    return folder / "soft_shadows.glb"


class Studio:
    def __init__(self, tools, folder, accuracy):
        self.tools, self.folder, self.accuracy = tools, folder, accuracy

    def render(self, scene, picture, exposure, options):
        """Returns the exposure, in stops."""
        partition, stats = self.folder / "scene.hpm", self.folder / "stats.json"
        frames = options[:2] if "--frames" in options else ()
        run(self.tools, "preprocess", scene, "-o", partition, *frames)
        drawn = self.folder / "picture.png"
        run(self.tools, "render", scene, partition, "-o", drawn, "--size", 256, "--stats", stats,
            "--exposure", exposure, *self.accuracy, *options)
        if frames:
            drawn, = self.folder.glob("picture.*.png")
            stats, = self.folder.glob("stats.*.json")
        drawn.replace(picture)
        found = json.loads(stats.read_text())
        stats.unlink()
        print(f"{picture.name}: error {found['error']['checks'][-1]['error']:.1%}", flush=True)
        return found["image"]["exposure_ev"]

    def render_pair(self, name, to):
        scene, options, without = PAIRS[name]
        scene = ASSETS / "effects" / f"{scene}.glb"
        exposure = self.render(scene, to / f"{name}.png", "auto", options)
        if without is None:
            return
        if name == "soft_shadows":
            scene = without_radius(self.folder)
        self.render(scene, to / f"{name}_off.png", exposure, without)


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("names", nargs="*", help="of the pictures, or how they begin [all]")
    parser.add_argument("--to", type=pathlib.Path, required=True, help="folder of the pictures")
    parser.add_argument("--tools", type=pathlib.Path, default=ROOT / "build" / "release" / "bin")
    parser.add_argument("--error", default="2%", help="render until it is so small [2%%] ...")
    parser.add_argument("--time", default=60, help="... or so many seconds are over [60]")
    arguments = parser.parse_args()
    accuracy = ("--error", arguments.error, "--time", arguments.time)
    arguments.to.mkdir(parents=True, exist_ok=True)
    for name in PAIRS:
        if not arguments.names or name.startswith(tuple(arguments.names)):
            with tempfile.TemporaryDirectory() as folder:
                Studio(arguments.tools, pathlib.Path(folder), accuracy).render_pair(
                    name, arguments.to)


if __name__ == "__main__":
    main()
