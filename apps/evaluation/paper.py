# SPDX-License-Identifier: MIT
"""The published figures that ours stand beside: Bittner, Wimmer, Piringer, Purgathofer, "Coherent
Hierarchical Culling: Hardware Occlusion Queries Made Useful", Eurographics 2004, Table 1, rows of the city.

Theirs is a model of Vienna-like streets with 1,036,146 triangles on a Pentium 4 at 3.2 GHz and a GeForce FX
5950; ours a generated city with the same total. All values are means over the frames of a walk-through.
"""
from dataclasses import dataclass

SCENE_TRIANGLES = 1_036_146


@dataclass(frozen=True)
class Published:
    """One row of the paper's table. `speedup` is the mean of the frames' own ratios to frustum culling."""

    culler: str
    queries: int
    wait_ms: float
    drawn_triangles: int
    frame_ms: float
    speedup: float


CITY = (
    Published("frustum", None, None, 156_521, 19.79, 1.0),
    Published("stop-and-wait", 663, 9.49, 30_594, 19.9, 1.5),
    Published("ideal", None, None, 30_594, 4.55, 6.6),
)

FRUSTUM_TRIANGLES = CITY[0].drawn_triangles
VISIBLE_TRIANGLES = CITY[2].drawn_triangles
