# SPDX-License-Identifier: MIT
"""The evaluation's command line; ./evaluate calls it after the build and documents its options."""
import argparse
import os
import shlex
import sys
from html import unescape
from pathlib import Path

from .machine import describe
from .matrix import build_device_matrix, build_matrix
from .progress import Progress
from .runs import Settings, measure, measure_device_time

ROOT = Path(__file__).resolve().parents[2]
QUICK = {"frames": 8, "scale": 0.15, "latencies": [0, 50], "rounds": 1}
FULL = {"frames": 40, "scale": 1.0, "latencies": [0, 50, 200], "rounds": 2}
SIZE = "640x480"
PAPERS = ("log", "chc", "growth", "all")
PAPER_TITLES = {"log": "The Lazy Occlusion Grid beside its paper", "chc": "Coherent Hierarchical Culling beside its paper",
                "growth": "What hidden triangles cost", "all": "Two papers on occlusion culling, and what grows"}
# Where on the path the pictures are drawn: above the roofs, along a street.
PICTURE_AT = 0.55
# Mesa's llvmpipe starts at most 16 threads. With none, a query has no thread to wake: small ones cost less.
MOST_THREADS = 16
THREADS = 0


def positive_integer(text):
    value = int(text)
    if value < 1:
        raise argparse.ArgumentTypeError(f"{text} is not at least 1")
    return value


def share(text):
    value = float(text)
    if not 0 < value <= 1:
        raise argparse.ArgumentTypeError(f"{text} is not above 0 and at most 1")
    return value


def latency_list(text):
    """Ascending and without repetition; 0 is the driver's own time."""
    values = sorted({float(part) for part in text.split(",")})
    if values[0] < 0:
        raise argparse.ArgumentTypeError(f"{text} holds a negative latency")
    return values


def thread_count(text):
    value = int(text)
    if not 0 <= value <= MOST_THREADS:
        raise argparse.ArgumentTypeError(f"{text} is not between 0 and {MOST_THREADS}")
    return value


def parse_options(arguments):
    parser = argparse.ArgumentParser(prog="./evaluate", allow_abbrev=False, add_help=False)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--frames", type=positive_integer)
    parser.add_argument("--scale", type=share)
    parser.add_argument("--latencies", type=latency_list, metavar="A,B,..")
    parser.add_argument("--rounds", type=positive_integer)
    parser.add_argument("--out", type=Path)
    parser.add_argument("--paper", choices=PAPERS)
    parser.add_argument("--no-papers", action="store_true")
    parser.add_argument("--threads", type=thread_count, default=THREADS)
    parser.add_argument("--programs", type=Path, default=ROOT / "build/release/bin", help=argparse.SUPPRESS)
    parser.add_argument("--here", type=Path, default=Path.cwd(), help=argparse.SUPPRESS)
    parser.add_argument("--only-check-options", action="store_true", help=argparse.SUPPRESS)
    options = parser.parse_args(arguments)
    if options.paper and options.quick:
        parser.error("--paper takes the paper's own scenes and walks: --quick does not go with it")
    for name, value in (QUICK if options.quick else FULL).items():
        if options.paper and getattr(options, name) is not None:
            parser.error(f"--paper takes the paper's own scenes and walks: --{name} does not go with it")
        if getattr(options, name) is None:
            setattr(options, name, value)
    options.out = options.here / options.out if options.out else ROOT / "report"
    return options


def environment_of(options):
    """Software drivers, a pinned number of threads, and no layer but the one that the launcher adds."""
    environment = {k: v for k, v in os.environ.items() if k not in ("GLEXT_EMU", "LD_PRELOAD")}
    environment["LP_NUM_THREADS"] = str(options.threads)
    environment["LIBGL_ALWAYS_SOFTWARE"] = "1"
    return environment


def command_line(options):
    """The command that repeats this run, whatever the defaults become."""
    words = ["./evaluate", "--frames", str(options.frames), "--scale", f"{options.scale:g}"]
    words += ["--latencies", ",".join(f"{latency:g}" for latency in options.latencies)]
    words += ["--rounds", str(options.rounds), "--threads", str(options.threads)]
    words += ["--no-papers"] if options.no_papers else []
    return shlex.join(words)


def main(arguments):
    options = parse_options(arguments)
    if options.only_check_options:
        return 0

    # matplotlib is needed only from here on: options are checked on machines that lack it yet.
    from .checks import run_checks
    from .device_time import DeviceRow, build_device_rows, run_device_checks
    from .page import write_page
    from .rows import build_rows, write_csv

    load_before = os.getloadavg()[0]
    options.out.mkdir(parents=True, exist_ok=True)
    if options.paper:
        return evaluate_papers(options, load_before)
    settings = Settings(
        programs=options.programs, out=options.out.resolve(), frames=options.frames, scale=options.scale,
        rounds=options.rounds, size=SIZE, environment=environment_of(options),
    )  # fmt: skip
    matrix, device_matrix = build_matrix(options.latencies), build_device_matrix()
    image_frame = int(PICTURE_AT * options.frames)
    progress = Progress(matrix, options.rounds, device_matrix)
    measured, failures = measure(matrix, settings, image_frame, progress)
    device_measured, more_failures = measure_device_time(device_matrix, settings, image_frame, progress)
    failures += more_failures
    progress.close()
    sections = []
    if not options.quick and not options.no_papers:
        sections, more_failures = paper_sections(options, ("log", "chc", "growth"), is_full=False)
        failures += more_failures

    rows = build_rows(measured)
    device_rows = build_device_rows(device_measured)
    checks = run_checks(measured) + run_device_checks(device_measured, measured)
    checks += [check for section in sections for check in section.checks]
    write_csv(rows, settings.out / "table.csv")
    write_csv(device_rows, settings.out / "device_time.csv", DeviceRow)
    summary = next((value.judged.summary for value in measured.values() if value.judged), {})
    write_page(
        settings.out / "index.html", measured=measured, rows=rows, device_rows=device_rows,
        checks=checks, failures=failures,
        machine=describe(ROOT, options.threads, summary, SIZE, load_before), settings=settings,
        image_frame=image_frame, scene_triangles=summary.get("scene_triangles", 0),
        quick=options.quick, command=command_line(options), sections=sections,
    )  # fmt: skip
    return report(rows, device_rows, checks, failures, settings.out / "index.html")


def paper_sections(options, names, is_full):
    """The papers' experiments: a section each, and the failures as sentences."""
    from .jobs import Jobs
    from .papers import chc, growth, log
    from .papers.common import FULL as ALL
    from .papers.common import SMALL
    from .papers.page import write_rows

    extent = ALL if is_full else SMALL
    modules = {"log": log, "chc": chc, "growth": growth}
    jobs = Jobs(options.programs, options.out / "jobs", environment_of(options), os.cpu_count())
    wanted = [job for name in names for job in modules[name].jobs(extent)]
    results, failures = jobs.run(wanted)
    sections = [modules[name].section(results, extent) for name in names]
    for name, section in zip(names, sections):
        write_rows(options.out / f"{name}.csv", section.rows)
    return sections, failures


def evaluate_papers(options, load_before):
    """--paper: the paper's tables at the paper's scale; a run that was broken off goes on where it was."""
    from .papers.page import write_paper_page

    names = ("log", "chc", "growth") if options.paper == "all" else (options.paper,)
    sections, failures = paper_sections(options, names, is_full=True)
    page = options.out / f"{options.paper}.html"
    write_paper_page(
        page, PAPER_TITLES[options.paper], sections, failures,
        describe(ROOT, options.threads, {}, "as the tables say", load_before),
        f"./evaluate --paper {options.paper}", [f"{name}.csv" for name in names],
    )  # fmt: skip
    goals = [goal for section in sections for goal in section.goals]
    checks = [check for section in sections for check in section.checks]
    for goal in goals:
        print(f"{'reached ' if goal.is_met else 'NOT MET '} {goal.sentence}: {unescape(goal.measured)} (wanted {unescape(goal.wanted)})")
    broken = [check for check in checks if not check.holds]
    for check in broken:
        print(f"DOES NOT HOLD: {check.sentence}: {'; '.join(check.faults[:3]) or 'nothing was looked at'}")
    print(f"{len(checks) - len(broken)} of {len(checks)} checks hold, {sum(goal.is_met for goal in goals)} of {len(goals)} "
          f"goals are reached; the report: {page}")  # fmt: skip
    return 1 if broken or failures else 0


def report(rows, device_rows, checks, failures, page):
    """The end on the terminal: the tables in short, what failed, where the page lies."""
    print(f"{'device':16} {'culler':14} {'late, us':>8} {'queries':>8} {'triangles':>10} {'frame ms':>9} "
          f"{'waiting':>8} {'speed-up':>8}")  # fmt: skip
    for row in rows:
        late = "-" if row.latency_us is None else f"{row.latency_us:g}"
        wait = "-" if row.stall_ms is None else f"{row.stall_ms:.1f}"
        faster = "-" if row.speedup_of_means is None else f"{row.speedup_of_means:.2f}"
        print(f"{row.device:16} {row.culler:14} {late:>8} {row.queries:8.0f} {row.drawn_triangles:10.0f} "
              f"{row.frame_ms:9.1f} {wait:>8} {faster:>8}{'  the same again' if row.repeat else ''}")  # fmt: skip
    for row in device_rows:
        faster = "-" if row.speedup_of_means is None else f"{row.speedup_of_means:.2f}"
        print(f"{row.device:16} {row.culler:14} {'its own':>8} {row.queries:8.0f} {row.drawn_triangles:10.0f} "
              f"{row.device_ms:9.2f} {row.stall_ms:8.2f} {faster:>8}")  # fmt: skip
    broken = [check for check in checks if not check.holds]
    for check in broken:
        print(f"DOES NOT HOLD: {check.sentence}: {'; '.join(check.faults[:3])}")
    for failure in failures:
        print(f"FAILED: {failure}")
    print(f"{len(rows)} rows, {len(checks) - len(broken)} of {len(checks)} checks hold; the report: {page}")
    return 1 if broken or failures or not rows else 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except KeyboardInterrupt:
        sys.exit("\ninterrupted: no report was written")
