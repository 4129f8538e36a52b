# SPDX-License-Identifier: MIT
"""Budgets: what fits, what makes it fit, and that the shipped table answers for every program and core."""
import unittest

import budget
import frames
from cores import CORES
from measure import Failure


def row(setting, instructions, error, core="cortex-m7", app="gauges"):
    return {"app": app, "setting": setting, "core": core, "frame": "15", "instructions": str(instructions), "loads": "0",
            "stores": "0", "multiplies": "0", "divides": "0", "mean_instructions": str(instructions),
            "stack_bytes": "0", "error_mean": str(error), "error_worst": "0", "wrong_ppm": "0"}


# At 1 MHz and 1 frame a second there are 1,000,000 cycles; the core's model adds none to instructions.
ROWS = [row("a=2 b=2", 2_000_000, 0.3), row("a=1 b=2", 900_000, 1.0), row("a=0 b=2", 500_000, 3.0),
        row("a=2 b=1", 1_500_000, 0.5), row("a=2 b=3", 2_500_000, 0.1), row("a=1 b=1", 400_000, 1.2),
        row("a=1 b=3", 950_000, 0.8), row("standard", 700, 0.0, app="map")]


class Budget(unittest.TestCase):
    def ask(self, mhz=1.0, fps=1.0, rows=None, app="gauges", core="cortex-m7", **more):
        return budget.budget(ROWS if rows is None else rows, app, core, mhz, fps, **more)

    def test_what_fits_says_how_much_is_left_and_what_for(self):
        fits, text = self.ask(mhz=4)
        self.assertTrue(fits)
        self.assertIn("50 % of the time is left", text)
        self.assertIn("b = 3: 2,500,000 cycles", text)

    def test_one_knob_that_is_enough_comes_with_the_least_loss_first(self):
        fits, text = self.ask()
        self.assertFalse(fits)
        self.assertIn("2.00 times as much", text)
        self.assertLess(text.index("a = 1: 900,000"), text.index("a = 0: 500,000"))

    def test_a_combination_that_loses_less_is_named_too(self):
        self.assertIn("a = 1, b = 3: 950,000 cycles, 5 % left", self.ask()[1])

    def test_where_no_knob_is_enough_alone_a_combination_is_named(self):
        _, text = self.ask(mhz=0.45)
        self.assertIn("No knob is enough alone", text)
        self.assertIn("a = 1, b = 1: 400,000 cycles", text)

    def test_where_nothing_fits_the_cheapest_says_by_what_factor(self):
        _, text = self.ask(mhz=0.2)
        self.assertIn("No setting of its knobs fits", text)
        self.assertIn("400,000 cycles, 2.00 times too much", text)

    def test_exactly_as_much_as_there_is_fits(self):
        self.assertTrue(self.ask(mhz=2)[0])
        self.assertFalse(self.ask(mhz=1.999999)[0])

    def test_cycles_an_instruction_replace_the_model(self):
        self.assertTrue(self.ask(mhz=3, cycles_per_instruction=1.5)[0])
        self.assertFalse(self.ask(mhz=3, cycles_per_instruction=1.6)[0])

    def test_a_program_without_knobs(self):
        self.assertIn("no knobs", self.ask(app="map", fps=2000)[1])
        self.assertTrue(self.ask(app="map")[0])

    def test_what_there_isnt_is_said_in_words(self):
        for more in ({"app": "gauge"}, {"core": "z80"}, {"mhz": 0}, {"mhz": -1}, {"fps": 0}, {"fps": float("inf")},
                     {"cycles_per_instruction": float("nan")}):
            with self.assertRaises(Failure):
                self.ask(**more)
        with self.assertRaisesRegex(Failure, "did you mean 'gauges'"):
            self.ask(app="gauge")

    def test_the_shipped_table_answers_for_all(self):
        rows = frames.read()
        apps = {entry["app"] for entry in rows}
        self.assertEqual(apps, {"gauges", "map", "primitives", "testcard"})
        for app in apps:
            for core in [*CORES, "cortex-m0"]:
                for mhz in (0.001, 50, 1e6):
                    _, text = budget.budget(rows, app, core, mhz, 30)
                    self.assertIn(app, text)


class Frames(unittest.TestCase):
    def test_the_front_holds_what_none_beats(self):
        front = [entry["setting"] for entry in frames.front(ROWS[:-1])]
        self.assertEqual(front, ["a=1 b=1", "a=1 b=2", "a=1 b=3", "a=2 b=1", "a=2 b=2", "a=2 b=3"])

    def test_growth_and_other_pictures_are_found(self):
        self.assertEqual(frames.grown(ROWS, ROWS), [])
        self.assertEqual(len(frames.grown([row("a=2 b=2", 2_030_000, 0.3)], ROWS[:1])), 2)
        self.assertEqual(len(frames.grown([row("a=2 b=2", 2_000_000, 0.31)], ROWS[:1])), 1)
        self.assertEqual(len(frames.grown(ROWS, ROWS[1:])), 1)
        self.assertEqual(len(frames.grown(ROWS[1:], ROWS)), 1)

    def test_knobs_alone(self):
        moves = frames.alone(ROWS[:-1])
        self.assertEqual({knob: [choice for choice, _ in rows] for knob, rows in moves.items()},
                         {"a": ["1", "0"], "b": ["1", "3"]})


if __name__ == "__main__":
    unittest.main()
