# SPDX-License-Identifier: MIT
"""For each effect scenes that do not call for it, and scenes made for it. What is expected of a frame are sums of the
numbers in machine.toml, in microseconds, of the drawn geometry, and of timeline.h's model.
"""
import dataclasses

import under_device

FRAMES = 2  # as the client draws, where its words do not say otherwise
P = under_device.time_table("machine")


def us_each(rate_key):
    return 1e6 / P[rate_key]


TRIANGLE, FRAGMENT = us_each("triangles_per_second"), us_each("fragments_per_second")
CLEARED, SWAPPED = us_each("cleared_pixels_per_second"), us_each("swapped_pixels_per_second")
READ_PIXEL, REGION_PIXEL = us_each("read_pixels_per_second"), us_each("region_pixels_per_second")
COPIED = P["copied_triangle_ns"] / 1e3


def fragments(side):
    """Of a square: llvmpipe clips its one triangle to two, and counts blocks of 4 x 4 on their common edge for both."""
    return side * side + side // 4 * 16


@dataclasses.dataclass(frozen=True)
class Scene:
    """Words of the client; how the report's reason begins; and what is expected of each frame."""

    words: tuple
    reason: str
    own_us: float | None = None  # what the report says that the effect took; none: it is not one of time
    saved_us: float = 0.0  # by switching it off
    results: tuple | None = None  # of all frames, with the effect and without; none: they are the same


def scene(text, reason, own_us=None, saved_us=None, results=None):
    return Scene(tuple(text.split()), reason, own_us, (own_us or 0.0) if saved_us is None else saved_us, results)


SMALL, LARGE = 64 * 64, 512 * 512  # pixels
# A large window is cleared, drawn to 20 times and swapped: the CPU makes the draws in 200 us, the GPU needs 5,415 us.
CLEAR_US, DRAW_US, SWAP_US = LARGE * CLEARED, fragments(512) * FRAGMENT, LARGE * SWAPPED
BUSY_US = CLEAR_US + 20 * DRAW_US + SWAP_US
# Before the last draw the GPU may be no further behind than the FIFO holds; without it the CPU had made 19 draws.
HELD_UP_US = CLEAR_US + 19 * DRAW_US - P["fifo_us"] - 19 * P["batch_us"]
# A program that works on after its draws, while the GPU could: held up, it begins later.
WORK_US = 5000
HELD_UP_FRAME_US = HELD_UP_US + 20 * P["batch_us"] + WORK_US + P["swap_us"] + SWAP_US

# The GPU asks about a small box, waits for the result, and draws a triangle, twenty times: longer than the CPU takes.
SMALL_BOX_US = fragments(8) * us_each("depth_fragments_per_second")
CONDITIONAL_US = P["query_us"] + 20 * (P["gpu_query_us"] + SMALL_BOX_US + P["result_latency_us"] + TRIANGLE) + SMALL * SWAPPED

# 0.3 in the 24 bits of the window's depth buffer; furthest depths are rounded up to 8 bits, nearest ones down.
STORED = round(0.3 * (2**24 - 1)) / (2**24 - 1)
FURTHEST, NEAREST = 77 / 255, 76 / 255
HALF = 127 / 255  # as the nearest depth of 0.5 is told

UNCALLED = {
    "latency": [scene("clear mesh=1,100", "0 results were asked for", 0.0)],
    "back-pressure": [scene(f"clear mesh=1,100 work={WORK_US}", "the FIFO was never full", 0.0)],
    # Only the swap's fill is not done while the CPU works.
    "fill": [scene("clear mesh=1,100", "fragments took 0.18 % of the time", SMALL * (CLEARED + SWAPPED), SMALL * SWAPPED)],
    "driver-copy": [scene("clear mesh=100,20", "0 triangles lay outside video memory", 0.0),
                    scene("clear list=100,20", "0 triangles lay outside video memory", 0.0)],
    "multisampling": [scene("clear fill=64,64,20", "0 fragments had several samples", 0.0)],
    "read-cost": [scene("clear fill=64,64,20 ask=8,8,4", "0 pixels were read", 0.0)],
    "starvation": [scene("window=512,512 clear fill=512,512,20", "the GPU had nothing to do for 0.00 % of the time", 0.0)],
    "saturation": [scene("clear mesh=1,100", "0 of 0 counts did not fit their counter"),
                   scene("clear ask=8,8,4 unit=8,8,2", "0 of 16 counts did not fit their counter")],
    "depth-quantisation": [scene("clear mesh=1,100", "0 of 0 depths did not fit their register"),
                           scene("clear region=16,16,3 depth=0 unit=8,8,2", "0 of 10 depths did not fit their register")],
}
CALLED = {
    "latency": [scene("clear ask=8,8,20", "40 results were asked for, which took", 20 * P["result_latency_us"]),
                scene("clear condition=8,8,20", "40 results were asked for, which took", 20 * P["result_latency_us"],
                      CONDITIONAL_US - (20 * (P["query_us"] + P["batch_us"]) + P["swap_us"] + SMALL * SWAPPED))],
    "back-pressure": [scene(f"window=512,512 clear fill=512,512,20 work={WORK_US}", "the FIFO was full for", HELD_UP_US,
                            HELD_UP_FRAME_US - BUSY_US)],
    # A draw takes as long as the longer one of its vertices and its fragments.
    "fill": [scene("window=512,512 clear fill=512,512,20", "fragments took", BUSY_US - 20 * TRIANGLE,
                   BUSY_US - 20 * P["batch_us"] - P["swap_us"])],
    "driver-copy": [scene("clear arrays=100,20", "4000 triangles lay outside", 2000 * COPIED),
                    scene("clear immediate=100,20", "4000 triangles lay outside", 2000 * COPIED),
                    scene("clear immediate=100,10 list=100,10", "2000 triangles lay outside", 1000 * COPIED),
                    scene("video=2 clear mesh=100,20", "4000 triangles lay outside", 2000 * COPIED)],
    "multisampling": [scene("window=512,512 samples=4 clear fill=512,512,5",
                            f"{FRAMES * (LARGE + 5 * fragments(512))} fragments had several samples",
                            3 * (CLEAR_US + 5 * DRAW_US)),
                      scene("window=512,512 samples=4 clear", f"{FRAMES * LARGE} fragments had several samples",
                            3 * CLEAR_US, 4 * CLEAR_US - P["swap_us"])],
    "read-cost": [scene("clear fill=64,64,5 read=64,64,2 region=32,32,2", "20480 pixels were read, which took",
                        2 * SMALL * READ_PIXEL + 2 * 32 * 32 * REGION_PIXEL)],
    "starvation": [scene("window=512,512 work=3000 clear fill=512,512,20", "the GPU had nothing to do for", 3000)],
    "saturation": [scene("clear ask=16,16,4 unit=32,32,1 ask=8,8,1", "12 of 14 counts did not fit their counter",
                         results=(FRAMES * (255, 255, 255, 255, 255, HALF, 64), FRAMES * (256, 256, 256, 256, 1024, HALF, 64)))],
    "depth-quantisation": [scene("clear depth=0.3 fill=64,64,1 region=16,16,1 unit=8,8,1",
                                 "4 of 4 depths did not fit their register",
                                 results=(FRAMES * (FURTHEST, 64, NEAREST), FRAMES * (STORED, 64, STORED)))],
}
