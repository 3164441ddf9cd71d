# SPDX-License-Identifier: MIT
"""What the Occlusion Unit's parallel form costs: the table of shapes_cost, and the bounds that were set for it."""
import statistics

import proposed_costs

# Times as fast as native stop and wait, at least.
BOUNDS = {"quads": {"visible": 5.0, "all registers": 5.0}, "boxes": {"visible": 5.0, "all registers": 2.0}}
BASE = "native, stop and wait"


def times_as_fast(times, row):
    """Median over the rounds of the native time in terms of one row's; of the second native row, of each other's."""
    if row.endswith("again"):
        return statistics.median(a / b for a, b in zip(times[BASE], times[row]))
    both = [(a + b) / 2 for a, b in zip(times[BASE], times[BASE + " again"])]
    return statistics.median(a / b for a, b in zip(both, times[row]))


def shapes_cost(options):
    """Prints the tables; returns what the program said, and whether all bounds hold."""
    answer = proposed_costs.run_program("shapes_cost", options)
    all_hold = True
    for case in answer["cases"]:
        visible = 100 * case["visible_hits"] / case["projected_hits"]
        print(f"\n{answer['shapes']:,} {case['shape']} of about 300 px in one call, {visible:.0f} % of the samples visible; "
              f"{answer['width']} x {answer['height']}")
        print(f"{'':30}{'ms':>8}{'times as fast as stop and wait':>34}")
        fast = {row: times_as_fast(case["microseconds"], row) for row in case["microseconds"]}
        for row, times in case["microseconds"].items():
            print(f"{row:30}{statistics.median(times) / 1000:8.2f}" + ("" if row == BASE else f"{fast[row]:34.2f}"))
        for row, bound in BOUNDS[case["shape"]].items():
            print(f"{row}: {fast[row]:.1f} times as fast; bound {bound:.1f}: "
                  f"{proposed_costs.verdict(fast[row] >= bound)}")
            all_hold &= fast[row] >= bound
    return answer, all_hold
