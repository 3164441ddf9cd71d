# SPDX-License-Identifier: MIT
"""Is a file a timeline as Perfetto and chrome://tracing want it, and does it say what the report says?

usage: timeline_trace.py TIMELINE.json [--report REPORT.json]

The form is the Trace Event format's (docs.google.com/document/d/1CvAClvFfyA5R-PhYUmn5OOQtYMH4h6I0nSsKchNAySU);
what its frames and lanes have to add up to is timeline_file.h's. Exit status 0, or 1 and a sentence.
"""
import argparse
import bisect
import json
import sys
from collections import defaultdict
from decimal import Decimal

METADATA = {
    "process_name": ("name", str), "process_labels": ("labels", str), "process_sort_index": ("sort_index", int),
    "thread_name": ("name", str), "thread_sort_index": ("sort_index", int),
}  # fmt: skip
PHASES = frozenset("XMCibestf")
FLOW, ASYNC = frozenset("stf"), frozenset("be")
# What chrome://tracing knows of those that the timeline uses; an unknown one stops it.
COLOURS = {"terrible", "bad", "thread_state_iowait", "yellow", "olive"}
# A frame's sums, what the report calls them, and the slices that make them up.
SUMS = {
    "stall_ms": ("device_stall_ms", "CPU", {"stall"}),
    "back_pressure_ms": ("back_pressure_ms", "CPU", {"back-pressure"}),
    "drain_ms": ("drain_ms", "CPU", {"drain"}),
    "starvation_ms": ("starvation_ms", "GPU", {"starvation", "condition"}),
}  # fmt: skip
PS_PER_MS = 10**9


class Fault(Exception):
    """A sentence."""


def load(path):
    """A JSON file with its decimals as they are written."""
    try:
        with open(path, encoding="utf-8") as stream:
            return json.load(stream, parse_float=Decimal)
    except (OSError, ValueError) as error:
        raise Fault(f"{path} cannot be read: {error}") from None


def is_number(value):
    return isinstance(value, (int, Decimal)) and not isinstance(value, bool)


def check(condition, event, complaint):
    if not condition:
        raise Fault(f"{complaint}: {json.dumps(event, default=str)[:300]}")


def check_event(event):
    """What the format demands of one event by itself."""
    check(isinstance(event, dict), event, "an event is no object")
    phase = event.get("ph")
    check(isinstance(phase, str) and phase in PHASES, event, "an event's ph is unknown")
    check(isinstance(event.get("name"), str) and event["name"], event, "an event has no name")
    for key in ("pid", "tid"):
        check(isinstance(event.get(key), int), event, f"an event's {key} is no whole number")
    arguments = event.get("args", {})
    check(isinstance(arguments, dict), event, "an event's args are no object")
    if phase == "M":
        check(event["name"] in METADATA, event, "metadata of this name are unknown")
        key, kind = METADATA[event["name"]]
        check(isinstance(arguments.get(key), kind), event, f"metadata lack their {key}")
        return
    check(is_number(event.get("ts")) and event["ts"] >= 0, event, "an event's ts is no time")
    check(isinstance(event.get("cat"), str) and event["cat"], event, "an event has no cat")
    check(event.get("cname", "bad") in COLOURS, event, "an event's cname is not known to viewers")
    if phase == "X":
        check(is_number(event.get("dur")) and event["dur"] >= 0, event, "a slice's dur is no time")
    elif phase == "C":
        check(arguments and all(map(is_number, arguments.values())), event, "a counter counts nothing")
    elif phase == "i":
        check(event.get("s") in ("g", "p", "t"), event, "an instant event's scope is unknown")
    else:
        # Viewers read a flow's id as hexadecimal.
        is_hexadecimal = isinstance(event.get("id"), str) and not set(event["id"]) - set("0123456789abcdef")
        check(is_hexadecimal and event["id"], event, "an event's id is not hexadecimal")
        check(event.get("bp", "e") == "e", event, "a flow's bp is unknown")


def nanoseconds(time_us):
    """Viewers keep no more; the file is to hold no more."""
    time_ns = time_us * 1000
    if time_ns != int(time_ns):
        raise Fault(f"{time_us} us is no whole number of nanoseconds, so viewers would round it")
    return int(time_ns)


class Slice:
    def __init__(self, event):
        self.event, self.name, self.arguments = event, event["name"], event.get("args", {})
        self.begin = nanoseconds(event["ts"])
        self.end = self.begin + nanoseconds(event["dur"])

    @property
    def ps(self):
        ps = self.arguments.get("ps")
        check(isinstance(ps, int), self.event, "a slice's length in picoseconds is missing")
        # Both ends are rounded down, so that the exact length is less than 1 ns off.
        off = abs(ps - 1000 * (self.end - self.begin))
        check(off < 1000, self.event, "a slice's dur and ps differ")
        return ps


def threads_of(events):
    """(pid, tid) -> its slices in order of time."""
    threads = defaultdict(list)
    for event in events:
        if event["ph"] == "X":
            threads[event["pid"], event["tid"]].append(Slice(event))
    for slices in threads.values():
        slices.sort(key=lambda each: (each.begin, -each.end))
    return threads


def check_nesting(threads):
    for slices in threads.values():
        open_ends = []
        for each in slices:
            while open_ends and open_ends[-1] <= each.begin:
                open_ends.pop()
            check(not open_ends or each.end <= open_ends[-1], each.event, "a slice overlaps another's end")
            open_ends.append(each.end)


def check_names(events, threads):
    named = {
        (e["name"], e["pid"], e["tid"] if e["name"] == "thread_name" else 0) for e in events if e["ph"] == "M"
    }
    for pid, tid in threads:
        if ("process_name", pid, 0) not in named or ("thread_name", pid, tid) not in named:
            raise Fault(f"the lane {tid} of process {pid} has no name")


def check_flows(events, threads):
    flows = defaultdict(list)
    for event in events:
        if event["ph"] in FLOW:
            flows[event["cat"], event["name"], event["id"]].append(event)
    for flow in flows.values():
        phases = "".join(event["ph"] for event in flow)
        check(phases[0] == "s" and phases.count("s") == 1, flow[0], "a flow does not begin once, at first")
        check("f" not in phases[:-1], flow[0], "a flow goes on after its end")
        times = [nanoseconds(event["ts"]) for event in flow]
        check(times == sorted(times), flow[0], "a flow goes back in time")
    begins = {thread: [each.begin for each in slices] for thread, slices in threads.items()}
    for event in (event for flow in flows.values() for event in flow):
        # An end without "bp" is tied to the slice that comes next, if one does.
        if event["ph"] == "f" and "bp" not in event:
            continue
        thread = event["pid"], event["tid"]
        is_tied = is_covered(threads[thread], begins.get(thread, ()), nanoseconds(event["ts"]))
        check(is_tied, event, "a flow's event is in no slice, so viewers cannot tie it to one")


def is_covered(slices, begins, time_ns):
    last = bisect.bisect_right(begins, time_ns) - 1
    # Of several that begin together, one of no length may come last.
    while last >= 0:
        if time_ns < slices[last].end or slices[last].begin == time_ns:
            return True
        if slices[last].begin < slices[last].end:
            return False
        last -= 1
    return False


def check_pairs(events):
    begun = {}
    for event in events:
        if event["ph"] not in ASYNC:
            continue
        key = event["cat"], event["pid"], event["id"]
        if event["ph"] == "b":
            check(key not in begun, event, "an id is used again before its end")
            begun[key] = event
        else:
            check(key in begun, event, "an end comes without its beginning")
            begin = begun.pop(key)
            check(
                begin["ts"] <= event["ts"] and begin["name"] == event["name"],
                event,
                "an end fits not its beginning",
            )
    for event in begun.values():
        raise Fault(f"a beginning has no end: {json.dumps(event, default=str)}")


def lanes_of(events, threads):
    """(pid, context) -> {"CPU": slices, ...}."""
    lanes = defaultdict(dict)
    for event in events:
        if event["ph"] == "M" and event["name"] == "thread_name":
            context, _, lane = event["args"]["name"].partition(": ")
            lanes[event["pid"], context.removeprefix("context ")][lane] = threads.get(
                (event["pid"], event["tid"]), []
            )
    return lanes


def within(slices, frame):
    return [s for s in slices if frame.begin <= s.begin < frame.end]


def check_frame(frame, lanes):
    """The CPU's slices fill the frame, and slices add up to its sums. A frame's sums in picoseconds."""
    cpu, gpu = within(lanes["CPU"], frame), within(lanes.get("GPU", []), frame)
    at = frame.begin
    for each in cpu:
        check(each.begin == at, each.event, "the CPU did nothing before this, for no time is lost")
        at = each.end
    check(at == frame.end, frame.event, "the CPU's slices do not fill the frame")
    check(sum(s.ps for s in cpu) == frame.ps, frame.event, "the CPU's slices are not as long as the frame")
    sums = {}
    if not frame.arguments.get("is_whole"):
        return sums
    of_lane = {"CPU": cpu, "GPU": gpu}
    for name, (_, lane, slices) in SUMS.items():
        sums[name] = sum(s.ps for s in of_lane[lane] if s.name in slices)
    sums["gpu_busy_ms"] = sum(s.ps for s in gpu if s.name not in SUMS["starvation_ms"][2])
    for name, sum_ps in sums.items():
        told = frame.arguments.get(name)
        check(
            is_number(told) and told * PS_PER_MS == sum_ps,
            frame.event,
            f"slices of {sum_ps} ps are not {name}",
        )
    return sums


def check_frames(events, threads):
    """(pid, context, frame) -> its sums, and its length, in picoseconds, of those that are whole."""
    whole = {}
    for (pid, context), lanes in lanes_of(events, threads).items():
        for frame in lanes.get("frames", []):
            sums = check_frame(frame, lanes)
            if sums:
                whole[pid, int(context), frame.arguments["frame"]] = {**sums, "frame_ms": frame.ps}
    return whole


def check_report(frames, report):
    names = {"frame_ms": "device_ms", "gpu_busy_ms": "gpu_busy_ms"} | {
        name: told for name, (told, _, _) in SUMS.items()
    }
    told = {
        (r["pid"], r["context"], r["frame"]): r for r in report.get("records", []) if r.get("kind") == "frame"
    }
    last = {}
    for pid, context, frame in told:
        last[pid, context] = max(frame, last.get((pid, context), 0))
    compared = 0
    for (pid, context, frame), sums in frames.items():
        record = told.get((pid, context, frame))
        # A program that was killed may have lost the end of either file.
        if record is None and frame > last.get((pid, context), -1):
            continue
        if record is None:
            raise Fault(f"the report holds no frame {frame}, but later ones")
        for name, its_name in names.items():
            value = record.get(its_name)
            if value is None or value * PS_PER_MS != sums[name]:
                raise Fault(
                    f"frame {frame}: the report's {its_name} is {value}, the timeline's {sums[name]} ps"
                )
        compared += 1
    if frames and compared == 0:
        raise Fault("the report holds none of the timeline's frames")


def check_timeline(trace, report=None):
    """Of a file's JSON, by load(); and of the report of the same run. Raises Fault. The number of whole frames."""
    if not isinstance(trace, dict) or not isinstance(trace.get("traceEvents"), list):
        raise Fault("it is no object with traceEvents")
    if trace.get("displayTimeUnit", "ms") not in ("ms", "ns"):
        raise Fault("its displayTimeUnit is neither ms nor ns")
    events = trace["traceEvents"]
    for event in events:
        check_event(event)
    threads = threads_of(events)
    check_names(events, threads)
    check_nesting(threads)
    check_flows(events, threads)
    check_pairs(events)
    frames = check_frames(events, threads)
    if report is not None:
        check_report(frames, report)
    return len(frames)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("timeline")
    parser.add_argument("--report")
    options = parser.parse_args()
    try:
        report = load(options.report) if options.report else None
        frames = check_timeline(load(options.timeline), report)
    except Fault as fault:
        print(f"{options.timeline}: {fault}")
        return 1
    print(
        f"{options.timeline}: a timeline with {frames} whole frames{', as the report says' if report else ''}"
    )
    return 0


if __name__ == "__main__":
    sys.exit(main())
