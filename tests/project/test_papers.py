# SPDX-License-Identifier: MIT
"""The papers' experiments: what is kept of a walk and what is not, and what is said of made-up results."""
import json
import sys
import tempfile
import unittest
from pathlib import Path

from tree import ROOT

sys.path.insert(0, str(ROOT / "apps"))

from evaluation.jobs import Job, Jobs, Result  # noqa: E402
from evaluation.papers import chc, growth, log  # noqa: E402
from evaluation.papers.common import FULL, SMALL, nothing_visible_is_culled, speedups  # noqa: E402
from evaluation.papers.page import html_of, write_rows  # noqa: E402

# In place of the launcher: writes what a walk of two frames writes, and counts how often it was called. The client's
# frames end with swaps 1 and 4, so the layer's records of those must be found.
LAUNCHER = """#!/bin/sh
echo called >> {calls}
{trouble}
while [ $# -gt 0 ]; do
    case $1 in --report) layer=$2 ;; --json) client=$2 ;; esac
    shift
done
cat > "$client" <<'TEXT'
{{"frame": 7, "swap": 1, "device_ms": 2.5, "false_culls": 0}}
{{"frame": 9, "swap": 4, "device_ms": 3.5, "false_culls": 0}}
{{"summary": {{"scene_triangles": 10}}}}
TEXT
printf '{{"records": [{{"kind": "query"}}' > "$layer"
for number in 0 1 2 3 4; do printf ', {{"kind": "frame", "frame": %s}}' $number >> "$layer"; done
echo ']}}' >> "$layer"
"""


class Kept(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.programs = self.folder / "bin"
        self.programs.mkdir()
        self.install("")
        (self.programs / "walkthrough").write_text("one build")
        self.job = Job("chc-city", "frustum", "geforce-fx-5950")

    def install(self, trouble):
        launcher = self.programs / "glext-emu"
        launcher.write_text(LAUNCHER.format(calls=self.folder / "calls", trouble=trouble))
        launcher.chmod(0o755)

    def run_job(self):
        with open(self.folder / "said", "a", encoding="utf-8") as stream:
            return Jobs(self.programs, self.folder / "jobs", {}, stream=stream).run([self.job])

    def calls(self):
        return len((self.folder / "calls").read_text().splitlines())

    def test_a_walk_that_is_done_is_not_walked_again(self):
        first, failures = self.run_job()
        again, _ = self.run_job()
        self.assertEqual((failures, self.calls()), ([], 1))
        self.assertEqual(first[self.job], again[self.job])

    def test_the_layers_records_are_those_of_the_clients_frames(self):
        results, _ = self.run_job()
        self.assertEqual([record["frame"] for record in results[self.job].layer_frames], [1, 4])

    def test_other_programs_walk_again(self):
        self.run_job()
        (self.programs / "walkthrough").write_text("another build")
        self.run_job()
        self.assertEqual(self.calls(), 2)

    def test_a_walk_that_died_leaves_nothing_and_is_said(self):
        self.install("echo no such luck >&2; exit 3")
        results, failures = self.run_job()
        self.assertEqual((results, len(failures)), ({}, 1))
        self.assertIn("exit status 3: no such luck", failures[0])
        self.install("")
        results, failures = self.run_job()
        self.assertEqual((list(results), failures), ([self.job], []))

    def test_half_a_result_is_no_result(self):
        self.run_job()
        kept = next((self.folder / "jobs").glob("*.json"))
        kept.write_text(kept.read_text()[:100])
        self.run_job()
        self.assertEqual(self.calls(), 2)

    def test_the_report_after_a_break_is_that_of_an_unbroken_run(self):
        results, _ = self.run_job()
        text = json.dumps(results[self.job].frames)
        self.install("exit 3")  # whatever is run now fails: all must come from what was kept
        again, failures = self.run_job()
        self.assertEqual((json.dumps(again[self.job].frames), failures), (text, []))


def result_of(times_ms, **values):
    frames = [
        {"frame": number, "device_ms": time, "frame_ms": time, "stall_ms": 0.0, "drawn_triangles": 100,
         "frustum_triangles": 1000, "queries": 0, "pixels_read": 0, "region_waits": 0, "false_culls": 0,
         "wrong_pixels": 0, **values}
        for number, time in enumerate(times_ms)
    ]  # fmt: skip
    layer = [{"device_stall_ms": 0.0} for _ in frames]
    return Result(frames, layer, {"scene_triangles": 10_000, "tree_nodes": 9}, 1.0)


class Said(unittest.TestCase):
    def test_speedups_are_told_both_ways(self):
        self.assertEqual(speedups([10, 30], [10, 10]), (2, 2))
        self.assertEqual(speedups([10, 30], [1, 30]), (5.5, 40 / 31))

    def test_a_false_cull_breaks_the_check_unless_it_was_asked_for(self):
        job = Job("chc-city", "chc", "mesa", judge_every=1)
        results = {job: result_of([1.0], false_culls=1)}
        self.assertFalse(nothing_visible_is_culled(results).holds)
        self.assertEqual(nothing_visible_is_culled(results, lambda one: True).count, 0)
        self.assertTrue(nothing_visible_is_culled({job: result_of([1.0])}).holds)

    def test_a_check_of_nothing_does_not_hold(self):
        self.assertFalse(nothing_visible_is_culled({}).holds)

    def log_results(self, **changes):
        results = {job: result_of([20.0, 20.0], pixels_read=1000) for job in log.jobs(SMALL)}
        for culler, drawn in changes.items():
            results[log.job(SMALL, "log-city", "640x480", culler)] = result_of([20.0, 20.0], drawn_triangles=drawn)
        return results

    def test_methods_on_one_traversal_that_draw_differently_are_convicted(self):
        self.assertTrue(log.all_draw_the_same(self.log_results(), SMALL).holds)
        self.assertFalse(log.all_draw_the_same(self.log_results(hzb=101), SMALL).holds)

    def test_an_order_of_times_is_reached_only_as_the_paper_has_it(self):
        times = {"log-state": 1, "bog": 3, "hzb": 5, "pq": 4, "frustum": 2}
        results = {
            log.job(FULL, "log-forest", "640x480", culler, judge=culler != "frustum"): result_of([time])
            for culler, time in times.items()
        }
        self.assertEqual([goal.is_met for goal in log.order_goals(results, FULL)], [True])
        results[log.job(FULL, "log-forest", "640x480", "pq")] = result_of([6])
        self.assertEqual([goal.is_met for goal in log.order_goals(results, FULL)], [False])

    def test_the_worst_window_lies_inside_a_section(self):
        base = result_of([10.0] * 40)
        ours = result_of([5.0] * 19 + [30.0, 30.0] + [5.0] * 19)
        for part in (base, ours):
            for number, frame in enumerate(part.frames):
                frame["frame"] = number if number < 20 else number + 100
        results = {chc.job(SMALL, "chc-city", "frustum"): base, chc.job(SMALL, "chc-city", "chc++"): ours}
        self.assertAlmostEqual(chc.worst_window(results, SMALL, "chc-city"), (19 * 5 + 30) / 200)

    def test_growth_is_largest_by_smallest(self):
        times = growth.TIMES["small"]
        results = {growth.job(SMALL, n, "pq"): result_of([2.0 * n]) for n in times}
        value = growth.grown(results, SMALL, "pq", lambda one: one.mean("device_ms"))
        self.assertEqual(value, times[-1] / times[0])

    def test_every_section_is_written_whatever_is_missing(self):
        with tempfile.TemporaryDirectory() as folder:
            for module in (log, chc, growth):
                jobs = module.jobs(SMALL)
                results = {
                    job: result_of([1.0, 2.0], **({} if job.clock == "device" else {"device_ms": None}))
                    for job in jobs
                }
                for some in (results, dict(list(results.items())[::2]), {}):
                    section = module.section(some, SMALL)
                    self.assertIn("<svg", html_of(section))
                    self.assertEqual(len(section.rows), len(some))
                    write_rows(Path(folder) / "rows.csv", section.rows)


if __name__ == "__main__":
    unittest.main()
