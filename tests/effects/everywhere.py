# SPDX-License-Identifier: MIT
"""Every scene without each of the effects that it does not call for, whichever effect it was made for."""
import unittest

from ablation import disagreement
from scenes import CALLED, UNCALLED
from under_device import EFFECTS, run

SCENES = {scene.words for scenes in (UNCALLED, CALLED) for made in scenes.values() for scene in made}


class Everywhere(unittest.TestCase):
    def test_what_is_not_called_for_can_be_switched_off(self):
        judged = 0
        for words in sorted(SCENES):
            with_all = run(words)
            for effect in EFFECTS:
                if with_all.effects[effect]["called_for"]:
                    continue
                with self.subTest(words=words, effect=effect):
                    self.assertIsNone(disagreement(effect, with_all, run(words, without=(effect,))))
                judged += 1
        self.assertGreater(judged, 4 * len(SCENES))


if __name__ == "__main__":
    unittest.main(verbosity=2)
