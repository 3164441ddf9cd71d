# SPDX-License-Identifier: MIT
"""Run the client of these tests on a machine's clock, with effects switched off or without, and read what came of it."""
import dataclasses
import json
import os
import pathlib
import subprocess
import tempfile
import tomllib

FOLDER = pathlib.Path(__file__).resolve().parent
CLIENT = os.environ["EFFECT_CLIENT"]
LAYER = os.environ["GLEXT_EMU_LAYER"]
LAUNCHER = os.environ["GLEXT_EMU_LAUNCHER"]
EFFECTS = ("latency", "back-pressure", "fill", "driver-copy", "multisampling", "read-cost", "starvation", "saturation",
           "depth-quantisation")


def time_table(name):
    """The [time] of one of this folder's machines."""
    return tomllib.loads((FOLDER / f"{name}.toml").read_text())["time"]


@dataclasses.dataclass
class Run:
    """What a run left behind: the report's records, the results that the program was told, and the last picture."""

    frames: list
    effects: dict
    results: list
    picture: bytes

    def total_ms(self, name="device_ms"):
        return sum(frame[name] for frame in self.frames)


def settings(machine, report, without, more):
    device = machine if "/" in machine else str(FOLDER / f"{machine}.toml")
    parts = [f"device={device}", "clock=device", "fragments=all", f"report={report}", *more]
    return ",".join(parts + ([f"without={'+'.join(without)}"] if without else []))


def start(words, machine="machine", without=(), more=(), folder=None):
    """(the finished process, its report's path, its picture's path)"""
    report, picture = pathlib.Path(folder) / "report.json", pathlib.Path(folder) / "picture"
    environment = {**os.environ, "LP_NUM_THREADS": "0", "LIBGL_ALWAYS_SOFTWARE": "1", "LD_PRELOAD": LAYER,
                   "GLEXT_EMU": settings(machine, report, without, more)}
    done = subprocess.run([CLIENT, f"picture={picture}", *words], env=environment, capture_output=True, text=True,
                          timeout=120, check=False)
    return done, report, picture


def run(words, **how):
    with tempfile.TemporaryDirectory(prefix="glext_emu_effects_") as folder:
        done, report, picture = start(words, folder=folder, **how)
        if done.returncode != 0:
            raise AssertionError(f"{words}: status {done.returncode}\n{done.stdout}{done.stderr}")
        records = json.loads(report.read_text())["records"]
        return Run(frames=[record for record in records if record["kind"] == "frame"],
                   effects={record["effect"]: record for record in records if record["kind"] == "effect"},
                   results=json.loads(done.stdout)["results"], picture=picture.read_bytes())
