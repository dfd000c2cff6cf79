# SPDX-License-Identifier: GPL-3.0-or-later
"""Renders previews by hipmap's programs on a thread of its own, which uses nothing of Blender."""

import json
import os
import threading
from dataclasses import dataclass

import numpy

from .run import Child, ToolError, read_pfm

_SECONDS_BETWEEN_LOOKS = 0.02
# A picture of a sixteenth of the pixels comes first where it is much sooner there.
_COARSE = 4
_FEWEST_PIXELS = 20_000
_PHOTONS = 100_000


@dataclass(frozen=True)
class Wish:
    """What is to be shown."""

    scene: object  # a ViewportScene
    view: object  # a View


@dataclass(frozen=True)
class Shown:
    """A picture that is ready."""

    wish: Wish
    pixels: numpy.ndarray  # [height * width, 4] scene linear, from the bottom left
    width: int
    height: int


class _Outdated(Exception):
    """Something newer is wished for."""


class Preview:
    """A thread that renders the latest wish.  All functions return at once."""

    def __init__(self, folder, programs):
        """folder: for its files; programs: paths by name."""
        self._folder, self._programs = folder, programs
        self._changed = threading.Condition()
        self._wish, self._closing = None, False
        self._scene = None  # whose partition is there
        self.shown = None
        self.told = ""  # what the thread does, or why it failed
        self._thread = threading.Thread(target=self._work, name="hipmap preview", daemon=True)
        self._thread.start()

    def show(self, wish):
        """Renders this from now on."""
        with self._changed:
            self._wish = wish
            self._changed.notify()

    def close(self):
        """Ends the program that runs, and the thread."""
        with self._changed:
            self._closing = True
            self._changed.notify()

    def has_ended(self):
        """Whether the thread and its program have ended, after close()."""
        return not self._thread.is_alive()

    def is_of(self, wish):
        """Whether the picture shown is of this wish."""
        return self.shown is not None and self.shown.wish is wish

    def _path(self, name):
        return os.path.join(self._folder, name)

    def _work(self):
        done = None
        while True:
            with self._changed:
                self._changed.wait_for(lambda done=done: self._closing or self._wish is not done)
                if self._closing:
                    return
                wish = self._wish
            try:
                self._render(wish)
                done = wish
            except _Outdated:
                continue
            except (ToolError, OSError) as error:
                self.told = str(error)
                done = wish

    def _check(self, wish):
        """Throws _Outdated if it is better to begin anew: a view that follows another waits for a
        picture, so that there are pictures while the view moves."""
        if self._closing or self._wish.scene is not wish.scene:
            raise _Outdated
        if self._wish is not wish and self.is_of(wish):
            raise _Outdated

    def _run(self, command, wish, on_event):
        """Runs a program to its end.  Returns it, and its exit code.  Throws _Outdated."""
        child = Child(command)
        try:
            while child.running():
                for event in child.events():
                    on_event(event)
                self._check(wish)
                with self._changed:
                    self._changed.wait(_SECONDS_BETWEEN_LOOKS)
        except BaseException:
            child.stop(0)
            self._remove_leftovers()
            raise
        code = child.finish()
        for event in child.events():
            on_event(event)
        return child, code

    def _remove_leftovers(self):
        for name in os.listdir(self._folder):
            if name.startswith(".hipmap-") and name.endswith(".tmp"):
                os.remove(self._path(name))

    def _render(self, wish):
        scene = wish.scene
        if scene is not self._scene:
            self._bake(wish)
        scene.write(self._path("scene.glb"), wish.view)
        if scene is not self._scene:
            self._make_partition(wish)
            self._scene = scene
        width, height = wish.view.size
        if width * height >= _FEWEST_PIXELS:
            coarse = (max(width // _COARSE, 1), max(height // _COARSE, 1))
            self._render_passes(wish, coarse, 1)
        self._render_passes(wish, wish.view.size, scene.passes)

    def _bake(self, wish):
        for bake in wish.scene.bakes:
            if os.path.isfile(bake.path):
                continue
            self.told = "rendering the world"
            child, code = self._run(bake.command, wish, lambda event: None)
            if code != 0 or not os.path.isfile(bake.path):
                raise ToolError(str(bake.failed(child.last_error())))

    def _make_partition(self, wish):
        key = wish.scene.geometry + " ".join(wish.scene.partition_options)
        notes = self._path("partition.json")
        if os.path.isfile(notes):
            with open(notes, encoding="utf-8") as file:
                if json.load(file) == key:
                    return
            os.remove(notes)
        self.told = "finding faces that share photons"
        child, code = self._run(
            [self._programs["preprocess"], self._path("scene.glb"), "-o", self._path("scene.hpm"),
             *wish.scene.partition_options], wish, lambda event: None)
        if code != 0:
            raise ToolError(child.last_error())
        with open(notes, "w", encoding="utf-8") as file:
            json.dump(key, file)

    def _render_passes(self, wish, size, passes):
        command = [self._programs["render"], self._path("scene.glb"), self._path("scene.hpm"),
                   "-o", self._path("preview.pfm"), "--progress", "json",
                   "--integrator", "direct", "--size", f"{size[0]}x{size[1]}", "--samples", "1",
                   "--photons", str(_PHOTONS), "--passes", str(passes), *wish.scene.options]
        child, code = self._run(command, wish, lambda event: self._take(event, wish))
        if code != 0:
            raise ToolError(child.last_error())

    def _take(self, event, wish):
        if event.get("images"):
            self.shown = Shown(wish, *read_pfm(self._path("preview.pfm")))
            count = event["passes"]
            self.told = f"{count} of {wish.scene.passes} passes, direct estimate"
