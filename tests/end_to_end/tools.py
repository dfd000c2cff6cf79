"""Runs hipmap's tools as a user does."""

import functools
import os
import subprocess
import tempfile
import unittest


class Tools:
    """folder: where the programs are.  scene: the bundled scene."""

    folder = ""
    scene = ""


def run(tool, *arguments):
    command = [os.path.join(Tools.folder, tool), *map(str, arguments)]
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          stdin=subprocess.DEVNULL, check=False)


@functools.cache
def partition_of(scene):
    """The bytes of the partition that preprocess makes of a scene without options; made once for all tests."""
    with tempfile.TemporaryDirectory(prefix="hipmap-test-") as folder:
        path = os.path.join(folder, "scene.hpm")
        done = run("preprocess", scene, "-o", path)
        assert done.returncode == 0, done.stderr
        with open(path, "rb") as file:
            return file.read()


class ToolsTestCase(unittest.TestCase):
    """Each test has an empty folder of its own."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="hipmap-test-")
        self.addCleanup(temporary.cleanup)
        self.folder = temporary.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def write_partition(self, name="scene.hpm"):
        """Of the bundled scene; returns its path."""
        with open(self.path(name), "wb") as file:
            file.write(partition_of(Tools.scene))
        return self.path(name)

    def same(self, *names):
        """Files of the folder that are to have the same bytes."""
        contents = []
        for name in names:
            with open(self.path(name), "rb") as file:
                contents.append(file.read())
        self.assertEqual(contents.count(contents[0]), len(contents), names)

    def succeed(self, tool, *arguments):
        """Runs a tool that is to succeed; returns what it printed on standard error."""
        done = run(tool, *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotRegex(done.stderr, r"(?m)^error: ")
        return done.stderr

    def refuse(self, tool, *arguments, naming):
        """Runs a tool that is to refuse its input, with one line, and to write nothing."""
        before = sorted(os.listdir(self.folder))
        done = run(tool, *arguments)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertTrue(done.stderr.startswith("error: "), done.stderr)
        self.assertIn(naming, done.stderr)
        self.assertEqual(sorted(os.listdir(self.folder)), before)


def main(arguments):
    """arguments: program, folder of the tools, scene."""
    Tools.folder, Tools.scene = arguments[1:3]
    unittest.main(argv=arguments[:1], verbosity=2)
