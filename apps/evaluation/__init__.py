# SPDX-License-Identifier: MIT
"""The evaluation: a matrix of cullers, devices and latencies, measured, checked and shown on one page."""
