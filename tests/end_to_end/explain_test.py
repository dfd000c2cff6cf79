"""Holds render --explain to what glTF files say, which is read here without hipmap's loader.

    explain_test.py FOLDER_OF_TOOLS FOLDER...

Every .glb and .gltf below the folders: each effect that the file has is on, each other one off, and reasons name
materials that have it.  Folders that are missing are left out.
"""

import os
import re
import sys

from gltf_facts import GltfFacts
from tools import Tools, ToolsTestCase, main

MIRROR, FOLLOWED = 0.02 + 1e-7, 0.3 + 1e-7  # floats are written with more digits than they have
SLOW = "EXT_mesh_gpu_instancing"  # so many faces that preprocess takes minutes


def reflections(m):
    """Roughness of each reflection of a material."""
    return ([m["roughness"]] if m["reflects"] else []) + (
        [m["coat_roughness"]] if m["coat"] > 0 and not m["glass"] else [])


def is_specular(m):
    """May be, for a picture of roughness may make it so."""
    return m["glass"] or m["mirror"] or any(r <= FOLLOWED for r in reflections(m)) or bool(
        m["textures"] & {"metallicRoughnessTexture", "transmissionTexture"})


def gathers(m):
    return m["matt"] or m["sheen"] or m["through"] or any(r > FOLLOWED for r in reflections(m))


def see_through(m):
    """None: its picture decides."""
    if m["alpha_mode"] == "OPAQUE":
        return False
    if m["alpha"] < (m["cutoff"] if m["alpha_mode"] == "MASK" else 1):
        return True
    return None if "baseColorTexture" in m["textures"] else False


def has_mirror(m):
    return m["mirror"] or any(r <= MIRROR for r in reflections(m)) or (
        m["reflects"] and "metallicRoughnessTexture" in m["textures"])


def is_glossy(m):
    return any(r > MIRROR for r in reflections(m)) or (m["glass"] and m["roughness"] > MIRROR)


BY_MATERIAL = {
    "mirror": has_mirror,
    "glossy": is_glossy,
    "refraction": lambda m: m["solid"],
    "absorption": lambda m: m["holds"] and m["absorbs"],
    "dispersion": lambda m: m["solid"] and m["dispersion"] > 0,
    "subsurface": lambda m: m["subsurface"],
    "normal-maps": lambda m: "normalTexture" in m["textures"] or (
        "clearcoatNormalTexture" in m["textures"] and m["coat"] > 0 and not m["glass"]),
    "alpha": see_through,
    "clearcoat": lambda m: m["coat"] > 0 and not m["glass"],
    "sheen": lambda m: m["sheen"],
    "diffuse-transmission": lambda m: m["through"],
    "anisotropy": lambda m: m["anisotropy"] > 0 and m["directed"] and (
        m["reflects"] or m["glass"]),
    "reflection-models": lambda m: m["model"] != "",
}
NEVER = ("motion-blur",)


def expected(facts):
    """name: (on or None, materials that have it or None)."""
    out = {name: (False, None) for name in NEVER}
    for name, holds in BY_MATERIAL.items():
        found = [holds(m) for m in facts.materials]
        names = [m["name"] for m, one in zip(facts.materials, found) if one]
        unsure = None in found
        out[name] = (True if names else None if unsure else False, None if unsure else names)
    pictured = [m["name"] for m in facts.materials if facts.rendered_pictures(m)]
    media = [m["name"] for m in facts.materials if m["medium"]]
    out["media"] = (bool(media) or "medium" in facts.around(), media)
    out["nested-dielectrics"] = (facts.nested(), None)
    out["textures"] = (bool(pictured), pictured)
    out["vertex-colours"] = (facts.vertex_colours(), None)
    glowing = [m["name"] for m in facts.materials if m["glows"]]
    sized = facts.sized_lamps()
    sky = facts.has_world() or not (glowing or facts.lamps() or sized)
    gathering = [m["name"] for m in facts.materials if gathers(m)]
    specular = [m["name"] for m in facts.materials if is_specular(m)]
    out["environment"] = (sky, None)
    out["soft-shadows"] = (bool(glowing + sized) or sky, glowing + sized or None)
    meets = not facts.lone_box()
    out["indirect"] = (meets and bool(gathering), gathering)
    out["caustics"] = (meets and bool(gathering) and bool(specular), specular)
    out["depth-of-field"] = (facts.has_lens(), None)
    return out


def scene_files(folders):
    return sorted(os.path.join(path, name) for folder in folders
                  for path, _, names in os.walk(folder) for name in names
                  if name.endswith((".glb", ".gltf")))


class Explain(ToolsTestCase):
    files = []

    def explained(self, file):
        """name: (on, reason), of both tools' run on a file."""
        partition = self.path("scene.hpm")
        # No effect depends on how many photons faces expect.
        self.succeed("preprocess", file, "-o", partition, "--photons", 0)
        printed = self.succeed("render", file, partition, "--explain")
        return {name: (switch == "on", reason) for name, switch, reason in
                re.findall(r"(?m)^([a-z-]+): (on|off); (.*)$", printed)}

    def check(self, name, want, got):
        on, names = want
        if on is not None:
            self.assertEqual(got[0], on, f"{name}: {got[1]}")
        if not got[0] or names is None:
            return
        reason = got[1].partition("; costs")[0]
        named = set(re.findall(r"'([^']*)'", reason))
        self.assertLessEqual(named, set(names), f"{name}: {reason}")
        more = sum(int(count) for count in re.findall(r"' and (\d+) more", reason))
        self.assertEqual(len(named) + more, len(set(names)), f"{name}: {reason}")

    def test_every_effect_of_a_file_is_on_and_no_other(self):
        for file in self.files:
            facts = GltfFacts(file)
            if SLOW in facts.json.get("extensionsUsed", ()):
                continue
            with self.subTest(file=file):
                got, want = self.explained(file), expected(facts)
                self.assertEqual(sorted(got), sorted(want))
                for name in want:
                    self.check(name, want[name], got[name])


if __name__ == "__main__":
    Explain.files = scene_files(sys.argv[2:])
    main([*sys.argv[:2], ""])
