#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Judges the OpenGL of this machine by the texts of its occlusion-query extensions.

Needs the programs that lie beside it (conformance_*) and the list of what they prove (conformance.tsv), and
nothing else of the project: copy the three anywhere. Preloaded layers are judged with the GL beneath.
"""
import argparse
import csv
import json
import os
import signal
import subprocess
import sys
import tempfile
from fnmatch import fnmatchcase
from pathlib import Path

HERE = Path(__file__).resolve().parent
VENDORS = {"arb", "emu", "ext", "hp", "khr", "nv", "nvx", "sgix"}
GOOD, BAD, BAD_USE, SKIPPED = 0, 1, 2, 77

EPILOG = """\
Each extension has a program of its own; a line tells what became of its tests, and the lines below it say
what failed, with the statement of the text that it breaks. Tests of what this GL does not have are skipped.

  conformance --list                                      what is judged, and by which test
  conformance --extension GL_ARB_occlusion_query          one extension
  conformance --platform glx --filter 'Names.*'           the tests with such names, on a display
  LD_PRELOAD=liblayer.so conformance                      a layer, and the GL beneath it

exit status: 0 all that ran passed; 1 something failed; 2 bad use; 77 every test was skipped
"""


def extension_of(folder):
    """The name in the extension string; a folder that spans several extensions keeps its own."""
    vendor, _, rest = folder.partition("_")
    return f"GL_{vendor.upper()}_{rest}" if vendor in VENDORS else folder


def parse(arguments):
    parser = argparse.ArgumentParser(
        prog="conformance", description=__doc__, epilog=EPILOG, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("--platform", choices=("egl", "glx", "osmesa"), default="egl",
                        help="where contexts come from: EGL without a display (default),\n"
                             "GLX on $DISPLAY, or Mesa's off-screen library OSMesa")  # fmt: skip
    parser.add_argument("--extension", action="append", default=[], metavar="NAME",
                        help="judge this extension only; may be given several times")  # fmt: skip
    parser.add_argument("--filter", default="*", metavar="GLOB", help="run the tests of matching names only")
    parser.add_argument("--list", action="store_true",
                        help="print extension, statements and test, a line each, and run nothing")  # fmt: skip
    return parser, parser.parse_args(arguments)


def read_list():
    with open(HERE / "conformance.tsv", encoding="utf-8", newline="") as lines:
        return list(csv.DictReader(lines, delimiter="\t", quoting=csv.QUOTE_NONE))


def run(program, platform, pattern, tell):
    """Runs one program: its tests by outcome, and a sentence where it ended badly."""
    with tempfile.TemporaryDirectory() as folder:
        results = Path(folder) / "results.json"
        command = [program, "--platform", platform]
        command += [f"--gtest_filter={pattern}", f"--gtest_output=json:{results}"]
        lines, running = [], "its start"
        pipe = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT}
        with subprocess.Popen(command, **pipe, text=True) as process:
            for line in process.stdout:
                lines.append(line.strip())
                if line.startswith("[ RUN"):
                    running = line[12:].strip()
                    tell(running)
        outcomes = {"passed": [], "failed": [], "skipped": []}
        if results.exists():
            for suite in json.loads(results.read_text(encoding="utf-8"))["testsuites"]:
                for test in suite["testsuite"]:
                    add(outcomes, f"{suite['name']}.{test['name']}", test)
        fault = ""
        if process.returncode < 0:
            fault = f"ended by {signal.Signals(-process.returncode).name} in {running}"
        elif process.returncode not in (GOOD, SKIPPED) and not outcomes["failed"]:
            fault = lines[-1] if lines else f"ended with status {process.returncode}"
        return outcomes, fault, lines


def add(outcomes, name, test):
    if test.get("failures"):
        outcomes["failed"].append((name, test["failures"][0]["failure"]))
    elif test["result"] == "SKIPPED":
        outcomes["skipped"].append((name, test.get("skipped", "")))
    elif test["result"] == "COMPLETED":
        outcomes["passed"].append((name, ""))


def statements_of(listed, folder, name):
    rows = [row for row in listed if row["folder"] == folder and proves(row["test"], name)]
    return ", ".join(dict.fromkeys(row["statements"] for row in rows))


def proves(planned, name):
    """A planned name stands for all values of a parameterised test."""
    return planned == name or name.startswith(planned + "/") or fnmatchcase(name, planned)


def progress(text):
    """One line that moves, on a terminal only."""
    if sys.stdout.isatty():
        width = os.get_terminal_size().columns
        print("\r\x1b[K" + text[: width - 1], end="", flush=True)


def sentence(counts):
    return ", ".join(f"{count} {outcome}" for outcome, count in counts.items())


def judge(folders, options, listed):
    total = {"passed": 0, "failed": 0, "skipped": 0}
    faults = 0
    for number, folder in enumerate(folders, 1):
        name = extension_of(folder)
        outcomes, fault, lines = run(
            HERE / f"conformance_{folder}", options.platform, options.filter,
            lambda test, head=f"[{number}/{len(folders)}] {name}  ": progress(head + test),
        )  # fmt: skip
        progress("")
        counts = {outcome: len(tests) for outcome, tests in outcomes.items()}
        if not any(counts.values()) and not fault:
            if options.filter == "*":
                print(f"{name:<40} not run: {lines[-1] if lines else 'no test'}")
            continue
        print(f"{name:<40} {sentence(counts)}", flush=True)
        for test, failure in outcomes["failed"]:
            print(f"  failed: {test} [{statements_of(listed, folder, test)}]")
            print("".join(f"    {line}\n" for line in failure.splitlines()), end="")
        if fault:
            print(f"  failed: {fault}")
        faults += bool(fault)
        for outcome in total:
            total[outcome] += counts[outcome]
    print(sentence(total))
    if total["failed"] or faults:
        return BAD
    return GOOD if total["passed"] else SKIPPED


def main(arguments):
    parser, options = parse(arguments)
    listed = read_list()
    folders = sorted(path.name.removeprefix("conformance_") for path in HERE.glob("conformance_*"))
    if not folders:
        parser.error(f"no programs conformance_* in {HERE}")
    if options.extension:
        known = {extension_of(folder).lower(): folder for folder in folders}
        known.update({folder: folder for folder in folders})
        for word in options.extension:
            if word.lower() not in known:
                parser.error(f"{word} is none of {', '.join(extension_of(folder) for folder in folders)}")
        folders = sorted({known[word.lower()] for word in options.extension})
    if options.list:
        for row in listed:
            if row["folder"] in folders and fnmatchcase(row["test"], options.filter):
                print(extension_of(row["folder"]), row["statements"], row["test"], sep="\t")
        return GOOD
    return judge(folders, options, listed)


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except KeyboardInterrupt:
        sys.exit(130)
    except OSError as error:
        print(f"conformance: {error}", file=sys.stderr)
        sys.exit(BAD_USE)
