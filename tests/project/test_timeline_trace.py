# SPDX-License-Identifier: MIT
"""timeline_trace.py takes the timelines that the layer writes, and refuses each way of spoiling one.

usage: test_timeline_trace.py FIGURE_ONE_TRACES
"""
import copy
import json
import subprocess
import sys
import tempfile
import unittest
from decimal import Decimal
from pathlib import Path

from timeline_trace import Fault, check_timeline, load

WRITER = sys.argv.pop(1)
CHECK = Path(__file__).parent / "timeline_trace.py"


class Timelines(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.path = Path(folder.name) / "stop_and_wait.json"
        better = Path(folder.name) / "better_order.json"
        subprocess.run([WRITER, cls.path, better], check=True)
        cls.good, cls.better = load(cls.path), load(better)
        frame = next(e for e in cls.good["traceEvents"] if e["name"] == "frame 0")
        told, pid = frame["args"], frame["pid"]
        cls.report = {"glext_emu_report": 1, "records": [
            {"kind": "context", "pid": pid, "context": 1},
            {"kind": "frame", "pid": pid, "context": 1, "frame": 0, "device_ms": Decimal(told["ps"]) / 10**9,
             "gpu_busy_ms": told["gpu_busy_ms"], "device_stall_ms": told["stall_ms"],
             "back_pressure_ms": told["back_pressure_ms"], "starvation_ms": told["starvation_ms"],
             "drain_ms": told["drain_ms"]},
        ]}  # fmt: skip

    def test_what_the_layer_writes_is_taken(self):
        for trace in (self.good, self.better):
            self.assertEqual(check_timeline(trace), 1)
        self.assertEqual(check_timeline(self.good, self.report), 1)

    def test_the_command_says_so_and_its_status_too(self):
        done = subprocess.run([sys.executable, CHECK, self.path], capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("1 whole frames", done.stdout)
        broken = self.path.with_name("broken.json")
        broken.write_text(self.path.read_text()[:-40])
        done = subprocess.run([sys.executable, CHECK, broken], capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (1, ""))
        self.assertIn("cannot be read", done.stdout)

    def refuses(self, complaint, spoil, report=None):
        trace = copy.deepcopy(self.good)
        spoil(trace["traceEvents"])
        with self.assertRaises(Fault) as caught:
            check_timeline(trace, report)
        self.assertIn(complaint, str(caught.exception))

    def of(self, events, phase, number=0, name=None):
        return [e for e in events if e["ph"] == phase and name in (None, e["name"])][number]

    def test_it_refuses_what_is_no_trace(self):
        for trace in ([], {}, {"traceEvents": {}}):
            self.assertRaises(Fault, check_timeline, trace)
        self.assertRaises(Fault, check_timeline, {"traceEvents": [], "displayTimeUnit": "us"})

    def test_it_refuses_events_that_lack_what_their_kind_needs(self):
        for phase, key, complaint in (
            ("X", "ph", "ph is unknown"), ("X", "name", "no name"), ("X", "pid", "pid"), ("X", "tid", "tid"),
            ("X", "ts", "ts is no time"), ("X", "dur", "dur is no time"), ("X", "cat", "no cat"),
            ("C", "args", "counts nothing"), ("i", "s", "scope"), ("s", "id", "not hexadecimal"),
            ("M", "args", "metadata lack"),
        ):  # fmt: skip
            with self.subTest(phase=phase, key=key):
                self.refuses(complaint, lambda events: self.of(events, phase).pop(key))

    def test_it_refuses_values_that_viewers_stumble_over(self):
        for phase, key, value, complaint in (
            ("X", "ph", "Z", "ph is unknown"), ("X", "dur", -1, "dur is no time"), ("X", "ts", "7", "ts is no time"),
            ("X", "ts", Decimal("0.0001"), "nanoseconds"), ("X", "cname", "crimson", "cname"),
            ("s", "id", "query-1", "not hexadecimal"), ("f", "bp", "s", "bp"), ("i", "s", "x", "scope"),
        ):  # fmt: skip
            with self.subTest(phase=phase, key=key, value=value):
                self.refuses(complaint, lambda events: self.of(events, phase).update({key: value}))

    def test_it_refuses_slices_that_overlap(self):
        def lengthen(events):
            self.of(events, "X", 2, "stall")["dur"] += Decimal("0.001")

        self.refuses("overlaps", lengthen)

    def test_it_refuses_a_gap_on_the_cpu(self):
        self.refuses("no time is lost", lambda events: events.remove(self.of(events, "X", 0, "program")))

    def test_it_refuses_a_frame_that_is_longer_than_its_slices(self):
        def lengthen(events):
            frame = self.of(events, "X", 0, "frame 0")
            frame["dur"] += 1
            frame["args"]["ps"] += 10**6

        self.refuses("do not fill the frame", lengthen)

    def test_it_refuses_sums_that_are_not_those_of_the_slices(self):
        for name in ("gpu_busy_ms", "stall_ms", "back_pressure_ms", "starvation_ms", "drain_ms"):
            with self.subTest(name=name):
                self.refuses(f"are not {name}", lambda events: self.of(events, "X", 0, "frame 0")["args"].update(
                    {name: self.of(events, "X", 0, "frame 0")["args"][name] + Decimal("0.000000001")}))  # fmt: skip

    def test_it_refuses_lengths_that_differ(self):
        self.refuses(
            "dur and ps differ", lambda events: self.of(events, "X", 0, "stall")["args"].update(ps=17)
        )

    def test_it_refuses_flows_that_do_not_run_from_begin_to_end(self):
        self.refuses("does not begin once", lambda events: events.remove(self.of(events, "s")))
        self.refuses("does not begin once", lambda events: events.append(dict(self.of(events, "s"))))
        self.refuses("after its end", lambda events: events.append(dict(self.of(events, "f"))))
        self.refuses(
            "back in time", lambda events: self.of(events, "t").update(ts=self.of(events, "f")["ts"] + 50)
        )
        self.refuses("in no slice", lambda events: self.of(events, "f", -1).update(ts=10**6))

    def test_it_refuses_waits_in_the_fifo_without_begin_or_end(self):
        trace = copy.deepcopy(self.better)
        self.assertTrue([e for e in trace["traceEvents"] if e["ph"] == "b"], "nothing waited in the FIFO")
        for phase, complaint in (("b", "without its beginning"), ("e", "has no end")):
            spoilt = copy.deepcopy(trace)
            spoilt["traceEvents"].remove(self.of(spoilt["traceEvents"], phase))
            with self.assertRaises(Fault) as caught:
                check_timeline(spoilt)
            self.assertIn(complaint, str(caught.exception))

    def test_it_refuses_lanes_without_names(self):
        self.refuses("has no name", lambda events: events.remove(self.of(events, "M", 0, "process_name")))
        self.refuses("has no name", lambda events: events.remove(self.of(events, "M", -1, "thread_name")))

    def test_it_refuses_a_report_that_says_otherwise(self):
        for name in (
            "device_ms",
            "device_stall_ms",
            "back_pressure_ms",
            "starvation_ms",
            "drain_ms",
            "gpu_busy_ms",
        ):
            report = copy.deepcopy(self.report)
            report["records"][1][name] += Decimal("0.000000001")
            with self.subTest(name=name), self.assertRaises(Fault) as caught:
                check_timeline(self.good, report)
            self.assertIn(name, str(caught.exception))
        with self.assertRaises(Fault) as caught:
            check_timeline(self.good, {"records": []})
        self.assertIn("none of the timeline's frames", str(caught.exception))
        later = copy.deepcopy(self.report)
        later["records"][1]["frame"] = 1
        with self.assertRaises(Fault) as caught:
            check_timeline(self.good, later)
        self.assertIn("no frame 0, but later ones", str(caught.exception))

    def test_a_file_without_frames_is_a_timeline(self):
        self.assertEqual(check_timeline(json.loads('{"traceEvents":[\n],"displayTimeUnit":"ms"}')), 0)


if __name__ == "__main__":
    unittest.main()
