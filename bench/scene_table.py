#!/usr/bin/env python3
"""Runs preprocess on every scene below some folders and prints what came of each, as a table.

    bench/scene_table.py [--limit SECONDS] FOLDER...

Where a folder holds a manifest.json that says of its files whether they are legal, what came is held
against it: a legal file must be partitioned (or be refused for having no face), an illegal one must
be refused with one line and exit code 2, and none may crash or exceed the limit.  Exit code 1 if one
does not behave.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
PREPROCESS = ROOT / "build/release/bin/preprocess"
SUFFIXES = {".glb", ".gltf", ".obj"}
HEADERS = ["scene", "legal", "exit", "seconds", "faces", "maps", "groups", "connected", "warnings",
           "remark"]


def legality(folder):
    """Path of each file of a manifest below the folder -> true, false or None."""
    known = {}
    for manifest in folder.rglob("manifest.json"):
        for entry in json.loads(manifest.read_text()).get("files", []):
            known[(manifest.parent / entry["file"]).resolve()] = entry.get("legal")
    return known


def run_preprocess(scene, limit):
    """Exit code (None: over the limit), seconds, standard error, the JSON it wrote or None."""
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder, "report.json")
        command = [PREPROCESS, scene, "-o", pathlib.Path(folder, "out.hpm"), "--json", report]
        start = time.monotonic()
        try:
            done = subprocess.run(command, capture_output=True, timeout=limit, check=False)
        except subprocess.TimeoutExpired:
            return None, limit, "", None
        seconds = time.monotonic() - start
        found = json.loads(report.read_text()) if report.exists() else None
        return done.returncode, seconds, done.stderr.decode(errors="replace"), found


def judge(legal, code, errors):
    """What is wrong with an outcome; empty if nothing is."""
    if code is None:
        return "over the limit"
    if code not in (0, 2):
        return "crashed"
    if code == 2 and (len(errors) != 1 or not errors[0].startswith("error: ")):
        return "not one line of error"
    if legal is True and code == 2 and "the scene has no faces" not in errors[0]:
        return "legal, but refused"
    if legal is False and code == 0:
        return "illegal, but accepted"
    return ""


def row_of(scene, name, legal, limit):
    code, seconds, text, found = run_preprocess(scene, limit)
    lines = text.splitlines()
    wrong = judge(legal, code, lines)
    warnings = sum(line.startswith("warning: ") for line in lines)
    refusal = lines[-1].split(": ", 2)[-1] if code == 2 and lines else ""
    cells = [name, {True: "yes", False: "no"}.get(legal, "-"), "-" if code is None else str(code),
             f"{seconds:.2f}"]
    if found:
        cells += [str(found["faces"]), str(found["shared_maps"]), str(found["groups"]),
                  str(found["edges"]["connected"])]
    else:
        cells += ["", "", "", ""]
    return cells + [str(warnings), f"WRONG: {wrong}" if wrong else refusal[:60]], bool(wrong)


def print_table(rows):
    widths = [max(len(row[i]) for row in rows) for i in range(len(HEADERS))]
    for row in rows:
        print("  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip())


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("folders", nargs="+", type=pathlib.Path)
    parser.add_argument("--limit", type=float, default=120.0, help="seconds for one scene [120]")
    arguments = parser.parse_args()
    if not PREPROCESS.exists():
        sys.exit("error: build/release/bin/preprocess is missing; run ./pipeline.sh first")
    rows, wrong = [HEADERS], 0
    for folder in arguments.folders:
        known = legality(folder)
        for scene in sorted(path for path in folder.rglob("*") if path.suffix in SUFFIXES):
            name = str(scene.relative_to(folder.parent))
            row, bad = row_of(scene, name, known.get(scene.resolve(), True), arguments.limit)
            rows.append(row)
            wrong += bad
    print_table(rows)
    print(f"\n{len(rows) - 1} scenes, {wrong} not as they should be")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
