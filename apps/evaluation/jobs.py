# SPDX-License-Identifier: MIT
"""Walks under the layer that take minutes and need not be taken twice.

A job is one `glext-emu run ... -- walkthrough ...`. Its result stays in a file beside a key that stands for the
command and for the programs that ran it; a job whose key is there already is not run again, so a run that was killed
goes on where it was. Nothing half written is ever taken: results get their names when they are whole.
"""
import hashlib
import json
import os
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from .progress import plain_duration
from .runs import RunFailed, read_client

JOB_LIMIT_S = 4 * 3600


@dataclass(frozen=True)
class Job:
    """One walk. `frames` are of the whole path; `sections` (count, frames each) walks only parts of it."""

    scene: str
    culler: str
    device: str
    clock: str = "device"
    size: str = "640x480"
    frames: int = 40
    sections: tuple = ()
    scale: float = 1
    knobs: tuple = ()  # (name, value) pairs
    judge_every: int = 0  # 0: no oracle
    extra: tuple = ()  # further words of the walkthrough's command line
    repeat: int = 0  # tells jobs apart that are the same, to see the noise

    @property
    def name(self):
        """Also the stem of its files."""
        words = [self.scene, self.culler, self.device, self.clock, self.size, f"{self.frames}f"]
        words += [f"{self.sections[0]}x{self.sections[1]}"] if self.sections else []
        words += [f"s{self.scale:g}"] + [f"{name}={value:g}" for name, value in self.knobs]
        words += [word.strip("-") for word in self.extra] + ([f"again{self.repeat}"] if self.repeat else [])
        return ".".join(words).replace("/", "_")

    def client_words(self):
        words = ["--scene", self.scene, "--culler", self.culler, "--size", self.size,
                 "--frames", str(self.frames), "--scale", f"{self.scale:.10g}"]  # fmt: skip
        if self.sections:
            words += ["--sections", f"{self.sections[0]}x{self.sections[1]}"]
        for name, value in self.knobs:
            words += ["--set", f"{name}={value:g}"]
        if self.judge_every:
            words += ["--oracle", "--judge-every", str(self.judge_every)]
        return [*words, *self.extra]

    def command(self, programs, stem):
        """As a person would type it. All fragments are counted: nobody times these walks on the wall, unless
        the clock is none."""
        layer = ["--device", self.device, "--clock", self.clock, "--report", f"{stem}.layer.json"]
        if self.clock == "device":
            layer.append("--all-fragments")
        return [
            str(programs / "glext-emu"), "run", *layer, "--",
            str(programs / "walkthrough"), *self.client_words(), "--json", f"{stem}.jsonl",
        ]  # fmt: skip


@dataclass
class Result:
    """Per reported frame the client's record, and the layer's of the same frame."""

    frames: list
    layer_frames: list
    summary: dict
    seconds: float

    def column(self, key):
        return [frame[key] for frame in self.frames]

    def mean(self, key):
        values = [frame[key] for frame in self.frames if frame.get(key) is not None]
        return sum(values) / len(values) if values else None

    def total(self, key):
        return sum(frame.get(key, 0) for frame in self.frames)

    def layer_mean(self, key):
        return sum(frame[key] for frame in self.layer_frames) / len(self.layer_frames)


class Jobs:
    """Runs jobs, or finds what they wrote."""

    def __init__(self, programs, folder, environment, parallel=1, stream=sys.stderr):
        self.programs = programs
        self.folder = folder
        self.environment = environment
        self.parallel = parallel
        self.stream = stream
        self.fingerprint = fingerprint_of(programs)
        folder.mkdir(parents=True, exist_ok=True)

    def run(self, jobs):
        """Results by job, and the failures as sentences. Jobs that are timed on the wall run alone."""
        jobs = list(dict.fromkeys(jobs))
        results, failures = {}, []
        missing = []
        for job in jobs:
            known = self.find(job)
            if known is None:
                missing.append(job)
            else:
                results[job] = known
        started, done = time.monotonic(), 0

        def report(job, text):
            spent = time.monotonic() - started
            left = spent / done * (len(missing) - done) if done else None
            when = f", about {plain_duration(left)} left" if left else ""
            self.stream.write(f"[{len(jobs) - len(missing) + done:3}/{len(jobs)}] {job.name}: {text}{when}\n")
            self.stream.flush()

        if len(missing) < len(jobs):
            self.stream.write(f"{len(jobs) - len(missing)} of {len(jobs)} walks are there already\n")
        together = [job for job in missing if job.clock == "device"]
        alone = [job for job in missing if job.clock != "device"]
        for group, width in ((together, self.parallel), (alone, 1)):
            with ThreadPoolExecutor(width) as pool:
                for job, outcome in zip(group, pool.map(self.attempt, group)):
                    done += 1
                    if isinstance(outcome, RunFailed):
                        failures.append(str(outcome))
                        report(job, f"FAILED: {outcome}")
                    else:
                        results[job] = outcome
                        report(job, plain_duration(outcome.seconds))
        return results, failures

    def attempt(self, job):
        try:
            return self.run_one(job)
        except RunFailed as failure:
            return failure

    def stem(self, job):
        return self.folder / job.name

    def key(self, job):
        """Stands for all that the result depends on."""
        words = [*job.command(Path("."), "x"), self.fingerprint]
        return hashlib.sha256("\n".join(words).encode()).hexdigest()

    def find(self, job):
        try:
            kept = json.loads(Path(f"{self.stem(job)}.json").read_text(encoding="utf-8"))
            if kept["key"] != self.key(job):
                return None
            return Result(kept["frames"], kept["layer_frames"], kept["summary"], kept["seconds"])
        except (OSError, ValueError, KeyError):
            return None

    def run_one(self, job):
        stem = self.stem(job)
        began = time.monotonic()
        command = job.command(self.programs, stem)
        try:
            done = subprocess.run(command, env=self.environment, capture_output=True, text=True,
                                  timeout=JOB_LIMIT_S, check=False)  # fmt: skip
        except subprocess.TimeoutExpired:
            raise RunFailed(f"{job.name}: not done after {JOB_LIMIT_S} s") from None
        except OSError as error:
            raise RunFailed(f"{job.name}: {error}") from None
        said = " ".join(done.stderr.strip().splitlines()[-1:]) or "it said nothing"
        if done.returncode not in (0, 1):
            raise RunFailed(f"{job.name}: exit status {done.returncode}: {said}")
        try:
            frames, summary = read_client(Path(f"{stem}.jsonl"))
            layer_frames = read_layer_of(Path(f"{stem}.layer.json"), frames)
        except (OSError, ValueError, KeyError, IndexError) as error:
            raise RunFailed(f"{job.name}: unreadable result: {error}; {said}") from None
        if job.clock == "device" and any(frame["device_ms"] is None for frame in frames):
            raise RunFailed(f"{job.name}: the client was told no device time")
        result = Result(frames, layer_frames, summary, time.monotonic() - began)
        self.keep(job, result)
        return result

    def keep(self, job, result):
        """One file, whole or not at all; what the two programs wrote is in it."""
        stem = self.stem(job)
        kept = {"key": self.key(job), "seconds": result.seconds, "summary": result.summary,
                "frames": result.frames, "layer_frames": result.layer_frames}  # fmt: skip
        part = Path(f"{stem}.json.part")
        part.write_text(json.dumps(kept), encoding="utf-8")
        os.replace(part, f"{stem}.json")
        for suffix in (".jsonl", ".layer.json"):
            Path(f"{stem}{suffix}").unlink(missing_ok=True)


def read_layer_of(path, frames):
    """The layer's records of the client's frames, found by the swap that each ends with."""
    records = [r for r in json.loads(path.read_text(encoding="utf-8"))["records"] if r["kind"] == "frame"]
    return [records[frame["swap"]] for frame in frames]


def fingerprint_of(programs):
    """Of everything that runs: another build is another result."""
    digest = hashlib.sha256()
    for file in (programs / "walkthrough", *sorted((programs.parent / "lib").glob("*.so*"))):
        if file.is_file():
            digest.update(file.read_bytes())
    return digest.hexdigest()
