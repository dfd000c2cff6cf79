"""What `cmake --install` and `cpack -G DEB` leave is complete: programs, report, pages, completion.

    install_test.py SCENE BUILD_FOLDER
"""

import gzip
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from pictures import read_png

SCENE, BUILD = map(os.path.abspath, sys.argv[1:3])
PROGRAMS = ("hipmap", "hipmap-render", "hipmap-preprocess")


def run(*command, **options):
    return subprocess.run([*map(str, command)], capture_output=True, text=True, check=False,
                          stdin=subprocess.DEVNULL, **options)


class Install(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory(prefix="hipmap-test-")
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = temporary.name
        cls.prefix = os.path.join(cls.folder, "a prefix")
        done = run("cmake", "--install", BUILD, "--prefix", cls.prefix)
        assert done.returncode == 0, done.stderr

    def program(self, name):
        return os.path.join(self.prefix, "bin", name)

    def test_hipmap_renders_resumes_and_reports_from_there(self):
        out = os.path.join(self.folder, "out")
        command = [self.program("hipmap"), SCENE, "-o", out, "--", "--size", "24x16", "--photons",
                   "2000", "--angle", "20", "--passes"]
        done = run(*command, 2, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        listed = re.findall(r"(?m)^  (\S+) ", done.stdout)
        self.assertEqual(sorted(listed), sorted(set(os.listdir(out)) & set(listed)))
        for name in ("report.html", "cornell.png", "cornell.exr", "cornell.state"):
            self.assertIn(name, listed)
        image = read_png(os.path.join(out, "cornell.png"))
        self.assertEqual((image.width, image.height), (24, 16))
        with open(os.path.join(out, "report.html"), encoding="utf-8") as file:
            self.assertIn("20 degrees", file.read())
        again = run(*command, 3, cwd=self.folder)
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertIn("resuming with 2 passes", again.stderr)

    def test_programs_call_themselves_by_the_name_they_are_installed_under(self):
        for name in PROGRAMS:
            said = run(self.program(name), "--help")
            self.assertEqual(said.returncode, 0)
            self.assertRegex(said.stdout, rf"(?i)usage: {name} ")
            version = run(self.program(name), "--version")
            self.assertEqual(version.returncode, 0)
            self.assertRegex(version.stdout, rf"^{name.replace('hipmap-', '')} \d+\.\d+\.\d+\n$")
            wrong = run(self.program(name), "--no-such-option")
            self.assertEqual((wrong.returncode, wrong.stderr.count("\n")), (2, 1), wrong.stderr)
            self.assertIn(f"{name} --help", wrong.stderr)

    def test_manual_pages_have_every_option_of_help(self):
        for name in PROGRAMS:
            path = os.path.join(self.prefix, "share/man/man1", name + ".1.gz")
            with gzip.open(path, "rt", encoding="utf-8") as file:
                page = file.read().replace("\\-", "-")
            options = re.findall(r"(?m)^  (?:-\w[, ]+(?:[A-Z]+, )?)?(--[\w-]+)",
                                 run(self.program(name), "--help").stdout)
            self.assertGreater(len(options), 2)
            for option in set(options) - {"--help", "--version"}:
                self.assertIn(f"\\fB{option}\\fR", page, name)
            if shutil.which("man"):
                shown = run("man", "--warnings", "-l", path, env={**os.environ, "MANWIDTH": "80"})
                self.assertEqual((shown.returncode, shown.stderr), (0, ""))
                self.assertIn("EXIT STATUS", shown.stdout)

    def complete(self, name, *words):
        """What bash offers for the last word."""
        script = ('source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); '
                  '"_${1//-/_}"; printf "%s\\n" "${COMPREPLY[@]}"')
        path = os.path.join(self.prefix, "share/bash-completion/completions", name)
        return run("bash", "-c", script, "bash", path, name, *words, cwd=BUILD).stdout.split()

    def test_bash_completes_options_their_values_and_files(self):
        self.assertEqual(self.complete("hipmap-render", "--neigh"), ["--neighbours"])
        self.assertEqual(self.complete("hipmap-render", "--integrator", "p"),
                         ["progressive", "path"])
        self.assertEqual(self.complete("hipmap-preprocess", "CMakeCache"), ["CMakeCache.txt"])
        self.assertEqual(self.complete("hipmap", "a.glb", "--", "--spl"), ["--split"])

    @unittest.skipUnless(shutil.which("dpkg-shlibdeps"), "needs dpkg-dev")
    def test_the_debian_package_holds_the_same_and_names_its_libraries(self):
        done = run("cpack", "-G", "DEB", "--config", os.path.join(BUILD, "CPackConfig.cmake"),
                   "-B", self.folder)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        package, = (name for name in os.listdir(self.folder) if name.endswith(".deb"))
        package = os.path.join(self.folder, package)
        depends = run("dpkg-deb", "-f", package, "Depends").stdout
        for needed in ("python3", "libembree", "libc6"):
            self.assertIn(needed, depends)
        unpacked = os.path.join(self.folder, "unpacked")
        self.assertEqual(run("dpkg-deb", "-x", package, unpacked).returncode, 0)
        self.assertEqual(self.files_below(os.path.join(unpacked, "usr")),
                         self.files_below(self.prefix))
        render = os.path.join(unpacked, "usr/bin/hipmap-render")
        self.assertIn(os.path.basename(package).split("_")[1], run(render, "--version").stdout)
        if shutil.which("nm"):
            self.assertIn("no symbols", run("nm", render).stderr)
            self.assertNotIn("no symbols", run("nm", self.program("hipmap-render")).stderr)

    def files_below(self, top):
        return sorted(os.path.relpath(os.path.join(folder, name), top)
                      for folder, _, names in os.walk(top) for name in names)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
