"""Runs Blender without a window, from a clean profile, for tests."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
BLENDER_FOLDER = os.path.join(ROOT, "blender")
SKIPPED = 77

# Debian's Blender takes the first python3 of the PATH, which must be Debian's too.
_PATH = "/usr/bin:/bin"


class Tools:
    """folder: where hipmap's programs are."""

    folder = ""


def command(*arguments):
    """The command line of a Blender that ends with code 1 if its script fails."""
    return [shutil.which("blender", path=_PATH), "--background", "--factory-startup",
            "--python-exit-code", "1", *map(str, arguments)]


def window_command(*arguments):
    """The command line of a Blender with a window on a screen of its own."""
    return ["xvfb-run", "-a", "-s", "-screen 0 640x400x24",
            *(word for word in command("-p", "0", "0", "640", "400", *arguments)
              if word != "--background")]


def environment(home):
    """Variables of a Blender whose profile is the empty folder `home`."""
    return {"PATH": _PATH, "HOME": str(home), "HIPMAP_BIN": Tools.folder}


class BlenderTestCase(unittest.TestCase):
    """Each class has an empty folder of its own."""

    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory(prefix="hipmap-blender-")
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = temporary.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def blender(self, *arguments):
        """Runs Blender; returns what it printed.  Fails if its script does."""
        return self._run(command(*arguments))

    def blender_window(self, *arguments):
        """Runs Blender with a window."""
        return self._run(window_command(*arguments))

    def make_addon(self, name, *arguments):
        """Writes the zip of the add-on."""
        subprocess.run([sys.executable, os.path.join(BLENDER_FOLDER, "make_addon.py"),
                        self.path(name), *arguments], check=True, stdout=subprocess.DEVNULL)

    def _run(self, words):
        done = subprocess.run(words, env=environment(self.folder), check=False,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, timeout=300)
        self.assertEqual(done.returncode, 0, done.stdout)
        return done.stdout

    def tool(self, name, *arguments):
        """Runs one of hipmap's programs; returns what it printed on standard error."""
        done = subprocess.run([os.path.join(Tools.folder, name), *map(str, arguments)], text=True,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stderr


def main(arguments):
    """arguments: program, folder of the tools, options of unittest."""
    Tools.folder = os.path.abspath(arguments[1])
    if shutil.which("blender", path=_PATH) is None:
        print("skipped: blender is not installed; apt-get install blender runs these tests")
        sys.exit(SKIPPED)
    unittest.main(argv=arguments[:1] + arguments[2:], verbosity=2)
