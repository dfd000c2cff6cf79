"""Child processes of the add-on: a cancelled render ends within a second, and no program outlives Blender.

    processes_test.py FOLDER_OF_TOOLS
"""

import os
import signal
import subprocess
import sys
import time

import inside_blender
from child_processes import children
from inside_blender import HERE, BlenderTestCase, Tools


def is_running(pid):
    try:
        with open(f"/proc/{pid}/stat", encoding="utf-8") as file:
            return file.read().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def seconds_until_gone(pids):
    began = time.monotonic()
    while any(map(is_running, pids)) and time.monotonic() - began < 20:
        time.sleep(0.005)
    return time.monotonic() - began


class Processes(BlenderTestCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        this = cls()
        this.blender("--python", os.path.join(HERE, "f12_scenes.py"), "--", cls.folder, "lights")
        this.make_addon("hipmap.zip")

    def start(self, waiting_for):
        """Starts an endless render; returns Blender, when it has printed `waiting_for`."""
        blender = subprocess.Popen(
            inside_blender.command("--python", os.path.join(HERE, "endless_inside.py"), "--",
                                   self.path("hipmap.zip"), Tools.folder,
                                   self.path("lights.blend"), self.path("files")),
            env=inside_blender.environment(self.folder), stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.addCleanup(blender.stdout.close)
        self.addCleanup(blender.wait)
        self.addCleanup(blender.kill)
        for line in blender.stdout:
            if waiting_for in line:
                return blender
        self.fail("Blender ended")
        return None

    def test_a_cancelled_render_ends_within_a_second(self):
        blender = self.start("1 pass")
        programs = children(blender.pid)
        self.assertEqual(len(programs), 1)
        began = time.monotonic()
        blender.send_signal(signal.SIGINT)  # Esc, for a Blender without a window
        for line in blender.stdout:
            if "render returned" in line:
                break
        seconds = time.monotonic() - began
        print(f"cancelled after {seconds:.2f} s")
        self.assertLess(seconds, 1)
        self.assertFalse(any(map(is_running, programs)))
        self.assertTrue(os.path.getsize(self.path("files/Scene_ViewLayer/scene.state")) > 0)

    def test_no_program_outlives_blender(self):
        blender = self.start("1 pass")
        programs = children(blender.pid)
        self.assertEqual(len(programs), 1)
        blender.kill()
        seconds = seconds_until_gone(programs)
        print(f"gone {seconds:.2f} s after Blender was killed")
        self.assertLess(seconds, 1)


if __name__ == "__main__":
    inside_blender.main(sys.argv)
