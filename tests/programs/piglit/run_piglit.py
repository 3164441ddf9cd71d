#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Run the occlusion-related piglit tests, a process each, and tell each result.

  run_piglit.py [--mode fbo|winsys|both] [--platform P] [--preload LIB.so] [--env K=V ...] [-t REGEX] [-j N]
                [--timeout S] [-o OUT.tsv] [-v]

The list (piglit_core.tsv) has lines of   group TAB piglit-name TAB command (binary and arguments). In mode
`fbo` a command is run as piglit's own profile has it (most end in "-auto -fbo"); in `winsys` the "-fbo" is
taken away, and a test without it is left out; `both` runs each. Piglit's failures are results like others:
exit status 0 unless a test's program is missing, then 1.
"""
import argparse
import collections
import concurrent.futures
import dataclasses
import json
import os
import pathlib
import re
import subprocess
import sys
import time

PIGLIT_ROOT = os.environ.get("PIGLIT_ROOT", "/usr/lib/x86_64-linux-gnu/piglit")
LIST = pathlib.Path(__file__).with_name("piglit_core.tsv")


@dataclasses.dataclass(frozen=True)
class Job:
    group: str
    name: str
    mode: str  # fbo or winsys
    argv: tuple


@dataclasses.dataclass
class Outcome:
    job: Job
    result: str  # pass, fail, skip, warn, timeout, crash(SIGNAL), noresult(rc=STATUS) or missing
    subtests: dict
    seconds: float
    output: str

    def verdict(self):
        """What two runs are compared by."""
        return self.result, tuple(sorted(self.subtests.items()))


def read_jobs(mode, pattern=None, path=LIST):
    jobs = []
    for line in path.read_text().splitlines():
        if not line or line.startswith("#"):
            continue
        group, name, command = line.split("\t")
        if pattern and not re.search(pattern, name):
            continue
        binary, *arguments = command.split()
        program = os.path.join(PIGLIT_ROOT, "bin", os.path.basename(binary))
        if mode in ("fbo", "both"):
            jobs.append(Job(group, name, "fbo", (program, *arguments)))
        if mode == "winsys" or (mode == "both" and "-fbo" in arguments):
            jobs.append(Job(group, name, "winsys", (program, *(a for a in arguments if a != "-fbo"))))
    return jobs


def run_job(job, environment, timeout_s=120):
    """Run one test; what it says on its lines `PIGLIT: {...}` counts, unless it died."""
    started = time.monotonic()
    try:
        done = subprocess.run(job.argv, env=environment, cwd=PIGLIT_ROOT, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, timeout=timeout_s, check=False)
        output, status = done.stdout.decode("utf-8", "replace"), done.returncode
    except FileNotFoundError:
        return Outcome(job, "missing", {}, 0.0, "")
    except subprocess.TimeoutExpired as expired:
        output, status = (expired.stdout or b"").decode("utf-8", "replace"), None
    result, subtests = None, {}
    for line in output.splitlines():
        if line.startswith("PIGLIT: "):
            try:
                said = json.loads(line[len("PIGLIT: "):])
            except ValueError:  # two threads may have written into one line
                continue
            result = said.get("result", result)
            subtests.update(said.get("subtest", {}))
    if status is None:
        result = "timeout"
    elif status < 0:
        result = f"crash({-status})"
    elif result is None:
        result = f"noresult(rc={status})"
    return Outcome(job, result, subtests, time.monotonic() - started, output)


def piglit_environment(platform=None, extra=()):
    """The caller's environment, without any preload of its own, as piglit wants it."""
    environment = dict(os.environ, PIGLIT_SOURCE_DIR=PIGLIT_ROOT)
    environment.pop("LD_PRELOAD", None)
    environment.setdefault("PIGLIT_NO_WINDOW", "0")
    if platform:
        environment["PIGLIT_PLATFORM"] = platform
    environment.update(setting.split("=", 1) for setting in extra)
    return environment


def run_all(jobs, environment, threads=1, timeout_s=120):
    with concurrent.futures.ThreadPoolExecutor(threads) as pool:
        yield from pool.map(lambda job: run_job(job, environment, timeout_s), jobs)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--mode", default="fbo", choices=["fbo", "winsys", "both"])
    parser.add_argument("--platform", help="PIGLIT_PLATFORM: glx, x11_egl, mixed_glx_egl, surfaceless_egl, gbm")
    parser.add_argument("--preload")
    parser.add_argument("--env", action="append", default=[])
    parser.add_argument("-t", metavar="REGEX")
    parser.add_argument("-j", type=int, default=1)
    parser.add_argument("--timeout", type=int, default=120)
    parser.add_argument("-o", metavar="OUT.tsv")
    parser.add_argument("-v", action="store_true", help="show each test's last lines")
    options = parser.parse_args()

    environment = piglit_environment(options.platform, options.env)
    if options.preload:
        environment["LD_PRELOAD"] = options.preload
    outcomes = []
    for outcome in run_all(read_jobs(options.mode, options.t), environment, options.j, options.timeout):
        outcomes.append(outcome)
        not_passed = [f"{name}={result}" for name, result in sorted(outcome.subtests.items()) if result != "pass"]
        subtests = f"  [{len(outcome.subtests)} subtests {' '.join(not_passed)}]" if outcome.subtests else ""
        print(f"{outcome.result:10} {outcome.seconds:6.2f}s {outcome.job.mode:7} {outcome.job.name}{subtests}",
              flush=True)
        if options.v or outcome.result not in ("pass", "skip", "missing"):
            print("".join(f"      | {line}\n" for line in outcome.output.splitlines()[-12:]), end="")
    counts = collections.Counter(outcome.result for outcome in outcomes)
    print(f"TOTAL {len(outcomes)}  " + "  ".join(f"{result}={count}" for result, count in sorted(counts.items())))
    if options.o:
        with open(options.o, "w", encoding="utf-8") as table:
            table.write("#group\tname\tmode\tresult\tseconds\tsubtests\n")
            for o in outcomes:
                subtests = ",".join(f"{name}={result}" for name, result in sorted(o.subtests.items()))
                fields = (o.job.group, o.job.name, o.job.mode, o.result, f"{o.seconds:.2f}", subtests)
                table.write("\t".join(fields) + "\n")
    sys.exit(1 if counts["missing"] else 0)


if __name__ == "__main__":
    main()
