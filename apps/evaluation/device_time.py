# SPDX-License-Identifier: MIT
"""Frames in the emulated machine's own time: rows of them, their CSV, and what must hold of them.

A frame lasts from one swap to the next. It has no noise: every pass is the same to the bit, so a row is one pass.
"""
from dataclasses import dataclass

import numpy

from .checks import Check, column, differing_frames
from .matrix import BASELINE
from .rows import mean_of

# The client reads whole nanoseconds, rounded down, at both ends of a frame; the layer reports picoseconds.
ROUNDING_MS = 1.001e-6


@dataclass
class DeviceRow:
    """One culler. Means per frame, milliseconds of device time unless the name says otherwise.

    device_ms = what the CPU computes + stall_ms + back_pressure_ms + drain_ms; the GPU's share of the same time is
    gpu_busy_ms + starvation_ms. `draws` are draw commands beside those of the queries' boxes.
    """

    device: str
    culler: str
    queries: float
    draws: float
    drawn_triangles: float
    device_ms: float
    gpu_busy_ms: float
    stall_ms: float
    back_pressure_ms: float
    starvation_ms: float
    drain_ms: float
    speedup_of_means: float = None
    speedup_mean: float = None

    @property
    def cpu_ms(self):
        """What the CPU does itself: commands, and the swap's."""
        return self.device_ms - self.stall_ms - self.back_pressure_ms - self.drain_ms


def row_of(configuration, one, baseline):
    layer = one.layer_frames
    times = numpy.array(column(one, "device_ms"))
    row = DeviceRow(
        device=configuration.device,
        culler=configuration.culler,
        queries=mean_of(one.frames, "queries"),
        draws=mean_of(layer, "draws") - mean_of(layer, "queries_begun"),
        drawn_triangles=mean_of(one.frames, "drawn_triangles"),
        device_ms=float(times.mean()),
        gpu_busy_ms=mean_of(layer, "gpu_busy_ms"),
        stall_ms=mean_of(layer, "device_stall_ms"),
        back_pressure_ms=mean_of(layer, "back_pressure_ms"),
        starvation_ms=mean_of(layer, "starvation_ms"),
        drain_ms=mean_of(layer, "drain_ms"),
    )
    if baseline is not None:
        others = numpy.array(column(baseline, "device_ms"))
        row.speedup_of_means = float(others.mean() / times.mean())
        row.speedup_mean = float((others / times).mean())
    return row


def build_device_rows(device_measured):
    """What failed is left out (the page lists it as failed)."""
    whole = {configuration: passes[0] for configuration, passes in device_measured.items() if passes}
    baseline = next((one for configuration, one in whole.items() if configuration.culler == BASELINE), None)
    return [row_of(configuration, one, baseline) for configuration, one in whole.items()]


def every_run_takes_the_same_time(device_measured):
    faults, count = [], 0
    for configuration, passes in device_measured.items():
        for number, one in enumerate(passes[1:], start=2):
            count += 1
            wrong = differing_frames(column(passes[0], "device_ms"), column(one, "device_ms"))
            faults += [f"{configuration.name}, run {number}: frames {wrong}"] if wrong else []
    return Check("On the device's clock every run takes the same time, to the nanosecond", faults, count, "runs")


def client_and_layer_tell_the_same_time(device_measured):
    faults, count = [], 0
    for configuration, passes in device_measured.items():
        for one in passes:
            for frame, layer in zip(one.frames, one.layer_frames):
                count += 1
                if abs(frame["device_ms"] - layer["device_ms"]) > ROUNDING_MS:
                    faults.append(
                        f"{configuration.name}, frame {frame['frame']}: client {frame['device_ms']}, layer "
                        f"{layer['device_ms']} ms"
                    )
    sentence = "The client measures the device time of a frame that the layer reports"
    return Check(sentence, faults, count, "frames on the device's clock")


def the_clock_changes_nothing_drawn(device_measured, measured):
    faults, count = [], 0
    for configuration, passes in device_measured.items():
        for other, value in measured.items():
            same = (other.device, other.culler) == (configuration.device, configuration.culler)
            if not same or not value.judged or not passes:
                continue
            count += 1
            wrong = differing_frames(
                column(value.judged, "drawn_triangles"), column(passes[0], "drawn_triangles")
            )
            faults += [f"{configuration.name} against {other.name}: frames {wrong}"] if wrong else []
    return Check("The device's clock changes nothing that is drawn", faults, count, "pairs of runs")


def run_device_checks(device_measured, measured):
    return [
        every_run_takes_the_same_time(device_measured),
        client_and_layer_tell_the_same_time(device_measured),
        the_clock_changes_nothing_drawn(device_measured, measured),
    ]
