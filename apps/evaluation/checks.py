# SPDX-License-Identifier: MIT
"""What must hold whatever the machine's speed. Each check is a sentence, judged on every frame.

Times are compared with nothing here but a lower bound that follows from the definition of the clock.
"""
from dataclasses import dataclass

from .matrix import BASELINE, BOUND


@dataclass
class Check:
    """`count` of `things` were looked at; a check that looked at nothing does not hold."""

    sentence: str
    faults: list
    count: int
    things: str

    @property
    def holds(self):
        return self.count > 0 and not self.faults

    @property
    def looked_at(self):
        return f"{self.count:,} {self.things}"


def column(one, key):
    return [frame[key] for frame in one.frames]


def passes_of(measured):
    """All passes with their configuration."""
    for configuration, value in measured.items():
        for one in ([value.judged] if value.judged else []) + value.timed:
            yield configuration, one


def differing_frames(first, second):
    return [number for number, (a, b) in enumerate(zip(first, second)) if a != b]


def nothing_visible_is_culled(measured):
    faults, frames = [], 0
    for configuration, value in measured.items():
        if value.judged:
            frames += len(value.judged.frames)
            culled = [f for f in value.judged.frames if f["false_culls"]]
            faults += [
                f"{configuration.name}, frame {f['frame']}: {f['false_culls']} objects" for f in culled
            ]
    return Check("Nothing visible is culled, in any frame", faults, frames, "frames under the oracle")


def every_pass_draws_the_same(measured):
    faults, count = [], 0
    for configuration, value in measured.items():
        for number, one in enumerate(value.timed, start=1):
            count += 1
            wrong = differing_frames(column(value.judged, "drawn_triangles"), column(one, "drawn_triangles"))
            faults += [f"{configuration.name}, round {number}: frames {wrong}"] if wrong else []
    return Check("A repeated run draws the same triangles in every frame", faults, count, "timed runs")


def late_results_change_nothing_drawn(measured):
    faults, count, reference = [], 0, {}
    for configuration, value in measured.items():
        if not value.judged or not configuration.queries:
            continue
        drawn = column(value.judged, "drawn_triangles")
        first = reference.setdefault(configuration.culler, drawn)
        count += 1
        wrong = differing_frames(first, drawn)
        faults += [f"{configuration.name}: frames {wrong}"] if wrong else []
    sentence = "Neither latency nor the kind of hardware test changes what a waiting culler draws"
    return Check(sentence, faults, count, "configurations")


def culling_draws_no_more(measured):
    faults, count = [], 0
    for configuration, value in measured.items():
        if not value.judged or configuration.culler == BASELINE:
            continue
        count += 1
        more = [f["frame"] for f in value.judged.frames if f["drawn_triangles"] > f["frustum_triangles"]]
        faults += [f"{configuration.name}: frames {more}"] if more else []
    return Check("No culler draws more than what is inside the view frustum", faults, count, "configurations")


def ideal_draws_what_waiting_draws(measured):
    faults, count = [], 0
    for configuration, value in measured.items():
        if configuration.culler != BOUND or not value.judged:
            continue
        for other, judged in ((o, v.judged) for o, v in measured.items()):
            if other.queries and other.device == configuration.device and other.repeat == 0 and judged:
                count += 1
                wrong = differing_frames(
                    column(value.judged, "drawn_triangles"), column(judged, "drawn_triangles")
                )
                faults += [f"{configuration.name} against {other.name}: frames {wrong}"] if wrong else []
    return Check("The ideal culler draws exactly what stop-and-wait draws", faults, count, "pairs of runs")


def client_and_layer_count_alike(measured):
    faults, count = [], 0
    for configuration, one in passes_of(measured):
        # The recording of ideal asks as well, outside the counted part of the frame.
        if configuration.culler == BOUND or not one.layer_frames:
            continue
        count += 1
        client, layer = sum(column(one, "queries")), sum(f["queries_begun"] for f in one.layer_frames)
        faults += [f"{configuration.name}: client {client}, layer {layer}"] if client != layer else []
    return Check("The client and the layer under it count the same queries", faults, count, "runs")


def every_wait_lasts(measured):
    faults, count = [], 0
    for configuration, one in passes_of(measured):
        if not configuration.queries or not configuration.latency_us:
            continue
        for frame in one.frames:
            count += 1
            least_ms = frame["results_waited"] * configuration.latency_us / 1000
            if frame["frame_ms"] < least_ms:
                faults.append(
                    f"{configuration.name}, frame {frame['frame']}: {frame['frame_ms']:.3f} ms, "
                    f"{frame['results_waited']} waits take at least {least_ms:.3f} ms"
                )
    sentence = "A frame lasts at least as long as the waits that it made one after another"
    return Check(sentence, faults, count, "frames with late results")


def run_checks(measured):
    checks = [
        nothing_visible_is_culled(measured),
        every_pass_draws_the_same(measured),
        late_results_change_nothing_drawn(measured),
        ideal_draws_what_waiting_draws(measured),
        culling_draws_no_more(measured),
        client_and_layer_count_alike(measured),
    ]
    if any(configuration.latency_us for configuration in measured):
        checks.append(every_wait_lasts(measured))
    return checks
