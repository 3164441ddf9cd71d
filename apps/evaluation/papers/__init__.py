# SPDX-License-Identifier: MIT
"""The papers' experiments, each a module with the same three parts: the jobs that it wants, the section of the page
that it makes of their results, and what must hold of them."""
