# SPDX-License-Identifier: MIT
"""What the report says of libfixmath in words, against the figures kept of it."""
import csv
import unittest

import peers

AMPLITUDE = 65536


def rows():
    with peers.BASELINE.open(newline='') as file:
        return list(csv.DictReader(file))


def worst(function, build, job='Sine, within one turn'):
    return max(float(row['worst']) for row in rows()
               if (row['function'], row['build'], row['job']) == (function, build, job))


class Peers(unittest.TestCase):
    def test_the_sine_keeps_its_claim_within_a_turn_and_the_fast_one_does_not(self):
        for build in ('package', 'cached', 'uncached'):
            self.assertLess(worst('fix16_sin', build) / AMPLITUDE, peers.CLAIMS['fix16_sin', build])
        self.assertGreater(worst('fix16_sin', 'fast') / AMPLITUDE, peers.CLAIMS['fix16_sin', 'fast'])

    def test_beyond_a_turn_the_error_grows(self):
        self.assertGreater(worst('fix16_sin', 'package', 'Sine, up to 5,215 turns'), 2 * worst('fix16_sin', 'package'))
        self.assertEqual(worst('SineTable256Linear', peers.OURS, 'Sine, up to 5,215 turns'),
                         worst('SineTable256Linear', peers.OURS))

    def test_the_table_of_libfixmath_is_more_accurate_than_our_default(self):
        self.assertLess(worst('fix16_sin', 'table'), worst('SineTable256Linear', peers.OURS))
        table, = {int(row['table_bytes']) for row in rows() if row['build'] == 'table'}
        self.assertAlmostEqual(table / 1024, 200, delta=1)

    def test_what_was_optimised_costs_less(self):
        costs = {(row['job'], row['load'], row['function'], row['build']): float(row['instructions']) for row in rows()}
        for (job, load, function, build), cost in costs.items():
            if build == 'package' and 'again' not in load:
                self.assertLess(costs[job, load, function, 'cached'], cost, function)

    def test_on_microcontrollers_its_square_root_is_the_cheaper_and_its_arc_tangent_the_dearer(self):
        for core in peers.ELSEWHERE:
            def cost(function, build, core=core):
                return max(float(row[core.name]) for row in rows() if (row['function'], row['build']) == (function, build))
            self.assertLess(cost('fix16_sqrt', 'cached'), cost('IsqrtNearest', peers.OURS))
            self.assertGreater(cost('fix16_atan2', 'uncached'), 3 * cost('ArcTangentTable128Linear', peers.OURS))

    def test_our_arc_tangent_is_the_more_accurate(self):
        job = 'Direction of a vector (atan2)'
        self.assertLess(100 * worst('ArcTangentTable128Linear', peers.OURS, job), worst('fix16_atan2', 'uncached', job))

    def test_the_page_names_every_function_and_marks_ours(self):
        page = peers.html_fragment(rows())
        for name in peers.FUNCTIONS.values():
            self.assertIn(f'<td>{name}</td>', page)
        self.assertIn('<b>SineTable256Linear</b>', page)

    def test_without_figures_it_says_so(self):
        self.assertIn("libfixmath-dev isn't installed", peers.html_fragment([]))


if __name__ == '__main__':
    unittest.main()
