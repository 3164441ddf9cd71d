#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Piglit's outcomes under `device=mesa` are those without the layer: each test, each subtest, both directions.

  same_outcomes.py SIDE...        a side is FRONT or FRONT:CLOCK: seam, vendor:calls=100

Each test is run bare and then on each side, right after each other, so that all see the same machine. Where two
differ, the bare one is run some more: where Mesa itself gives the layer's outcome too, the test is named as flaky;
any other difference fails. That the layer was there is read from its report.
"""
import collections
import concurrent.futures
import dataclasses
import json
import os
import pathlib
import sys
import tempfile
import time

from Xlib import display

import run_piglit

SKIP = 77  # the exit status that CTest is told to count as skipped
EXPECTED_TESTS = 52
BARE_AGAIN = 5  # runs without the layer that a difference has to be explained by


def on_side(side, job, report):
    """The job under the layer: what to run, and in which environment."""
    front, _, clock = side.partition(":")
    environment = run_piglit.piglit_environment()
    if front == "seam":
        environment["LD_PRELOAD"] = os.environ["GLEXT_EMU_LAYER"]
        environment["GLEXT_EMU"] = f"device=mesa,clock={clock or 'none'},report={report}"
        return job, environment
    launcher = (os.environ["GLEXT_EMU_LAUNCHER"], "run", "--front", front, "--device", "mesa",
                "--clock", clock or "none", "--report", str(report), "--")
    return dataclasses.replace(job, argv=launcher + job.argv), environment


def was_reported(report):
    """True where the layer reported a context in this file."""
    if not report.exists():
        return False
    return any(record["kind"] == "context" for record in json.loads(report.read_text())["records"])


def run_sides(job, sides, folder):
    """One test without the layer, and on each side: outcome, {side: (outcome, whether the layer reported)}."""
    bare = run_piglit.run_job(job, run_piglit.piglit_environment())
    layered = {}
    for side in sides:
        report = pathlib.Path(folder, f"{side}-{job.mode}-{job.name}.json".replace("/", "_"))
        layered[side] = run_piglit.run_job(*on_side(side, job, report)), was_reported(report)
    return bare, layered


def judge(job, bare, side, layer, reported):
    """What is wrong with this test as a list of sentences, and a note where Mesa itself is flaky."""
    wrong, note = [], None
    if "missing" in (bare.result, layer.result):
        wrong.append(f"{side} {job.name}: the program {job.argv[0]} is missing")
    elif bare.result != "skip" and not reported:
        wrong.append(f"{side} {job.mode} {job.name}: the layer was not under it (no context in its report)")
    if bare.verdict() != layer.verdict():
        differ = f"{side} {job.mode} {job.name}: without {bare.verdict()}, with {layer.verdict()}"
        again = [run_piglit.run_job(job, run_piglit.piglit_environment()).verdict() for _ in range(BARE_AGAIN)]
        if layer.verdict() in again:
            note = f"flaky in Mesa itself, which gave both within {BARE_AGAIN + 1} runs: {differ}"
        else:
            last = "".join(f"\n      | {line}" for line in layer.output.splitlines()[-5:])
            wrong.append(f"never so in {BARE_AGAIN + 1} runs without the layer: {differ}{last}")
    return wrong, note


def tell(name, outcomes):
    counts = collections.Counter(outcome.result for outcome in outcomes)
    subtests = collections.Counter(result for outcome in outcomes for result in outcome.subtests.values())
    print(f"{name}: {len(outcomes)} runs of {EXPECTED_TESTS} tests, {dict(counts)}; subtests {dict(subtests)}")


def main():
    if not os.environ.get("DISPLAY"):
        print("no DISPLAY: skipped")
        sys.exit(SKIP)
    sides = sys.argv[1:]
    if not sides:
        sys.exit(__doc__)
    jobs = run_piglit.read_jobs("both")
    if len({job.name for job in jobs}) != EXPECTED_TESTS:
        sys.exit(f"piglit_core.tsv lists {len({job.name for job in jobs})} tests, not {EXPECTED_TESTS}")
    server = display.Display()  # held open: an X server resets itself, and refuses, when its last client has gone
    started = time.monotonic()
    wrong, notes = [], []
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        runs = list(pool.map(lambda job: run_sides(job, sides, folder), jobs))
        for job, (bare, layered) in zip(jobs, runs):
            for side, (layer, reported) in layered.items():
                sentences, note = judge(job, bare, side, layer, reported)
                wrong += sentences
                notes += [note] if note else []
    server.close()
    tell("without the layer", [bare for bare, _ in runs])
    for side in sides:
        tell(f"device mesa, {side}", [layered[side][0] for _, layered in runs])
    print(f"{time.monotonic() - started:.0f} s, {len(wrong)} wrong")
    print("\n".join(notes + wrong))
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
