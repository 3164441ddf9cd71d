# SPDX-License-Identifier: MIT
"""Says where the evaluation is: one moving line on a terminal, a line per pass in a pipe."""
import shutil
import sys
import time

from .runs import DEVICE_PASSES


def plain_duration(seconds):
    """`40 s` or `3 min`."""
    return f"{seconds:.0f} s" if seconds < 90 else f"{seconds / 60:.0f} min"


class Progress:
    """Expects the passes of a configuration to cost alike: good enough for an estimate."""

    def __init__(self, matrix, rounds, device_matrix=(), stream=sys.stderr):
        self.matrix = matrix
        self.device_matrix = device_matrix
        self.rounds = rounds
        self.stream = stream
        self.done = 0
        self.cost_s = {}
        self.begin_s = None

    def start(self, configuration, number):
        self.begin_s = time.monotonic()
        kind = "judged by the oracle" if number == 0 else f"timed, round {number} of {self.rounds}"
        if configuration.in_device_time:
            kind = f"in the device's own time, {number + 1} of {DEVICE_PASSES}"
        total = len(self.matrix) * (self.rounds + 1) + len(self.device_matrix) * DEVICE_PASSES
        text = f"[{self.done + 1:3}/{total}] {configuration.culler} on {configuration.device}"
        if configuration.queries and not configuration.in_device_time:
            text += f", results {configuration.latency_us:g} us late"
        text += f", {kind}" + self.left(configuration)
        if self.stream.isatty():
            width = shutil.get_terminal_size().columns - 1  # a line that wraps could not be overwritten
            self.stream.write(f"\r\x1b[K{text[:width]}")
        else:
            self.stream.write(f"{text}\n")
        self.stream.flush()

    def left(self, configuration):
        """What the remaining passes will take, once each configuration has been seen."""
        if len(self.cost_s) < len(self.matrix) or configuration.in_device_time:
            return ""
        device_rounds = len(self.device_matrix) * DEVICE_PASSES / len(self.matrix)
        rounds_left = self.rounds + 1 + device_rounds - self.done / len(self.matrix)
        return f", about {plain_duration(rounds_left * sum(self.cost_s.values()))} left"

    def finish(self, configuration):
        self.cost_s[configuration] = time.monotonic() - self.begin_s
        self.done += 1

    def close(self):
        if self.stream.isatty():
            self.stream.write("\r\x1b[K")

    def fail(self, failure):
        if self.stream.isatty():
            self.stream.write("\n")
        self.stream.write(f"FAILED: {failure}\n")
