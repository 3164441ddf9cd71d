# SPDX-License-Identifier: MIT
"""Runs the matrix: one judged pass under the oracle, then timed passes in turn without it; and some configurations in
the device's own time, which is the same in every run and so runs twice only to prove it.

A pass is one `glext-emu run ... -- walkthrough ...`. The timed passes go through all configurations round by
round, every second round backwards, so that a machine that grows slower or faster does not favour a row.
"""
import json
import subprocess
import time
from dataclasses import dataclass, field
from pathlib import Path

from .matrix import SCENE

PASS_LIMIT_S = 900
PICTURES = ("view.png", "above.png", "nodes.png")
DEVICE_PASSES = 2
# Nobody times these passes on the wall, so nothing has to be saved by counting less.
ALL_FRAGMENTS = ("--all-fragments",)
# Frames that the layer sees before the client's first: its warming up.
WARM_UP_FRAMES = 1


@dataclass
class Settings:
    """What is the same for every run. `programs`: the folder of glext-emu and walkthrough."""

    programs: Path
    out: Path
    frames: int
    scale: float
    rounds: int
    size: str
    environment: dict


@dataclass
class Pass:
    """What one run wrote: per frame the client's record and, of a timed run, the layer's."""

    frames: list
    summary: dict
    layer_frames: list
    command: list
    seconds: float


@dataclass
class Measured:
    """Everything known of one configuration."""

    judged: Pass = None
    timed: list = field(default_factory=list)


class RunFailed(Exception):
    """A run that gave no usable result; the message says which and why."""


def command_of(configuration, settings, stem, extra, layer_extra=()):
    """The command line of one pass, as a person would type it."""
    return [
        str(settings.programs / "glext-emu"), "run",
        "--device", configuration.device, "--clock", configuration.clock, "--report", f"{stem}.layer.json",
        *layer_extra, "--",
        str(settings.programs / "walkthrough"),
        "--scene", SCENE, "--culler", configuration.culler, "--size", settings.size,
        "--frames", str(settings.frames), "--scale", f"{settings.scale:g}", "--json", f"{stem}.jsonl",
        "--label", f"emulated={configuration.device}", "--label", f"clock={configuration.clock}",
        *extra,
    ]  # fmt: skip


def read_client(path):
    """The frames and the summary of a walkthrough's JSON lines."""
    lines = [json.loads(line) for line in path.read_text().splitlines() if line.strip()]
    frames = [line for line in lines if "frame" in line]
    summaries = [line["summary"] for line in lines if "summary" in line]
    if not frames or len(summaries) != 1:
        raise RunFailed(f"{path.name} holds {len(frames)} frames and {len(summaries)} summaries")
    return frames, summaries[0]


def read_layer(path, frame_count):
    """The layer's records of the last `frame_count` frames of a timed run; before them is the warm-up.

    A judged run goes on to draw after its last frame, so its records are kept on disk only.
    """
    records = json.loads(path.read_text())["records"]
    frames = [record for record in records if record["kind"] == "frame"]
    if len(frames) < frame_count:
        raise RunFailed(f"{path.name} holds {len(frames)} frames, {frame_count} were drawn")
    return frames[-frame_count:]


def run_pass(configuration, settings, pass_name, extra=(), layer_extra=()):
    """Runs once. Exit status 1 is the walkthrough's word for a false cull: its record is still read."""
    stem = settings.out / "runs" / f"{configuration.name}.{pass_name}"
    command = command_of(configuration, settings, stem, extra, layer_extra)
    begin = time.monotonic()
    try:
        done = subprocess.run(
            command,
            env=settings.environment,
            capture_output=True,
            text=True,
            timeout=PASS_LIMIT_S,
            check=False,
        )
    except subprocess.TimeoutExpired:
        raise RunFailed(f"{configuration.name}, {pass_name}: not done after {PASS_LIMIT_S} s") from None
    except OSError as error:
        raise RunFailed(f"{configuration.name}, {pass_name}: {error}") from None
    seconds = time.monotonic() - begin
    said = " ".join(done.stderr.strip().splitlines()[-1:]) or "it said nothing"
    if done.returncode not in (0, 1):
        raise RunFailed(f"{configuration.name}, {pass_name}: exit status {done.returncode}: {said}")
    try:
        frames, summary = read_client(Path(f"{stem}.jsonl"))
        layer_frames = [] if "--oracle" in extra else read_layer(Path(f"{stem}.layer.json"), len(frames))
    except (OSError, KeyError, json.JSONDecodeError) as error:
        raise RunFailed(f"{configuration.name}, {pass_name}: unreadable result: {error}; {said}") from None
    except RunFailed as error:
        raise RunFailed(f"{configuration.name}, {pass_name}: {error}; {said}") from None
    if len(frames) != settings.frames:
        raise RunFailed(
            f"{configuration.name}, {pass_name}: {len(frames)} of {settings.frames} frames; {said}"
        )
    if done.returncode == 1 and not any(frame.get("false_culls") for frame in frames):
        raise RunFailed(f"{configuration.name}, {pass_name}: exit status 1 without a false cull: {said}")
    return Pass(frames, summary, layer_frames, command, seconds)


def judge(configuration, settings, image_frame=None):
    """The pass under the oracle; with `image_frame` it also draws the three pictures."""
    extra = ["--oracle", "--oracle-cache", str(settings.out / "runs" / "oracle.cache")]
    if image_frame is not None:
        extra += ["--images", str(settings.out / "pictures"), "--image-frame", str(image_frame)]
    return run_pass(configuration, settings, "judged", extra)


def clear(out):
    """Makes the folders, and takes away what an earlier evaluation left there: nothing old may look new."""
    runs = ("*.jsonl", "*.layer.json", "*.timeline.json", "oracle.cache")
    for folder, patterns in (("runs", runs), ("pictures", PICTURES)):
        (out / folder).mkdir(parents=True, exist_ok=True)
        for pattern in patterns:
            for old in (out / folder).glob(pattern):
                old.unlink()


def timeline_file(settings, configuration):
    return settings.out / "runs" / f"{configuration.name}.timeline.json"


def measure_device_time(matrix, settings, image_frame, progress):
    """Runs each configuration DEVICE_PASSES times; the first writes the timeline of `image_frame` too.

    Returns the passes by configuration, and the failures as sentences.
    """
    measured, failures = {configuration: [] for configuration in matrix}, []
    for configuration in matrix:
        layer_frame = str(image_frame + WARM_UP_FRAMES)
        for number in range(DEVICE_PASSES):
            timeline = ("--timeline", str(timeline_file(settings, configuration)), "--frames", layer_frame)
            layer_extra = (*ALL_FRAGMENTS, *(() if number else timeline))
            progress.start(configuration, number)
            try:
                one = run_pass(configuration, settings, str(number + 1), layer_extra=layer_extra)
                if any(frame["device_ms"] is None for frame in one.frames):
                    raise RunFailed(f"{configuration.name}: the client was told no device time")
                measured[configuration].append(one)
            except RunFailed as failure:
                failures.append(str(failure))
                progress.fail(failure)
                break
            finally:
                progress.finish(configuration)
    return measured, failures


def measure(matrix, settings, image_frame, progress):
    """Runs the whole matrix. Returns what was measured by configuration, and the failures as sentences.

    A configuration whose judged pass fails is not timed; the others go on, so that one page shows all faults.
    """
    clear(settings.out)
    measured = {configuration: Measured() for configuration in matrix}
    failures = []
    painter = next((row for row in matrix if row.queries and row.device == matrix[-1].device), None)

    alive = list(matrix)
    for number in range(settings.rounds + 1):
        for configuration in list(alive if number % 2 == 0 else reversed(alive)):
            progress.start(configuration, number)
            try:
                if number == 0:
                    frame = image_frame if configuration is painter else None
                    measured[configuration].judged = judge(configuration, settings, frame)
                else:
                    timed = run_pass(configuration, settings, f"timed-{number}")
                    measured[configuration].timed.append(timed)
            except RunFailed as failure:
                failures.append(str(failure))
                alive.remove(configuration)
                progress.fail(failure)
            progress.finish(configuration)
    missing = [name for name in PICTURES if not (settings.out / "pictures" / name).exists()]
    if missing:
        failures.append(f"no picture was drawn: {', '.join(missing)}")
    return measured, failures
