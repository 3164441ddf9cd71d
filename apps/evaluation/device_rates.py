# SPDX-License-Identifier: MIT
"""How fast two Debian programs would run on emulated machines, in frames of device time, and where the time goes.

usage: python3 -m apps.evaluation.device_rates [--programs FOLDER] [--devices A,B,..]

Needs an X display (xvfb-run gives one). Prints a table in Markdown. glxgears turns its gears by the clock on the wall, so
which pictures it draws differs from run to run; osgocclusionquery, of its own stock scene, draws the same ones always.
"""
import argparse
import json
import os
import signal
import statistics
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
DEVICES = ("geforce2-gts", "geforce-fx-5950", "radeon-hd5770")
# The first frames also load what later ones use.
WARM_UP_FRAMES = 10
LIMIT_S = 120


@dataclass(frozen=True)
class Program:
    """`seconds`: after so long it is ended, for it does not end by itself; None: it does."""

    name: str
    command: tuple
    environment: dict
    seconds: float = None


PROGRAMS = (
    Program("glxgears", ("glxgears", "-geometry", "300x300"), {}, seconds=4),
    Program(
        "osgocclusionquery",
        ("osgocclusionquery",),
        {"OSG_WINDOW": "0 0 800 600", "OSG_THREADING": "SingleThreaded", "OSG_RUN_FRAME_COUNT": "110"},
    ),
)


class RunFailed(Exception):
    """A program left no usable report; the message says which and why."""


def frames_of(program, device, programs):
    """The layer's records of the program's frames on the device, without the first ones."""
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder, "report.json")
        layer = (str(programs / "glext-emu"), "run", "--device", device, "--clock", "device", "--report", str(report))
        environment = {**os.environ, "LIBGL_ALWAYS_SOFTWARE": "1", **program.environment}
        process = subprocess.Popen(
            [*layer, "--", *program.command], env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
            text=True, start_new_session=True,
        )  # fmt: skip
        try:
            _, said = process.communicate(timeout=program.seconds or LIMIT_S)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGTERM)
            _, said = process.communicate()
        if not report.exists():
            raise RunFailed(f"{program.name} on {device}: no report: {said.strip() or 'it said nothing'}")
        records = json.loads(report.read_text())["records"]
    frames = [record for record in records if record["kind"] == "frame"][WARM_UP_FRAMES:]
    if not frames:
        raise RunFailed(f"{program.name} on {device}: too few frames: {said.strip() or 'it said nothing'}")
    return frames


def row_of(program, device, frames):
    """Cells of the table: the rate is frames by their summed device time."""
    mean = {key: statistics.fmean(frame[key] for frame in frames) for key in frames[0] if key.endswith("_ms")}
    frame_ms = mean["device_ms"]
    waits_ms = mean["device_stall_ms"] + mean["back_pressure_ms"] + mean["drain_ms"]

    def share(part_ms):
        return f"{part_ms / frame_ms:.0%}"

    return (
        program.name, f"`{device}`", f"{1000 / frame_ms:,.0f}", f"{frame_ms:.3f}", share(mean["gpu_busy_ms"]),
        share(mean["starvation_ms"]), share(frame_ms - waits_ms), share(mean["device_stall_ms"]),
        share(mean["back_pressure_ms"]), share(mean["drain_ms"]),
    )  # fmt: skip


HEADINGS = (
    "program", "device", "frames a second", "a frame, ms", "GPU: works", "starves", "CPU: computes", "stalls",
    "FIFO full", "drains",
)  # fmt: skip


def main():
    parser = argparse.ArgumentParser(prog="device_rates", description=__doc__.splitlines()[0])
    parser.add_argument("--programs", type=Path, default=ROOT / "build/release/bin", help="where glext-emu is")
    parser.add_argument("--devices", default=",".join(DEVICES), help="names or .toml files, with commas between")
    options = parser.parse_args()
    if "DISPLAY" not in os.environ:
        parser.error("there is no X display: run it by xvfb-run")
    print("| " + " | ".join(HEADINGS) + " |\n|---|---|" + "---:|" * (len(HEADINGS) - 2), flush=True)
    failures = 0
    for program in PROGRAMS:
        for device in options.devices.split(","):
            try:
                cells = row_of(program, device, frames_of(program, device, options.programs))
                print("| " + " | ".join(cells) + " |", flush=True)
            except RunFailed as failure:
                failures += 1
                print(f"device_rates: {failure}", file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
