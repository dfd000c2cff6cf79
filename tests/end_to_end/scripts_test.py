"""pipeline.sh, command/hipmap, test.sh and .ci/run with stand-ins for the programs they call, so
that nothing is installed or built; and what bench/cost_of_absence.py takes out of the sources.

    scripts_test.py ROOT
"""

import json
import os
import shutil
import stat
import subprocess
import sys
import tempfile
import unittest

ROOT = sys.argv[1]
LOG = 'echo "$(basename "$0") $*" >>"$STAND_IN_LOG"\n'
STAND_INS = {
    "apt-get": LOG,
    "cmake": LOG,
    "ctest": LOG + 'echo "50% tests passed, 1 tests failed out of 2"; exit "${CTEST_RESULT:-0}"\n',
    "dpkg-query": 'for p in "$@"; do [[ " $LACKING " == *" $p "* ]] || echo "installed $p"; done\n',
    "sudo": 'exec "$@"\n',
}


def row(flags, placeholder="", is_setting=True):
    name = flags.split("--")[-1]
    return {"name": name, "flags": flags, "placeholder": placeholder, "is_setting": is_setting}


OPTIONS = {"preprocess": [row("-o,--output", "FILE", False), row("--size", "WxH"),
                          row("--angle", "DEG"), row("--camera", "NAME"),
                          row("--coloured", "FILE", False)],
           "render": [row("-o,--output", "FILE", False), row("--size", "WxH"),
                      row("--error", "E%"), row("--effects", "LIST"), row("--camera", "NAME"),
                      row("--state", "FILE", False), row("--quote"), row("--explain"),
                      row("--frames", "A:B")]}
REPORT = """import os, sys
with open(os.environ["STAND_IN_LOG"], "a") as log:
    print("report", *sys.argv[1:], file=log)
"""


class Scripts(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="hipmap-test-")
        self.addCleanup(temporary.cleanup)
        self.folder = temporary.name
        self.root = os.path.join(self.folder, "a checkout")
        os.makedirs(os.path.join(self.root, "build/release/bin"))
        for name in ("pipeline.sh", "test.sh", ".ci", "assets", "command"):
            source = os.path.join(ROOT, name)
            copy = shutil.copytree if os.path.isdir(source) else shutil.copy
            copy(source, os.path.join(self.root, name))
        for name, text in STAND_INS.items():
            self.stand_in(os.path.join(self.folder, name), text)
        for name in ("preprocess", "render"):
            tables = json.dumps({"options": OPTIONS[name]})
            self.stand_in(os.path.join(self.root, "build/release/bin", name),
                          f"if [[ $1 == --options-json ]]; then echo '{tables}'; exit; fi\n" +
                          LOG + f'exit "${{{name.upper()}_RESULT:-0}}"\n')
        os.makedirs(os.path.join(self.root, "report"))
        with open(os.path.join(self.root, "report/make_report.py"), "w", encoding="utf-8") as file:
            file.write(REPORT)

    def stand_in(self, path, text):
        with open(path, "w", encoding="utf-8") as file:
            file.write("#!/usr/bin/env bash\n" + text)
        os.chmod(path, os.stat(path).st_mode | stat.S_IXUSR)

    def run_script(self, script, *arguments, **variables):
        """Exit code, output, errors, and the lines the stand-ins wrote."""
        log = os.path.join(self.folder, "log")
        open(log, "w", encoding="utf-8").close()
        environment = {**os.environ, "PATH": self.folder + ":" + os.environ["PATH"],
                       "STAND_IN_LOG": log, "LACKING": "", **variables}
        done = subprocess.run([os.path.join(self.root, script), *arguments], cwd=self.folder,
                              env=environment, capture_output=True, text=True, check=False)
        with open(log, encoding="utf-8") as file:
            return done.returncode, done.stdout, done.stderr, file.read().splitlines()

    def test_what_is_missing_is_installed_and_nothing_else(self):
        lacking = "libembree-dev catch2 chromium"
        code, _, errors, log = self.run_script("test.sh", LACKING=lacking)
        self.assertEqual(code, 0, errors)
        installs = [line for line in log if line.startswith("apt-get") and " install " in line]
        self.assertEqual(len(installs), 1)
        self.assertIn("--no-install-recommends", installs[0])
        self.assertEqual(sorted(installs[0].split()[-3:]), sorted(lacking.split()))

    def test_who_only_renders_needs_no_browser(self):
        code, _, errors, log = self.run_script("pipeline.sh", LACKING="chromium clang")
        self.assertEqual(code, 0, errors)
        self.assertEqual([line for line in log if line.startswith("apt-get")], [])

    def test_nothing_is_installed_where_nothing_is_missing(self):
        code, _, errors, log = self.run_script("test.sh")
        self.assertEqual(code, 0, errors)
        self.assertEqual([line for line in log if line.startswith("apt-get")], [])

    def test_test_sh_passes_on_its_arguments_and_the_result(self):
        code, _, _, log = self.run_script("test.sh", "--sanitize", "--", "-R", "weld",
                                          CTEST_RESULT="8")
        self.assertEqual(code, 8)
        self.assertIn("--preset sanitize", log[0])
        self.assertIn("build/sanitize", log[-1])
        self.assertTrue(log[-1].endswith("-R weld"), log[-1])

    def test_usage(self):
        for script in ("test.sh", "pipeline.sh"):
            code, output, _, log = self.run_script(script, "--help")
            self.assertEqual((code, log), (0, []))
            self.assertIn("usage:", output)
            code, _, errors, log = self.run_script(script, "--no-such-option")
            self.assertEqual((code, log), (2, []))
            self.assertIn("--no-such-option", errors)

    def test_a_missing_scene_is_refused_before_anything_is_done(self):
        code, _, errors, log = self.run_script("pipeline.sh", "missing.glb")
        self.assertEqual((code, log), (2, []))
        self.assertEqual(errors.count("\n"), 1)
        self.assertIn("missing.glb", errors)

    def test_pipeline_runs_both_tools_on_the_bundled_scene(self):
        code, output, errors, log = self.run_script("pipeline.sh")
        self.assertEqual(code, 0, errors)
        self.assertTrue(os.path.isdir(os.path.join(self.folder, "out/cornell")))
        self.assertTrue(log[-3].startswith("preprocess "))
        self.assertTrue(log[-2].startswith("render "))
        for line in log[-3:-1]:
            self.assertIn("assets/cornell.glb", line)
            self.assertIn("out/cornell/cornell.hpm", line)
        self.assertIn("--state out/cornell/cornell.state", log[-2])
        self.assertEqual(log[-1], "report out/cornell")
        self.assertIn("out/cornell/", output)

    def options_given(self, always, *words):
        """What preprocess and render got besides what they always get."""
        code, _, errors, log = self.run_script("pipeline.sh", "--", *words)
        self.assertEqual(code, 0, errors)
        for line, plain in zip(log[-3:-1], always):
            self.assertTrue(line.startswith(plain), line)
        return [line[len(plain):].split() for line, plain in zip(log[-3:-1], always)]

    def test_pipeline_passes_options_to_the_tools_that_have_them(self):
        always = self.run_script("pipeline.sh")[3][-3:-1]
        self.assertEqual(self.options_given(always, "--error", "5%"), [[], ["--error", "5%"]])
        self.assertEqual(self.options_given(always, "--size=64", "--angle", "20"),
                         [["--size=64", "--angle", "20"], ["--size=64"]])
        self.assertEqual(self.options_given(always, "--effects", "-caustics", "--camera", "--size"),
                         [["--camera", "--size"],
                          ["--effects", "-caustics", "--camera", "--size"]])
        self.assertEqual(self.options_given(always, "-o", "more.hdr", "--coloured", "maps.glb"),
                         [["--coloured", "maps.glb"], ["-o", "more.hdr"]])

    def test_pipeline_refuses_options_that_no_tool_has_or_that_it_sets(self):
        for words, naming in ((("--no-such-option",), "--no-such-option"), (("desk",), "desk"),
                              (("--state", "a.state"), "--state"), (("--frames", "1"), "--frames")):
            code, _, errors, log = self.run_script("pipeline.sh", "--", *words)
            self.assertEqual((code, errors.count("\n")), (2, 1), errors)
            self.assertIn(naming, errors)
            self.assertFalse([line for line in log if line.startswith(("pre", "render"))], log)

    def test_pipeline_only_prints_where_it_is_asked_to(self):
        code, output, errors, log = self.run_script("pipeline.sh", "--", "--quote", "--error", "5%")
        self.assertEqual((code, output.strip()), (0, ""), errors)
        self.assertTrue(log[-1].endswith("cornell.hpm --quote --error 5%"), log[-1])

    def test_pipeline_takes_names_with_spaces_and_ends_with_the_code_of_what_failed(self):
        scene = os.path.join(self.folder, "my desk.v2.glb")
        shutil.copy(os.path.join(ROOT, "assets/cornell.glb"), scene)
        for result in ("1", "2"):
            code, output, _, log = self.run_script("pipeline.sh", scene, "my out",
                                                   RENDER_RESULT=result)
            self.assertEqual((code, output.strip()), (int(result), ""))
            self.assertTrue(log[-1].startswith("render "), log[-1])
            self.assertIn("my out/my desk.v2.hpm", log[-1])
        code, _, _, log = self.run_script("pipeline.sh", scene, "my out", PREPROCESS_RESULT="2")
        self.assertEqual(code, 2)
        self.assertTrue(log[-1].startswith("preprocess "))

    def test_pipeline_makes_a_report_of_a_render_that_was_stopped(self):
        code, output, _, log = self.run_script("pipeline.sh", RENDER_RESULT="3")
        self.assertEqual((code, log[-1]), (3, "report out/cornell"))
        self.assertIn("out/cornell/", output)

    def test_pipeline_makes_frames_and_a_video_where_there_is_ffmpeg(self):
        scene = os.path.join(self.folder, "ball.glb")
        shutil.copy(os.path.join(ROOT, "assets/cornell.glb"), scene)
        self.stand_in(os.path.join(self.folder, "ffmpeg"), LOG)
        os.makedirs(os.path.join(self.folder, "out"))
        with open(os.path.join(self.folder, "out/stats.json"), "w", encoding="utf-8") as file:
            json.dump({"image": {"exposure_ev": 1.25}}, file)
        code, output, errors, log = self.run_script("pipeline.sh", scene, "out", "08:12", "--",
                                                    "--error", "5%")
        self.assertEqual(code, 0, errors)
        self.assertEqual([line.split()[0] for line in log[-4:]],
                         ["report", "preprocess", "render", "ffmpeg"])
        for line in log[-3:-1]:
            self.assertIn("--frames 08:12", line)
        self.assertTrue(log[-2].endswith("--exposure 1.25 --shutter 0.5 --error 5%"), log[-2])
        self.check_that_frames_resume(scene, log[-2].split())
        self.assertIn("-start_number 8 -i out/frames/ball.%04d.png", log[-1])
        self.assertIn("frames 08:12", output)
        code, _, errors, log = self.run_script("pipeline.sh", scene, "out", "1-12")
        self.assertEqual((code, errors.count("\n")), (2, 1))
        self.assertFalse([line for line in log if line.startswith(("pre", "render"))], log)
        self.assertIn("1-12", errors)

    def check_that_frames_resume(self, scene, command):
        """command: of render in a run that was stopped in frame 11."""
        for frame, reason in ((8, "passes"), (9, "error"), (11, "signal")):
            path = os.path.join(self.folder, f"out/frames/ball.{frame:04}.json")
            with open(path, "w", encoding="utf-8") as file:
                json.dump({"command": command, "ended_by": reason}, file)
        _, _, errors, log = self.run_script("pipeline.sh", scene, "out", "08:12", "--", "--error",
                                            "5%")
        self.assertIn("frames 8 to 9 are done", errors)
        for line in log[-3:-1]:
            self.assertIn("--frames 10:12", line)
        self.assertIn("-start_number 8 ", log[-1])
        _, _, _, log = self.run_script("pipeline.sh", scene, "out", "08:12", "--", "--error", "4%")
        self.assertIn("--frames 08:12", log[-2])
        os.utime(scene)
        _, _, _, log = self.run_script("pipeline.sh", scene, "out", "08:12", "--", "--error", "5%")
        self.assertIn("--frames 08:12", log[-2])

    def test_ci_ends_with_the_summary_and_the_result_of_ctest(self):
        summary = "50% tests passed, 1 tests failed out of 2"
        code, output, errors, log = self.run_script(".ci/run")
        self.assertEqual(code, 0, errors)
        self.assertEqual(output.splitlines()[-1], summary)
        self.assertTrue(any("HIPMAP_WERROR=ON" in line for line in log), log)
        _, _, _, log = self.run_script(".ci/run", "--sanitize")
        self.assertTrue(any("HIPMAP_WERROR=OFF" in line for line in log), log)
        code, output, _, _ = self.run_script(".ci/run", CTEST_RESULT="8")
        self.assertEqual(code, 8)
        self.assertEqual(output.splitlines()[-1], summary)


class CostOfAbsence(unittest.TestCase):
    def test_each_condition_to_take_out_is_in_the_sources_once(self):
        sys.path.insert(0, os.path.join(ROOT, "bench"))
        import cost_of_absence
        for path, was, _ in cost_of_absence.MATTE:
            with open(os.path.join(ROOT, path), encoding="utf-8") as file:
                self.assertEqual(file.read().count(was), 1, f"{path}: {was}")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
