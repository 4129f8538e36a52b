# SPDX-License-Identifier: MIT
"""Sums: what settings cost that weren't counted."""
import itertools
import unittest

from measure import Failure
from sums import Sums
from frames import setting_text

CHOICES = {"a": "123", "b": "12", "c": "1234", "d": "12"}
SCENE = {"name": "program", "parts": [["a", "b"], ["a", "c"], ["d"]],
         "knobs": [{"name": knob, "standard": "1"} for knob in CHOICES]}


def settings():
    return [dict(zip(CHOICES, chosen)) for chosen in itertools.product(*CHOICES.values())]


def cost(setting):
    """Two frames of two counts, each a sum over the parts, which are no sums over their knobs."""
    a, b, c, d = (int(setting[knob]) for knob in CHOICES)
    return [[1000 + a * b * b, 7 ** a + c], [a ** c + 3 * d, 5 * b % a + d * d]]


def counted_only(cost_of):
    """Costs of the settings in which only one part's knobs are turned."""
    def turned(setting):
        return {knob for knob in CHOICES if setting[knob] != "1"}

    return {setting_text(setting): cost_of(setting) for setting in settings()
            if any(turned(setting) <= set(part) for part in SCENE["parts"])}


class OfParts(unittest.TestCase):
    def test_every_setting_is_the_sum_of_its_parts(self):
        counted = counted_only(cost)
        self.assertLess(len(counted), len(settings()) // 2)
        sums = Sums(SCENE, counted)
        for setting in settings():
            self.assertEqual(sums.of(setting), cost(setting))

    def test_knobs_that_work_together_unnamed_are_found(self):
        def entangled(setting):
            return [[numbers[0] + int(setting["b"]) * int(setting["d"]), *numbers[1:]] for numbers in cost(setting)]

        setting = {"a": "1", "b": "2", "c": "1", "d": "2"}
        counted = {**counted_only(entangled), setting_text(setting): entangled(setting)}
        with self.assertRaisesRegex(Failure, "knobs that its scene doesn't name together"):
            Sums(SCENE, counted).check(setting, "core")
        counted[setting_text(setting)] = cost(setting)
        Sums(SCENE, counted_only(cost) | {setting_text(setting): cost(setting)}).check(setting, "core")

    def test_the_parts_of_a_setting_are_counted_ones(self):
        counted = counted_only(cost)
        for setting in settings():
            for part in Sums(SCENE, counted).parts_of(setting):
                self.assertIn(setting_text(part), counted)


if __name__ == "__main__":
    unittest.main()
