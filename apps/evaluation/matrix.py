# SPDX-License-Identifier: MIT
"""What is measured: which culler, on which emulated device, with results how late. Pure data."""
from dataclasses import dataclass

SCENE = "chc-city"
DEVICES = ("visualize-fx", "geforce-fx-5950")
# Issue a query and so depend on its latency; the others are measured once per device.
QUERYING = ("stop-and-wait",)
BASELINE = "frustum"
BOUND = "ideal"
# Measured in its own time too: the paper's machine, whose costs are fitted to the paper's figures.
TIMED_DEVICE = "geforce-fx-5950"

DEVICE_TITLES = {
    "visualize-fx": "HP Visualize fx (1997): one test at a time, GL_HP_occlusion_test",
    "geforce-fx-5950": "GeForce FX 5950 (2003): query objects, GL_ARB_occlusion_query",
}


@dataclass(frozen=True)
class Configuration:
    """One row of a table. `repeat` tells the two rows of an A/A pair apart; nothing else may use it."""

    device: str
    culler: str
    latency_us: float = 0
    repeat: int = 0
    in_device_time: bool = False

    @property
    def clock(self):
        """The layer's clock: `none` leaves the driver's own time, `wall=US` delays each result, `device` is the
        device's own time."""
        if self.in_device_time:
            return "device"
        return f"wall={self.latency_us:g}" if self.latency_us else "none"

    @property
    def name(self):
        """Also the stem of this configuration's files."""
        if self.in_device_time:
            return f"{self.device}.{self.culler}.device-time"
        return f"{self.device}.{self.culler}.{self.latency_us:g}us" + (".again" if self.repeat else "")

    @property
    def queries(self):
        return self.culler in QUERYING


def build_device_matrix():
    """The rows in the device's own time: with results as late as they are on it."""
    return [Configuration(TIMED_DEVICE, culler, in_device_time=True) for culler in (BASELINE, *QUERYING, BOUND)]


def build_matrix(latencies_us, devices=DEVICES):
    """All rows, in the order of the table; the A/A pair repeats two rows of the last device."""
    rows = []
    for device in devices:
        rows.append(Configuration(device, BASELINE))
        rows += [Configuration(device, culler, latency) for culler in QUERYING for latency in latencies_us]
        rows.append(Configuration(device, BOUND))
    rows.append(Configuration(devices[-1], BASELINE, repeat=1))
    rows.append(Configuration(devices[-1], QUERYING[0], latencies_us[0], repeat=1))
    return rows
