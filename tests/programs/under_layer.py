# SPDX-License-Identifier: MIT
"""Run a real program with the layer under it or without, for a limited time, and read what the layer reports.

The layer is named by the environment variable GLEXT_EMU_LAYER, an LD_PRELOAD value: it goes into the child
only, never under this interpreter. A run without the layer keeps the settings (GLEXT_EMU=...,report=FILE) and
loses the preload: what appears only with it was done by the layer.
"""
import dataclasses
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from Xlib import display

SKIP = 77  # the exit status that CTest is told to count as skipped


@dataclasses.dataclass
class Report:
    """The records of one report file; `path` tells which, for the message of a failing test."""

    path: pathlib.Path
    records: list

    def contexts(self, program=None):
        return [r for r in self.records if r["kind"] == "context" and program in (None, r["program"])]

    def frames(self):
        return [r for r in self.records if r["kind"] == "frame"]

    def probes(self):
        return [r for r in self.records if r["kind"] == "probe"]

    def total(self, field):
        return sum(frame[field] for frame in self.frames())


@dataclasses.dataclass
class Run:
    """What a program left behind. Status is negative where a signal ended it, report None where none was written."""

    output: str
    errors: str
    status: int
    seconds: float
    report: Report | None

    def layers_report(self):
        """The report that a run under the layer has to have left."""
        if self.report is None:
            raise AssertionError(f"the layer was not under the program: no report\n{self.output}{self.errors}")
        return self.report


class Program:
    """A started program. Use as a context manager: it never outlives the block."""

    def __init__(self, argv, layer=True, device=None, clock=None, environment=None, preload=(), probe=None):
        """`preload` names further libraries for LD_PRELOAD; they stand above the layer."""
        self.folder = tempfile.TemporaryDirectory(prefix="glext_emu_program_")
        self.report_path = pathlib.Path(self.folder.name, "report.json")
        child = dict(os.environ, **(environment or {}))
        child.pop("LD_PRELOAD", None)
        child.setdefault("XDG_RUNTIME_DIR", self.folder.name)
        settings = {"device": device, "clock": clock, "report": self.report_path, "probe": probe}
        given = [f"{key}={value}" for key, value in settings.items() if value is not None]
        child["GLEXT_EMU"] = ",".join(given)
        libraries = [*preload, *([os.environ["GLEXT_EMU_LAYER"]] if layer else [])]
        if libraries:
            child["LD_PRELOAD"] = ":".join(libraries)
        self.output = tempfile.TemporaryFile("w+", dir=self.folder.name)
        self.errors = tempfile.TemporaryFile("w+", dir=self.folder.name)
        self.started = time.monotonic()
        self.process = subprocess.Popen(argv, env=child, stdin=subprocess.DEVNULL, stdout=self.output,
                                        stderr=self.errors, cwd=self.folder.name, start_new_session=True)

    def __enter__(self):
        return self

    def __exit__(self, *unused):
        if self.process.poll() is None:
            os.killpg(self.process.pid, signal.SIGKILL)
            self.process.wait()
        self.output.close()
        self.errors.close()
        self.folder.cleanup()

    def report_now(self):
        """The report file as it stands, or None; it has to be valid JSON at any time."""
        if not self.report_path.exists():
            return None
        content = json.loads(self.report_path.read_text())
        if content.get("glext_emu_report") != 1:
            raise ValueError(f"{self.report_path} is no report of version 1")
        return Report(self.report_path, content["records"])

    def finish(self, timeout_s=60):
        """Wait for the program's own end."""
        self.process.wait(timeout_s)
        seconds = time.monotonic() - self.started
        for stream in (self.output, self.errors):
            stream.seek(0)
        return Run(self.output.read(), self.errors.read(), self.process.returncode, seconds, self.report_now())


def run(argv, layer=True, device=None, clock=None, environment=None, preload=(), timeout_s=60, probe=None):
    """Run a program that ends by itself."""
    with Program(argv, layer, device, clock, environment, preload, probe) as program:
        return program.finish(timeout_s)


def main():
    """Run the tests of the calling file; without a display there is nothing to judge."""
    if not os.environ.get("DISPLAY"):
        print("no DISPLAY: skipped")
        sys.exit(SKIP)
    # Held open: an X server resets itself, and refuses for a moment, when its last client has gone.
    server = display.Display()
    result = unittest.main(verbosity=2, exit=False).result
    server.close()
    sys.exit(0 if result.wasSuccessful() else 1)
