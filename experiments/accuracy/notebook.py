"""Results that are kept in a file while they come in."""

import json
import sys
import threading


class Notebook:
    """Results by key, written after each.  about: of what they are; those of anything else do not count.
    seconds: that all took, one after the other."""

    def __init__(self, file, about):
        self.file, self.lock = file, threading.Lock()
        self.results = {"about": json.loads(json.dumps(about)), "seconds": 0, "runs": {}}
        if not file.exists():
            return
        found = json.loads(file.read_text())
        if found["about"] == self.results["about"]:
            self.results = found
        else:
            print(f"{file} is of other programs or settings: begun anew", file=sys.stderr)

    def __getitem__(self, key):
        return self.results["runs"][key]

    def __contains__(self, key):
        return key in self.results["runs"]

    def forget(self, key):
        self.results["runs"].pop(key, None)

    def write_down(self, key, value, seconds):
        """The file is whole at any moment.  Any thread."""
        with self.lock:
            self.results["runs"][key] = value
            self.results["seconds"] += seconds
            whole = self.file.with_suffix(".new")
            whole.write_text(json.dumps(self.results) + "\n")
            whole.replace(self.file)
