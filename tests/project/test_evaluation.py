# SPDX-License-Identifier: MIT
"""The evaluation's arithmetic and its checks, on small measurements whose answers are known by hand."""
import csv
import sys
import tempfile
import unittest
from pathlib import Path

from tree import ROOT

sys.path.insert(0, str(ROOT / "apps"))

from evaluation.checks import run_checks  # noqa: E402
from evaluation import device_rates  # noqa: E402
from evaluation.device_time import build_device_rows, run_device_checks  # noqa: E402
from evaluation.matrix import Configuration, build_device_matrix, build_matrix  # noqa: E402
from evaluation.rows import (
    break_even_us,
    build_rows,
    noise,
    query_budget_us,
    row_with,
    write_csv,
)  # noqa: E402
from evaluation.runs import Measured, Pass  # noqa: E402

DEVICE = "geforce-fx-5950"


def frame(number, frame_ms, **changes):
    """A client's frame with ten queries; `changes` say what is different."""
    record = {
        "frame": number, "frame_ms": frame_ms, "stall_ms": 0.0, "queries": 10, "results_waited": 10,
        "drawn_objects": 3, "drawn_triangles": 30, "frustum_triangles": 100, "visible_objects": 2,
        "false_culls": 0, "wrong_pixels": 0, "contested_pixels": 0,
    }  # fmt: skip
    return {**record, **changes}


def one_pass(times_ms, **changes):
    frames = [frame(number, time, **changes) for number, time in enumerate(times_ms)]
    layer = [{"queries_begun": f["queries"], "waits": f["results_waited"], "stall_ms": 0.0} for f in frames]
    return Pass(frames, {}, layer, [], 0.0)


def measured_once(times_ms, **changes):
    return Measured(one_pass(times_ms, **changes), [one_pass(times_ms, **changes)])


def matrix_of(late_times_ms=(6.0, 6.0)):
    """Frustum 4 and 12 ms, stop-and-wait 2 and 2 ms, or late by 500 us 6 and 6 ms; ideal 1 and 1 ms."""
    quiet = {"queries": 0, "results_waited": 0}
    return {
        Configuration(DEVICE, "frustum"): measured_once((4.0, 12.0), drawn_triangles=100, **quiet),
        Configuration(DEVICE, "stop-and-wait"): measured_once((2.0, 2.0)),
        Configuration(DEVICE, "stop-and-wait", 500): measured_once(late_times_ms),
        Configuration(DEVICE, "ideal"): measured_once((1.0, 1.0), **quiet),
    }


def device_pass(times_ms, **changes):
    """A pass on the device's clock, of which a quarter is stalled and half keeps the GPU busy."""
    one = one_pass(times_ms, **changes)
    for client, layer, time in zip(one.frames, one.layer_frames, times_ms):
        client["device_ms"] = time
        layer.update(device_ms=time, device_stall_ms=time / 4, gpu_busy_ms=time / 2, starvation_ms=time / 2)
        layer.update(back_pressure_ms=0.0, drain_ms=0.5, draws=client["queries"] + 3)
    return one


def device_matrix_of():
    """Frustum 4 and 12 ms on the device, stop-and-wait 4 and 4 ms, ideal 2 and 2 ms; each twice."""
    frustum, waiting, ideal = build_device_matrix()
    quiet = {"queries": 0, "results_waited": 0}
    return {
        frustum: [device_pass((4.0, 12.0), drawn_triangles=100, **quiet) for _ in range(2)],
        waiting: [device_pass((4.0, 4.0)) for _ in range(2)],
        ideal: [device_pass((2.0, 2.0), **quiet) for _ in range(2)],
    }


def broken_on_device(device_measured):
    return [check.sentence for check in run_device_checks(device_measured, matrix_of()) if not check.holds]


def broken(measured):
    return [check.sentence for check in run_checks(measured) if not check.holds]


class Rows(unittest.TestCase):
    def test_the_two_speed_ups_are_the_ratio_of_means_and_the_mean_of_ratios(self):
        row = row_with(build_rows(matrix_of((4.0, 6.0))), DEVICE, "stop-and-wait", 500)
        self.assertAlmostEqual(row.speedup_of_means, 16 / 10)
        self.assertAlmostEqual(row.speedup_mean, (4 / 4 + 12 / 6) / 2)

    def test_a_frame_counts_with_the_median_of_its_rounds(self):
        measured = matrix_of()
        late = next(key for key in measured if key.latency_us)
        measured[late].timed = [one_pass((5.0, 6.0)), one_pass((90.0, 7.0)), one_pass((6.0, 80.0))]
        row = row_with(build_rows(measured), DEVICE, "stop-and-wait", 500)
        self.assertAlmostEqual(row.frame_ms, (6 + 7) / 2)

    def test_asking_pays_up_to_where_the_lines_cross(self):
        # 2 ms at 0 us and 18 ms at 500 us meet frustum's mean of 8 ms at 187.5 us.
        self.assertAlmostEqual(
            break_even_us(build_rows(matrix_of((18.0, 18.0))), DEVICE, "stop-and-wait"), 187.5
        )
        self.assertIsNone(break_even_us(build_rows(matrix_of((6.0, 6.0))), DEVICE, "stop-and-wait"))

    def test_a_query_costs_what_the_frame_takes_longer_than_ideal(self):
        rows = build_rows(matrix_of())
        costs = [row.query_cost_us for row in rows]
        self.assertEqual(costs, [None, 100.0, 500.0, None])  # (2 - 1) and (6 - 1) ms over ten queries
        self.assertAlmostEqual(query_budget_us(rows, DEVICE, "stop-and-wait"), 700.0)
        self.assertEqual([row.frames_faster_total for row in rows], [0, 2, 1, 2])

    def test_a_configuration_that_failed_is_no_row(self):
        measured = matrix_of()
        measured[next(iter(measured))] = Measured()
        rows = build_rows(measured)
        self.assertEqual(len(rows), 3)
        self.assertIsNone(rows[0].speedup_of_means)

    def test_the_matrix_holds_an_a_a_pair_for_a_silent_and_an_asking_culler(self):
        matrix = build_matrix([0, 50])
        self.assertEqual(len(set(matrix)), 2 * (2 + 2) + 2)
        again = {Configuration(DEVICE, "frustum", repeat=1): measured_once((4.4, 13.2), queries=0)}
        pairs = noise(build_rows({**matrix_of(), **again}))
        self.assertEqual([round(difference, 6) for _, _, difference in pairs], [0.1])

    def test_the_csv_has_every_row_and_leaves_empty_what_does_not_apply(self):
        rows = build_rows(matrix_of())
        with tempfile.TemporaryDirectory() as folder:
            write_csv(rows, Path(folder, "table.csv"))
            lines = list(csv.DictReader(Path(folder, "table.csv").read_text().splitlines()))
        self.assertEqual([line["culler"] for line in lines], [row.culler for row in rows])
        self.assertEqual(
            (lines[0]["latency_us"], lines[1]["latency_us"], lines[2]["latency_us"]), ("", "0", "500")
        )


class DeviceTime(unittest.TestCase):
    def test_a_row_is_the_mean_frame_and_its_parts(self):
        frustum, waiting, ideal = build_device_rows(device_matrix_of())
        self.assertEqual((frustum.device_ms, waiting.device_ms, ideal.device_ms), (8.0, 4.0, 2.0))
        self.assertEqual((waiting.stall_ms, waiting.gpu_busy_ms, waiting.drain_ms), (1.0, 2.0, 0.5))
        self.assertEqual((waiting.draws, waiting.queries), (3, 10))
        self.assertEqual(waiting.cpu_ms, 4.0 - 1.0 - 0.5)
        self.assertEqual((waiting.speedup_of_means, waiting.speedup_mean), (16 / 8, (4 / 4 + 12 / 4) / 2))

    def test_a_configuration_that_failed_is_no_row(self):
        measured = device_matrix_of()
        measured[build_device_matrix()[0]] = []
        rows = build_device_rows(measured)
        self.assertEqual([row.culler for row in rows], ["stop-and-wait", "ideal"])
        self.assertIsNone(rows[0].speedup_of_means)

    def test_a_sound_measurement_breaks_no_check(self):
        self.assertEqual(broken_on_device(device_matrix_of()), [])

    def test_each_fault_breaks_the_check_that_is_about_it(self):
        waiting = build_device_matrix()[1]
        lying = device_pass((4.0, 4.0))
        lying.layer_frames[1]["device_ms"] += 2e-6
        for passes, words in (
            ([device_pass((4.0, 4.0)), device_pass((4.0, 4.000001))], "On the device's clock every run"),
            ([lying, device_pass((4.0, 4.0))], "The client measures"),
            ([device_pass((4.0, 4.0), drawn_triangles=31) for _ in range(2)], "The device's clock changes"),
        ):
            with self.subTest(check=words):
                sentences = broken_on_device({**device_matrix_of(), waiting: passes})
                self.assertTrue(len(sentences) == 1 and sentences[0].startswith(words), sentences)

    def test_a_check_that_looked_at_nothing_does_not_hold(self):
        self.assertEqual(len(broken_on_device({row: [] for row in build_device_matrix()})), 3)


class DeviceRates(unittest.TestCase):
    def test_a_rate_is_frames_by_their_device_time_and_the_parts_are_shares_of_it(self):
        parts = {"gpu_busy_ms": 1.0, "starvation_ms": 3.0, "device_stall_ms": 1.0, "back_pressure_ms": 0.4}
        frames = [{"device_ms": ms, "drain_ms": 0.6, "draws": 3, **parts} for ms in (2.0, 6.0)]
        cells = device_rates.row_of(device_rates.PROGRAMS[0], "geforce3", frames)
        self.assertEqual(
            cells,
            ("glxgears", "`geforce3`", "250", "4.000", "25%", "75%", "50%", "25%", "10%", "15%"),
        )
        self.assertEqual(len(cells), len(device_rates.HEADINGS))


class Checks(unittest.TestCase):
    def test_a_sound_measurement_breaks_none(self):
        self.assertEqual(broken(matrix_of()), [])

    def test_each_fault_breaks_the_check_that_is_about_it(self):
        late = Configuration(DEVICE, "stop-and-wait", 500)
        ideal = Configuration(DEVICE, "ideal")
        uncounted = measured_once((6.0, 6.0))
        uncounted.timed[0].layer_frames[1]["queries_begun"] = 9
        restless = Measured(one_pass((6.0, 6.0)), [one_pass((6.0, 6.0), drawn_triangles=31)])
        for configuration, value, words in (
            (late, measured_once((6.0, 6.0), false_culls=1), "Nothing visible is culled"),
            (late, restless, "A repeated run draws the same"),
            (late, measured_once((6.0, 6.0), drawn_triangles=40), "Neither latency nor the kind"),
            (late, measured_once((6.0, 6.0), drawn_triangles=101), "No culler draws more"),
            (
                ideal,
                measured_once((1.0, 1.0), drawn_triangles=29, queries=0),
                "The ideal culler draws exactly",
            ),
            (late, uncounted, "The client and the layer"),
            (late, measured_once((6.0, 4.9)), "A frame lasts at least"),  # ten waits of 500 us are 5 ms
        ):
            with self.subTest(check=words):
                sentences = broken({**matrix_of(), configuration: value})
                self.assertTrue(any(sentence.startswith(words) for sentence in sentences), sentences)

    def test_a_check_that_looked_at_nothing_does_not_hold(self):
        nothing = {configuration: Measured() for configuration in build_matrix([0, 50])}
        self.assertEqual(len(broken(nothing)), 7)


if __name__ == "__main__":
    unittest.main()
