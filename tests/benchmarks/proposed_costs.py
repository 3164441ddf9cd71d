# SPDX-License-Identifier: MIT
"""What the proposed extensions cost: tables of unit_cost and region_cost, and the bounds that were set for them.

Native rows and rows of the extension are timed in turn in one process, under the layer, so a figure is a ratio within a
round, and its median over the rounds. A bound that does not hold is said, not an error: the machine may be busy.
"""
import json
import math
import os
import pathlib
import statistics
import subprocess
import sys

# A machine with both extensions beside all that the driver has: the ways without them need framebuffer objects.
DEVICE = pathlib.Path(__file__).resolve().parents[2] / "conformance/devices/proposals.toml"
# Rows of unit_cost -> largest ratio to a native query that was set: of the size, None for every size.
BOUNDS = {
    "visible hits": {None: 1.05},
    "visible hits, batched": {None: 1.05},
    "projected and visible hits": {None: 2.4},
    "all registers": {8_000: 2.0, 126_000: 3.5},
}
GOALS = {"all registers": {8_000: 1.6, 126_000: 3.0}}
REGION_BOUND, ROUNDS_BOUND = 1.3, 5.0


def run_program(program, options):
    """The JSON that the program prints."""
    environment = dict(os.environ, LP_NUM_THREADS=str(options.threads), LIBGL_ALWAYS_SOFTWARE="1",
                       LD_PRELOAD=str(options.build / "lib/libglext_emu.so"), GLEXT_EMU=f"device={DEVICE}")
    done = subprocess.run([options.build / "bin" / program, "--rounds", str(options.rounds)], env=environment, text=True,
                          check=False, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    if done.returncode != 0:
        sys.exit(f"{program} ended with status {done.returncode}\n{done.stderr}")
    return json.loads(done.stdout)


def ratio(times, row, base):
    """Median over the rounds of one row's time in terms of the mean of the two native ones."""
    if row.endswith("again"):
        return statistics.median(b / a for a, b in zip(times[base], times[row]))
    both = [(a + b) / 2 for a, b in zip(times[base], times[base + " again"])]
    return statistics.median(a / b for a, b in zip(times[row], both))


def unit_table(cases):
    """Prints a table, a column a case, and returns {row: {(pixels, percent): ratio}}; -: undetermined there."""
    keys = [(case["pixels"], case["visible_percent"]) for case in cases]
    print(f"{'pixels':28}" + "".join(f"{pixels:9,}" for pixels, _ in keys))
    print(f"{'visible':28}" + "".join(f"{percent:8}%" for _, percent in keys))
    times = [case["microseconds"] for case in cases]
    ratios = {}
    for row in dict.fromkeys(row for one in times for row in one):
        base = "native, batched" if "batched" in row else "native"
        if row == base:
            print(f"{row + ', us':28}" + "".join(f"{statistics.median(one[row]):9.1f}" for one in times))
            continue
        ratios[row] = {key: ratio(one, row, base) for key, one in zip(keys, times) if row in one}
        print(f"{row:28}" + "".join(f"{ratios[row][key]:9.2f}" if key in ratios[row] else "        -" for key in keys))
    return ratios


def verdict(holds):
    return "holds" if holds else "does not hold"


def judge_unit(ratios):
    """Prints what became of each bound; returns whether all hold."""
    all_hold = True
    for row, limits in BOUNDS.items():
        for size, limit in limits.items():
            if row not in ratios:
                print(f"{row}: undetermined")
                all_hold = False
                continue
            worst, (pixels, percent) = max((v, key) for key, v in ratios[row].items() if size in (None, key[0]))
            goal = GOALS.get(row, {}).get(size)
            print(f"{row}{f' at {size:,} px' if size else ''}: at most {worst:.2f} ({pixels:,} px, {percent} % visible); "
                  f"bound {limit:.2f}: {verdict(worst <= limit)}"
                  + (f", goal {goal:.2f}: {verdict(worst <= goal)}" if goal else ""))
            all_hold &= worst <= limit
    return all_hold


def crossover(sweep, unit_row, other_row):
    """From how many pixels on the unit is the cheaper way, as half a sentence."""
    if not all(unit_row in case["microseconds"] for case in sweep):
        return "undetermined"
    sizes = [case["pixels"] for case in sweep]
    logs = [math.log(statistics.median(a / b for a, b in zip(case["microseconds"][unit_row],
                                                             case["microseconds"][other_row]))) for case in sweep]
    dearer = [at for at, value in enumerate(logs) if value > 0]
    if not dearer:
        return f"the unit is cheaper at every size from {sizes[0]:,} to {sizes[-1]:,} px"
    last = dearer[-1]
    if last == len(sizes) - 1:
        return f"the read-back is still cheaper at {sizes[-1]:,} px"
    share = logs[last] / (logs[last] - logs[last + 1])
    size = math.exp(math.log(sizes[last]) * (1 - share) + math.log(sizes[last + 1]) * share)
    return f"the unit is cheaper from about {size:,.0f} px on"


def unit_cost(options):
    answer = run_program("unit_cost", options)
    drawings = list(dict.fromkeys(case["drawing"] for case in answer["cases"]))
    tables = {}
    for drawing in drawings:
        print(f"\nOcclusion Unit, {drawing}: in terms of a native samples query of the same box of twelve triangles, both "
              f"sides drawn;\nalone: stop and wait")
        tables[drawing] = unit_table([case for case in answer["cases"] if case["drawing"] == drawing])
    print(f"\nbounds, of {drawings[0]}:")
    holds = judge_unit(tables[drawings[0]])
    print("\nbeside reading back, half visible: microseconds")
    rows = ["visible hits and screen box", "marks read back", "all registers", "all read back"]
    print(f"{'pixels':28}" + "".join(f"{case['pixels']:9,}" for case in answer["sweep"]))
    for row in rows:
        if row not in answer["sweep"][0]["microseconds"]:
            continue
        print(f"{row:28}" + "".join(f"{statistics.median(c['microseconds'][row]):9.1f}" for c in answer["sweep"]))
    for unit_row, other_row in (rows[:2], rows[2:]):
        print(f"{unit_row}: {crossover(answer['sweep'], unit_row, other_row)}")
    return answer, holds


def region_cost(options):
    answer = run_program("region_cost", options)
    holds = True
    for case in answer["cases"]:
        print(f"\nregions of 32 x 32 pixels, draws of {case['draw_side']} x {case['draw_side']}")
        for part, base in (("idle", "raw read"), ("pending", "64 x draw and read")):
            for row, times in case[part].items():
                compared = "" if row == base else f"{ratio(case[part], row, base):9.2f}"
                print(f"{row:28}{statistics.median(times):9.2f} us{compared}")
        one = ratio(case["idle"], "furthest depth", "raw read")
        faster = 1 / ratio(case["pending"], "64 draws, one call", "64 x draw and read")
        ceiling = 1 / ratio(case["pending"], "64 draws and glFinish", "64 x draw and read")
        print(f"one region, nothing pending: {one:.2f} of a raw read; bound {REGION_BOUND:.2f}: {verdict(one <= REGION_BOUND)}")
        print(f"64 regions after 64 draws in one call: {faster:.1f} times as fast as in rounds; bound {ROUNDS_BOUND:.1f}: "
              f"{verdict(faster >= ROUNDS_BOUND)}; ceiling, drawing only: {ceiling:.1f}")
        holds &= one <= REGION_BOUND and faster >= ROUNDS_BOUND
    return answer, holds
