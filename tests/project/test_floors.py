# SPDX-License-Identifier: MIT
"""Nobody includes upstairs: the tree keeps the floors of floors.py, and the check sees bad examples."""
import tempfile
import unittest
from pathlib import Path

from floors import LANGUAGES, violations
from tree import ROOT, project_files


def read(root, paths):
    return {
        str(path): (root / path).read_text(encoding="utf-8") for path in paths if path.suffix in LANGUAGES
    }


class TheTree(unittest.TestCase):
    def test_every_include_goes_down_the_stairs(self):
        texts = read(ROOT, project_files())
        self.assertTrue(texts, "no source file was found: the test looked at nothing")
        self.assertEqual(violations(texts), [])


class TheCheckItself(unittest.TestCase):
    """Each bad example is a small tree of files; a comment beside it says which rule it breaks."""

    def faults(self, tree):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in tree.items():
                path = Path(folder, name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            paths = [path.relative_to(folder) for path in Path(folder).rglob("*") if path.is_file()]
            return violations(read(Path(folder), paths))

    def test_a_good_tree_has_no_fault(self):
        good = {
            "occlusion_unit/clock.h": "#include <cstdint>\n",
            "glext_emu/real_gl/real.h": "#include <GL/gl.h>\n#include <dlfcn.h>\n",
            "glext_emu/context/context.h": '#include "occlusion_unit/clock.h"\n#include "real_gl/real.h"\n',
            "glext_emu/features/hp.cpp": '#include "context/context.h"\n#include "../context/context.h"\n',
            "apps/scene/city.cpp": "#include <glm/glm.hpp>\n#include <vector>\n",
            "apps/query/arb.cpp": '#include <GL/glext.h>\n#include "apps/scene/city.cpp"\n',
            "conformance/hp/result.cpp": "#include <gtest/gtest.h>\n#include <GL/gl.h>\n",
            "tests/unit/anything.cpp": '#include "glext_emu/context/context.h"\n',
        }
        self.assertEqual(self.faults(good), [])

    def test_each_step_upstairs_is_a_fault(self):
        above = {"glext_emu/context/c.h": "", "glext_emu/features/f.h": "", "glext_emu/entry/e.h": ""}
        for name, include in (
            ("occlusion_unit/a.cpp", "<GL/gl.h>"),  # the hardware knows no GL
            ("occlusion_unit/a.cpp", '"glext_emu/context/c.h"'),  # nor the layer
            ("glext_emu/real_gl/a.cpp", '"context/c.h"'),
            ("glext_emu/context/a.cpp", '"features/f.h"'),
            ("glext_emu/context/a.cpp", '"../features/f.h"'),  # however it is spelled
            ("glext_emu/features/a.cpp", '"entry/e.h"'),
            ("apps/culling/a.cpp", '"glext_emu/context/c.h"'),  # clients know only GL
            ("apps/culling/a.cpp", "<GL/gl.h>"),  # and call it in few folders
            ("apps/scene/a.cpp", "<EGL/egl.h>"),
            ("conformance/hp/a.cpp", '"glext_emu/context/c.h"'),  # judges any GL
            ("conformance/hp/a.cpp", "<glm/glm.hpp>"),
            ("glext_emu/context/a.cpp", '"nowhere.h"'),  # neither there nor generated
            ("glext_emu/cellar/a.cpp", "<vector>"),  # a folder without a floor
        ):
            with self.subTest(file=name, include=include):
                faults = self.faults({**above, name: f"// a comment\n#  include {include}\n"})
                self.assertEqual(len(faults), 1)
                self.assertTrue(faults[0].startswith(f"{name}:2 "), faults[0])


if __name__ == "__main__":
    unittest.main()
