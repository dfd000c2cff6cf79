#!/usr/bin/env python3
"""Measures what guided emission gains where light is hard to find, and writes docs/guided_emission.md.

    bench/guided_emission.py [--before BIN] [--seconds 30] [--reference 150] [--size 192] [SCENE...]

Each scene is rendered by integrator progressive for the same wall time with --emission by-power and guided, and
by the render of another build if one is given; relMSE (docs/error.md (3)) is against a longer render of
another seed with narrower radii.  Takes (reference + 2 or 3 times seconds) for each scene, on all cores.
"""

import argparse
import datetime
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
BIN = ROOT / "build/release/bin"
PICTURES = ROOT / "docs/images/guided"
HARD = ("window_room", "sixty_rooms", "wide_plane")
PRESENT = ("cornell", "cornell_diffuse", "cornell_spheres", "glass_globe", "hall_of_lamps")
FEW = 12  # of the references: radii like those of the images would hide the bias of both


def run(command):
    """Runs a command.  Returns all that it printed."""
    done = subprocess.run([str(word) for word in command], text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, check=False)
    if done.returncode != 0:
        sys.exit(f"error: {command[0]}: {done.stdout.strip().splitlines()[-1]}")
    return done.stdout


class Lab:
    def __init__(self, options, folder):
        self.options, self.folder = options, pathlib.Path(folder)

    def render(self, scene, name, seconds, *more, tool=BIN):
        """Returns the picture, the passes and the stated error."""
        image = self.folder / f"{scene}_{name}.exr"
        partition = self.folder / f"{scene}_{'now' if tool == BIN else 'before'}.hpm"
        if not partition.exists():
            run([tool / "preprocess", ROOT / f"assets/{scene}.glb", "-o", partition])
        printed = run([tool / "render", ROOT / f"assets/{scene}.glb", partition, "-o", image,
                       "--size", self.options.size, "--filter", "box", "--time", seconds, *more])
        stated = re.search(r"accuracy: error ([\d.]+ %)", printed)
        passes = re.search(r"in (\d+) passes", printed)
        return image, passes[1] if passes else "", stated[1] if stated else ""

    def row(self, scene):
        """A row of the table."""
        reference = self.render(scene, "reference", self.options.reference, "--seed", 99,
                                "--fireflies", "keep", "--neighbours", FEW)[0]
        seconds, kinds = self.options.seconds, {}
        if self.options.before:
            kinds["before"] = self.render(scene, "before", seconds, tool=self.options.before)
        for kind in ("by-power", "guided"):
            kinds[kind] = self.render(scene, kind, seconds, "--emission", kind)
        errors = {kind: float(re.search(r"relMSE of A against B\s+([\d.e+-]+)",
                                        run([BIN / "compare_images", made[0], reference]))[1])
                  for kind, made in kinds.items()}
        first = "before" if self.options.before else "by-power"
        if scene in HARD:
            PICTURES.mkdir(parents=True, exist_ok=True)
            run([BIN / "compare_images", kinds[first][0], kinds["guided"][0], "--side-by-side",
                 PICTURES / f"{scene}.png"])
        cells = [f"{errors[kind]:.3g} ({made[1]} passes; {made[2]} stated)"
                 for kind, made in kinds.items()]
        return [scene, *cells, f"{errors[first] / errors['guided']:.2f}"]


def page(options, rows):
    """The text of the page."""
    kinds = (["before"] if options.before else []) + ["by power", "guided"]
    lines = [
        "# What does guided emission gain?", "",
        "Written by `bench/guided_emission.py`; do not edit. Run on "
        f"{datetime.date.today().isoformat()}.", "",
        f"relMSE ([error.md](error.md) (3)) of images {options.size} pixels wide after "
        f"{options.seconds:g} s on all cores, against {options.reference:g} s of another seed and "
        f"`--neighbours {FEW}`, which has noise of its own and less bias. "
        "[light_transport.md](light_transport.md) (41) says how paths are guided.",
        *(["`before` is the version without guides, and with the weights of (21) before (42). In the other "
            "columns gather rays are guided, (43)."]
          if options.before else []),
        "", "| scene | " + " | ".join(kinds) + f" | {kinds[0]} over guided |",
        "| --- |" + " --- |" * (len(kinds) + 1)]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    lines += ["", f"Each picture: {kinds[0]}, and guided, after the same time.", ""]
    for row in rows:
        if row[0] in HARD:
            lines += [f"![{row[0]}](images/guided/{row[0]}.png)", ""]
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("scenes", nargs="*", metavar="SCENE", default=HARD + PRESENT)
    parser.add_argument("--before", type=pathlib.Path, help="folder of another build's programs")
    parser.add_argument("--seconds", type=float, default=30)
    parser.add_argument("--reference", type=float, default=150, help="seconds of references")
    parser.add_argument("--size", type=int, default=192, help="pixels across")
    options = parser.parse_args()
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        lab = Lab(options, folder)
        for scene in options.scenes:
            rows.append(lab.row(scene))
            print("| " + " | ".join(rows[-1]) + " |", flush=True)
    (ROOT / "docs/guided_emission.md").write_text(page(options, rows), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
