# SPDX-License-Identifier: MIT
"""Answers of `intaglio-lab choose`, and of README.md's table, over a made-up baseline."""
import unittest

import choose
import summary
import table
from measure import Failure


def row(rung, core, instructions, bound, metric="any", worst=None):
    return {"family": "root", "rung": rung, "core": core, "metric": metric, "unit": "lsb of 2^-15", "bound": str(bound),
            "worst": str(bound if worst is None else worst), "instructions": str(instructions), "code_bytes": "10",
            "table_bytes": "0"}


def rows():
    made = [row("Table", "cortex-m0plus", 20, 100), row("Bits", "cortex-m0plus", 120, 0),
            row("Newton", "cortex-m0plus", 480, 0), row("Table", "cortex-m3", 10, 100), row("Bits", "cortex-m3", 130, 0),
            row("Newton", "cortex-m3", 37, 0), row("Table", "cortex-m3", 11, 50, metric="small"),
            row("Bits", "cortex-m3", 60, 0, metric="small")]
    table.note_dominated(made)
    return made


class ChooseTest(unittest.TestCase):
    def chosen(self, core, error, load=None):
        return choose.choose(rows(), "root", core, error, load).chosen["rung"]

    def test_the_cheapest_within_the_bound(self):
        self.assertEqual(self.chosen("cortex-m3", "100"), "Table")
        self.assertEqual(self.chosen("cortex-m3", "99.9"), "Newton")
        self.assertEqual(self.chosen("cortex-m0plus", "0"), "Bits")

    def test_an_m0_is_counted_as_an_m0plus(self):
        self.assertEqual(self.chosen("cortex-m0", "0lsb"), "Bits")

    def test_the_load_asked_for(self):
        self.assertEqual(self.chosen("cortex-m3", "50", "small"), "Table")
        self.assertEqual(self.chosen("cortex-m3", "50"), "Newton")

    def test_the_bound_counts_not_what_was_found(self):
        lucky = [row("Lucky", "cortex-m3", 5, 10, worst=0), row("Exact", "cortex-m3", 50, 0)]
        table.note_dominated(lucky)
        self.assertEqual(choose.choose(lucky, "root", "cortex-m3", "0").chosen["rung"], "Exact")

    def test_no_rung_that_accurate_names_the_best(self):
        coarse = [entry for entry in rows() if entry["rung"] == "Table"]
        with self.assertRaisesRegex(Failure, "the best is Table, at most 100 lsb"):
            choose.choose(coarse, "root", "cortex-m3", "3")

    def test_a_name_written_wrongly_is_told_what_is_like_it(self):
        with self.assertRaisesRegex(Failure, "no family 'roots'; did you mean 'root'"):
            choose.choose(rows(), "roots", "cortex-m3", "0")
        with self.assertRaisesRegex(Failure, "no core 'cortex-m33'; did you mean 'cortex-m3'"):
            choose.choose(rows(), "root", "cortex-m33", "0")
        with self.assertRaisesRegex(Failure, "no load 'smal'; did you mean 'small'"):
            choose.choose(rows(), "root", "cortex-m3", "0", "smal")

    def test_errors_in_another_unit_are_refused(self):
        for text in ("2px", "two", "-1", "1e", "2of"):
            with self.subTest(text), self.assertRaises(Failure):
                choose.choose(rows(), "root", "cortex-m3", text)

    def test_the_answer_says_what_a_step_up_or_down_costs(self):
        text = choose.described(choose.choose(rows(), "root", "cortex-m3", "0"))
        self.assertRegex(text, "^Newton: exact, 37 instructions")
        self.assertRegex(text, "cheaper: Table: at most 100 lsb")

    def test_an_answer_that_holds_under_one_load_says_so(self):
        changing = [row("Fast", "cortex-m3", 5, 0, metric="whole"), row("Fast", "cortex-m3", 5, 7, metric="any"),
                    row("Sure", "cortex-m3", 9, 0, metric="whole"), row("Sure", "cortex-m3", 9, 0, metric="any")]
        table.note_dominated(changing)
        text = choose.described(choose.choose(changing, "root", "cortex-m3", "1"))
        self.assertRegex(text, "(?s)^Fast: exact.*under the load 'whole'; others [(]--load[)]: 'any'.*"
                               "under 'any' it is off by more: at most 7 lsb.*under all of them: Sure: exact")
        text = choose.described(choose.choose(changing, "root", "cortex-m3", "1", "whole"))
        self.assertNotIn("off by more", text)
        text = choose.described(choose.choose(changing, "root", "cortex-m3", "7"))
        self.assertNotIn("off by more", text)


class SummaryTest(unittest.TestCase):
    def test_ways_equally_good_that_change_places(self):
        self.assertEqual(summary.turning(rows()),
                         [("root", "exact", "Bits", "Newton", {"Bits": (120.0, 130.0), "Newton": (480.0, 37.0)})])

    def test_the_table_marks_where_the_cores_differ(self):
        family = {"root": {"default": "Bits", "per": "call"}}
        self.assertEqual(summary.table(rows(), family), [["root", "any", "exact", "Bits 120", "**Newton 37**"]])

    def test_the_table_says_what_a_cost_is_of_if_not_of_a_call(self):
        family = {"root": {"default": "Table", "per": "pixel"}}
        self.assertEqual(summary.table(rows(), family),
                         [["root", "any", "100 lsb of 2^-15", "Table 20 a pixel", "Table 10 a pixel"]])


if __name__ == "__main__":
    unittest.main()
