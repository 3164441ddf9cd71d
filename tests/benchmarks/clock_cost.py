# SPDX-License-Identifier: MIT
"""What a frame costs more under --clock device than under --clock none, both under the layer on the same machine.

In each round a program makes the same frames four times, in changing order: without the clock, without it again, with
it, and with it where fragments cost nothing, so that the layer does not count them. A pair is one frame with the clock
and the same frame without, in one round; of those, the mean of both runs. A/A is one run without in terms of the other.
"""
import dataclasses
import itertools
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

DEVICE = "geforce-fx-5950"
BOUND = 1.03  # median of the pairs
SIDES = {"none": "clock=none", "none again": "clock=none", "device": "clock=device",
         "without fill": "clock=device,without=fill"}


@dataclasses.dataclass(frozen=True)
class Row:
    name: str
    program: str
    arguments: tuple
    frames: int
    once: tuple = ()  # arguments by which it is done soon


def city(culler):
    return Row(f"chc-city, {culler}", "walkthrough", ("--scene", "chc-city", "--culler", culler), 40, ("--scale", "0.05"))


ROWS = (city("frustum"), city("stop-and-wait"), city("ideal"), Row("lists", "clock_lists", (), 200))


def frames_of(row, options):
    return 3 if options.once else row.frames


def frame_times(row, side, options):
    """(milliseconds by the wall's clock, of processor time) of every frame of one run."""
    frames = frames_of(row, options)
    with tempfile.NamedTemporaryFile(mode="r", prefix="frame_times_") as file:
        library = options.build / "lib"
        environment = dict(os.environ, LP_NUM_THREADS=str(options.threads), LIBGL_ALWAYS_SOFTWARE="1",
                           LD_PRELOAD=f"{library / 'libframe_times.so'}:{library / 'libglext_emu.so'}",
                           GLEXT_EMU=f"device={DEVICE},{SIDES[side]}", FRAME_TIMES=file.name)
        arguments = [*row.arguments, *(row.once if options.once else ()), "--frames", str(frames)]
        # What walkthrough prints is for people; it says which machine it found, so that the layer is seen.
        done = subprocess.run([options.build / "bin" / row.program, *arguments], env=environment, text=True, check=False,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        if done.returncode != 0:
            sys.exit(f"{row.program} ({side}) ended with status {done.returncode}\n{done.stderr}")
        if " 1.5 " not in done.stdout:
            sys.exit(f"{row.program} ({side}): the layer was not under it\n{done.stdout}")
        lines = [line.split() for line in file.read().splitlines()]
    if len(lines) != frames:
        sys.exit(f"{row.program} ({side}): {len(lines)} frames were timed, not {frames}")
    return [tuple(int(nanoseconds) / 1e6 for nanoseconds in line) for line in lines]


def measure(row, options):
    """{side: [[ms of each frame] of each round]}"""
    # In one thread the processor's time is the frame's, whatever else the machine does meanwhile.
    which = 1 if options.threads == 0 else 0
    times = {side: [] for side in SIDES}
    names = list(SIDES)
    for number in range(options.rounds):
        turn = number % len(names)
        for side in names[turn:] + names[:turn]:
            times[side].append([frame[which] for frame in frame_times(row, side, options)])
        if sys.stderr.isatty():
            print(f"\r{row.name}: round {number + 1} of {options.rounds}", end="", file=sys.stderr, flush=True)
    if sys.stderr.isatty():
        print("\r\033[K", end="", file=sys.stderr)
    return {side: list(itertools.chain(*rounds)) for side, rounds in times.items()}


def quartiles(values):
    return tuple(statistics.quantiles(values, n=4, method="inclusive"))


def compared(times):
    both = [(a + b) / 2 for a, b in zip(times["none"], times["none again"])]
    ratios = {side: quartiles([with_clock / without for with_clock, without in zip(times[side], both)])
              for side in ("device", "without fill")}
    return {"frame_ms": statistics.median(both),
            "a_a": quartiles([b / a for a, b in zip(times["none"], times["none again"])]), **ratios}


def clock_cost(options):
    """Prints the table; returns it, and whether the bound holds in each row."""
    every_processor = os.sched_getaffinity(0)
    if options.threads == 0:
        os.sched_setaffinity(0, {max(every_processor)})
    pinned = f"pinned to processor {max(every_processor)}" if options.threads == 0 else "not pinned"
    clock = "of processor time" if options.threads == 0 else "by the clock on the wall"
    load = os.getloadavg()[0]
    print(f"\na frame under clock=device in terms of the same frame under clock=none, {clock}; device {DEVICE}")
    print(f"{'':24}{'ms':>8}{'A/A':>25}{'clock=device':>25}{'without=fill':>25}")
    results, holds = {}, True
    for row in ROWS:
        results[row.name] = result = compared(measure(row, options))
        cells = ["{1:.3f} ({0:.3f} to {2:.3f})".format(*result[column]) for column in ("a_a", "device", "without fill")]
        print(f"{row.name:24}{result['frame_ms']:8.2f}" + "".join(f"{cell:>25}" for cell in cells), flush=True)
        holds &= result["device"][1] <= BOUND
    os.sched_setaffinity(0, every_processor)
    worst = max(result["device"][1] for result in results.values())
    print(f"median of pairs at most {worst:.3f}; bound {BOUND:.2f}: {'holds' if holds else 'does not hold'}\n"
          f"medians of pairs (lower to upper quartile), {options.rounds} rounds of {frames_of(ROWS[0], options)} frames, of "
          f"lists {frames_of(ROWS[-1], options)}\nLP_NUM_THREADS={options.threads}, {pinned}, load {load:.1f} at the start; no report")
    return results, holds
