"""Runs a script inside Blender that prints the seconds it rendered."""

import re
import subprocess
import sys


def processor_seconds(script, scene, arguments, home):
    """Runs script with arguments in Blender, with `home` as its home folder; ends the program with one line if that
    fails.  Returns what the script prints as "processor seconds: N".  scene: for the message."""
    # Debian's Blender takes the first python3 on the PATH, which must be Debian's too.
    done = subprocess.run(
        ["blender", "-b", "--factory-startup", "--python-exit-code", "1", "--python", str(script),
         "--", *map(str, arguments)],
        env={"PATH": "/usr/bin:/bin", "HOME": str(home)}, check=False, text=True,
        capture_output=True)
    found = re.search(r"^processor seconds: ([0-9.]+)$", done.stdout, re.MULTILINE)
    if done.returncode != 0 or found is None:
        sys.exit(f"error: {scene}: blender ended with code {done.returncode}: "
                 f"{(done.stderr.splitlines() or ['no message'])[-1]}")
    return float(found[1])
