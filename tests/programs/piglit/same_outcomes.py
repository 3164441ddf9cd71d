#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Piglit's outcomes under `device=mesa` are those without the layer: each test, each subtest, both directions.

  same_outcomes.py [CLOCK]        CLOCK as in GLEXT_EMU: the same has to hold for results that come late

Each test is run bare and under the layer right after each other, so that both see the same machine. Where the
two differ, the bare one is run some more: where Mesa itself gives the layer's outcome too, the test is named
as flaky; any other difference fails. That the layer was there is read from its report.
"""
import collections
import concurrent.futures
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


def layer_environment(report, clock):
    return dict(run_piglit.piglit_environment(), LD_PRELOAD=os.environ["GLEXT_EMU_LAYER"],
                GLEXT_EMU=f"device=mesa,clock={clock},report={report}")


def was_reported(report):
    """True where the layer reported a context in this file."""
    if not report.exists():
        return False
    return any(record["kind"] == "context" for record in json.loads(report.read_text())["records"])


def run_pair(job, clock, folder):
    """One test bare and under the layer: (bare, layer, whether the layer reported a context)."""
    report = pathlib.Path(folder, f"{job.mode}-{job.name}.json".replace("/", "_"))
    bare = run_piglit.run_job(job, run_piglit.piglit_environment())
    layer = run_piglit.run_job(job, layer_environment(report, clock))
    return bare, layer, was_reported(report)


def judge(job, pair):
    """What is wrong with this test as a list of sentences, and a note where Mesa itself is flaky."""
    bare, layer, reported = pair
    wrong, note = [], None
    if "missing" in (bare.result, layer.result):
        wrong.append(f"{job.name}: the program {job.argv[0]} is missing")
    elif bare.result != "skip" and not reported:
        wrong.append(f"{job.mode} {job.name}: the layer was not under it (no context in its report)")
    if bare.verdict() != layer.verdict():
        differ = f"{job.mode} {job.name}: without {bare.verdict()}, with {layer.verdict()}"
        again = [run_piglit.run_job(job, run_piglit.piglit_environment()).verdict() for _ in range(BARE_AGAIN)]
        if layer.verdict() in again:
            note = f"flaky in Mesa itself, which gave both within {BARE_AGAIN + 1} runs: {differ}"
        else:
            last = "".join(f"\n      | {line}" for line in layer.output.splitlines()[-5:])
            wrong.append(f"never so in {BARE_AGAIN + 1} runs without the layer: {differ}{last}")
    return wrong, note


def main():
    if not os.environ.get("DISPLAY"):
        print("no DISPLAY: skipped")
        sys.exit(SKIP)
    clock = sys.argv[1] if len(sys.argv) == 2 else "none"
    jobs = run_piglit.read_jobs("both")
    if len({job.name for job in jobs}) != EXPECTED_TESTS:
        sys.exit(f"piglit_core.tsv lists {len({job.name for job in jobs})} tests, not {EXPECTED_TESTS}")
    server = display.Display()  # held open: an X server resets itself, and refuses, when its last client has gone
    started = time.monotonic()
    wrong, notes = [], []
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        pairs = list(pool.map(lambda job: run_pair(job, clock, folder), jobs))
        for job, pair in zip(jobs, pairs):
            sentences, note = judge(job, pair)
            wrong += sentences
            notes += [note] if note else []
    server.close()
    for side, name in ((0, "without the layer"), (1, f"under device=mesa, clock={clock}")):
        counts = collections.Counter(pair[side].result for pair in pairs)
        subtests = collections.Counter(result for pair in pairs for result in pair[side].subtests.values())
        print(f"{name}: {len(pairs)} runs of {EXPECTED_TESTS} tests, {dict(counts)}; subtests {dict(subtests)}")
    print(f"{time.monotonic() - started:.0f} s, {len(wrong)} wrong")
    print("\n".join(notes + wrong))
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
