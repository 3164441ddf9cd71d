# SPDX-License-Identifier: MIT
"""glxinfo tells what a machine is: under a pass-through device the machine below, bit for bit; under another,
that one."""
import re
import unittest

import under_layer

COMMAND = ["glxinfo"]
COMPATIBILITY = "OpenGL extensions:"
EVERY_PROFILE = [COMPATIBILITY, "OpenGL core profile extensions:", "OpenGL ES profile extensions:"]


def extensions(text, heading):
    """The words of one extension list of glxinfo's output, in its order; none where the heading is missing."""
    _, found, rest = text.partition(heading + "\n")
    return re.findall(r"\w+", rest.partition("\n\n")[0].partition(":")[0]) if found else []


def version(text):
    """The version numbers of the compatibility context, as in (4, 5)."""
    found = re.search(r"^OpenGL version string: (\d+)\.(\d+)", text, re.MULTILINE)
    return (int(found[1]), int(found[2]))


class Glxinfo(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.bare = under_layer.run(COMMAND, layer=False)
        cls.fx = under_layer.run(COMMAND, device="visualize-fx")
        cls.geforce = under_layer.run(COMMAND, device="geforce-fx-5950")

    def test_without_the_layer_there_is_no_report_and_no_hp_test(self):
        self.assertEqual(self.bare.status, 0)
        self.assertIsNone(self.bare.report)
        self.assertNotIn("GL_HP_occlusion_test", self.bare.output)
        self.assertIn("GL_ARB_occlusion_query", extensions(self.bare.output, COMPATIBILITY))

    def test_a_pass_through_device_prints_what_mesa_prints_bit_for_bit(self):
        for device in (None, "native", "mesa"):
            for clock in (None, "wall=50"):
                with self.subTest(device=device, clock=clock):
                    run = under_layer.run(COMMAND, device=device, clock=clock)
                    self.assertTrue(run.layers_report().contexts("glxinfo"))
                    self.assertEqual((run.output, run.errors, run.status),
                                     (self.bare.output, self.bare.errors, self.bare.status))

    def test_the_visualize_fx_has_the_hp_test_once_and_no_occlusion_query(self):
        words = extensions(self.fx.output, COMPATIBILITY)
        self.assertEqual(words.count("GL_HP_occlusion_test"), 1)
        later = r"occlusion_query|conditional_render|query_buffer"
        self.assertEqual([word for word in words if re.search(later, word)], [])
        self.assertEqual(version(self.fx.output), (1, 1))

    def test_the_geforce_fx_has_the_arb_query_once_and_no_hp_test(self):
        words = extensions(self.geforce.output, COMPATIBILITY)
        self.assertEqual(words.count("GL_ARB_occlusion_query"), 1)
        self.assertNotIn("GL_HP_occlusion_test", words)
        self.assertNotIn("GL_ARB_occlusion_query2", words)
        self.assertEqual(version(self.geforce.output), (1, 5))

    def test_no_extension_is_listed_twice_in_any_profile(self):
        for name, run in (("visualize-fx", self.fx), ("geforce-fx-5950", self.geforce)):
            for heading in EVERY_PROFILE:
                with self.subTest(device=name, heading=heading):
                    words = extensions(run.output, heading)
                    self.assertEqual(sorted(words), sorted(set(words)))

    def test_core_and_es_contexts_never_list_the_compatibility_extensions(self):
        for name, run in (("visualize-fx", self.fx), ("geforce-fx-5950", self.geforce)):
            for heading in EVERY_PROFILE[1:]:
                with self.subTest(device=name, heading=heading):
                    words = extensions(run.output, heading)
                    self.assertNotIn("GL_HP_occlusion_test", words)
                    self.assertNotIn("GL_ARB_occlusion_query", words)

    def test_an_emulated_device_changes_nothing_of_glx_and_ends_as_without_it(self):
        glx = self.bare.output.partition("OpenGL vendor string")[0].partition("Extended renderer info")[0]
        self.assertIn("GLX_ARB_create_context", glx)
        for run in (self.fx, self.geforce):
            self.assertEqual(run.status, 0)
            self.assertTrue(run.output.startswith(glx))

    def test_latency_changes_nothing_of_what_a_device_says(self):
        for device, without in (("visualize-fx", self.fx), ("geforce-fx-5950", self.geforce)):
            with self.subTest(device=device):
                delayed = under_layer.run(COMMAND, device=device, clock="frames=2")
                self.assertEqual(delayed.output, without.output)


if __name__ == "__main__":
    under_layer.main()
