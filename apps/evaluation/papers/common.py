# SPDX-License-Identifier: MIT
"""What the experiments share: how large they are, what they return, ratios as text."""
from dataclasses import dataclass, field

from ..checks import Check
from ..tables import DASH, number


@dataclass(frozen=True)
class Extent:
    """How much of an experiment is run. `small` is part of ./evaluate, `full` is the paper's scene and sizes."""

    name: str

    @property
    def is_full(self):
        return self.name == "full"


SMALL, FULL = Extent("small"), Extent("full")


@dataclass
class Section:
    """A part of a page, and what is to be said of it elsewhere."""

    title: str
    html: str
    checks: list = field(default_factory=list)
    goals: list = field(default_factory=list)
    rows: list = field(default_factory=list)  # dicts with the same keys, for the CSV


@dataclass(frozen=True)
class Goal:
    """Something hoped for, told whether or not it was reached; unlike a check it is no fault if not."""

    sentence: str
    wanted: str
    measured: str
    is_met: bool


def ratio(first, second, digits=2):
    """`first / second` as text; a dash where one is missing or the second is 0."""
    return DASH if first is None or not second else number(first / second, digits)


def speedups(baseline_ms, times_ms):
    """(mean of the frames' ratios, ratio of the means)."""
    ratios = [before / after for before, after in zip(baseline_ms, times_ms)]
    return sum(ratios) / len(ratios), sum(baseline_ms) / sum(times_ms)


def nothing_visible_is_culled(results, may_trade=lambda job: False):
    """The check of all experiments; `may_trade(job)` tells which jobs were asked to lose samples."""
    faults, count = [], 0
    for job, result in results.items():
        if may_trade(job) or not job.judge_every:
            continue
        judged = [frame for frame in result.frames if "false_culls" in frame]
        count += len(judged)
        faults += [
            f"{job.name}, frame {frame['frame']}: {frame['false_culls']} objects"
            for frame in judged
            if frame["false_culls"] or frame["wrong_pixels"]
        ]
    return Check("A conservative culler leaves out nothing visible and changes no pixel", faults, count,
                 "frames under the oracle")  # fmt: skip
