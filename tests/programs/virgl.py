# SPDX-License-Identifier: MIT
"""virgl's test server renders for other processes: it is a GL program of its own, without a window, that makes the
queries which its clients ask for. With the layer beneath the server, piglit as its client has the outcomes that it has
without, each test and each subtest.

The server looks for results only when a fence has come: under a clock, no fence may come before the results are due.
The client half of Mesa knows one socket only, so one server at a time runs on a machine.
"""
import contextlib
import os
import pathlib
import socket
import sys
import time
import unittest

import under_layer

sys.path.insert(0, str(pathlib.Path(__file__).with_name("piglit")))
import run_piglit  # noqa: E402  a script beside this one's folder

SOCKET = "/tmp/.virgl_test"  # virglrenderer, vtest_protocol.h: VTEST_DEFAULT_SOCKET_NAME
CLIENT = ("LIBGL_ALWAYS_SOFTWARE=true", "GALLIUM_DRIVER=virpipe")
TIMEOUT_S = 20
AGAIN = 6  # further pairs of runs in which a verdict that hangs on time has to be seen on both sides


def somebody_listens():
    with contextlib.closing(socket.socket(socket.AF_UNIX)) as client:
        try:
            client.connect(SOCKET)
        except OSError:
            return False
        return True


@contextlib.contextmanager
def server(**how):
    """A running server."""
    with contextlib.suppress(FileNotFoundError):
        os.unlink(SOCKET)
    command = ["virgl_test_server", "--no-fork", "--use-egl-surfaceless"]
    with under_layer.Program(command, environment={"LIBGL_ALWAYS_SOFTWARE": "true"}, **how) as program:
        deadline = time.monotonic() + 20
        while not pathlib.Path(SOCKET).exists():
            if program.process.poll() is not None or time.monotonic() > deadline:
                raise AssertionError(f"the server does not come up\n{program.finish().errors}")
            time.sleep(0.05)
        yield program


def has_drawn(program):
    report = program.report_now()
    return report is not None and report.frames()


def play(job, layer=True, **how):
    """Run one piglit test against a server of its own, which may hang at its second client: outcome, server's run."""
    with server(layer=layer, **how) as program:
        outcome = run_piglit.run_job(job, run_piglit.piglit_environment(extra=CLIENT), TIMEOUT_S)
        # The server ends its client's contexts, and so their frames, when it has seen the client go.
        deadline = time.monotonic() + 5
        while layer and not has_drawn(program) and time.monotonic() < deadline:
            time.sleep(0.02)
        program.process.terminate()
        return outcome, program.finish()


class Virgl(unittest.TestCase):
    def test_piglits_outcomes_are_the_same_with_the_layer_beneath_the_server(self):
        jobs = run_piglit.read_jobs("fbo", "occlusion[-_]query")
        self.assertGreaterEqual(len(jobs), 10)
        queries, passed = 0, set()
        for job in jobs:
            with self.subTest(piglit=job.name):
                bare, bare_server = play(job, layer=False)
                self.assertIn("gl_version", bare_server.errors)  # the server says so when a client renders
                self.assertIsNone(bare_server.report)
                outcome, its_server = play(job, device="mesa")
                report = its_server.layers_report()
                self.assertEqual({context["program"] for context in report.contexts()}, {"virgl_test_server"})
                queries += report.total("queries_begun")
                passed |= {job.name} if outcome.result == "pass" else set()
                # A poll loop of piglit's may end before the server has answered, with the layer as without.
                without, beneath = {bare.verdict()}, {outcome.verdict()}
                for _ in range(AGAIN):
                    if without & beneath:
                        break
                    without.add(play(job, layer=False)[0].verdict())
                    beneath.add(play(job, device="mesa")[0].verdict())
                self.assertTrue(without & beneath, (without, beneath, outcome.output[-2000:]))
        self.assertGreater(queries, len(jobs))
        self.assertIn("spec@arb_occlusion_query@occlusion_query", passed)

    def test_piglits_occlusion_query_passes_however_late_its_results_are(self):
        job, = run_piglit.read_jobs("fbo", "^spec@arb_occlusion_query@occlusion_query$")
        for clock in ("wall=2000", "calls=20"):
            with self.subTest(clock=clock):
                outcome, its_server = play(job, device="mesa", clock=clock)
                self.assertEqual(outcome.result, "pass", outcome.output)
                self.assertGreater(its_server.layers_report().total("queries_begun"), 0)


if __name__ == "__main__":
    if somebody_listens():
        print(f"another virgl server listens on {SOCKET}: skipped")
        sys.exit(under_layer.SKIP)
    under_layer.main()
