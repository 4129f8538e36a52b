# SPDX-License-Identifier: MIT
"""The lab's table and the choices from it: who dominates whom, what is said of loose bounds, of growth, of rows that came
or went, and what the library is given.
"""
import tempfile
import unittest
from pathlib import Path

import choose
import shipped
import table
from cores import CORES
from measure import Failure


def row(rung, instructions, worst, **others):
    return {**dict.fromkeys(table.COLUMNS, '0'), 'family': 'sine', 'rung': rung, 'core': 'cortex-m3', 'metric': 'any angle',
            'unit': 'lsb', 'bound': str(worst), 'worst': str(worst), 'instructions': str(instructions),
            'worst_input': '-17', 'dominated_by': '', **others}


def family(*rungs, default='A', slack=''):
    return {'sine': {'name': 'sine', 'default': default,
                     'rungs': [{'name': rung, 'slack': slack} for rung in rungs]}}


class Dominance(unittest.TestCase):
    def dominated(self, *rows):
        table.note_dominated(rows)
        return [each['dominated_by'] for each in rows]

    def test_dearer_and_less_accurate(self):
        self.assertEqual(self.dominated(row('A', 10, 1), row('B', 20, 2)), ['', 'A'])

    def test_as_dear_but_less_accurate_or_the_other_way_round(self):
        self.assertEqual(self.dominated(row('A', 10, 1), row('B', 10, 2), row('C', 11, 1)), ['', 'A', 'A'])

    def test_equals_do_not_dominate_each_other(self):
        self.assertEqual(self.dominated(row('A', 10, 1), row('B', 10, 1)), ['', ''])

    def test_a_trade_is_no_dominance(self):
        self.assertEqual(self.dominated(row('A', 10, 2), row('B', 20, 1)), ['', ''])

    def test_the_cheapest_of_those_that_dominate_is_named(self):
        self.assertEqual(self.dominated(row('A', 12, 0), row('B', 10, 1), row('C', 20, 2))[2], 'B')

    def test_other_cores_and_loads_do_not_compete(self):
        self.assertEqual(self.dominated(row('A', 10, 1), row('B', 20, 2, core='arm926'), row('C', 20, 2, metric='small')),
                         ['', '', ''])

    def test_the_front_is_cheapest_first(self):
        rows = [row('A', 30, 0), row('B', 10, 2), row('C', 20, 3)]
        table.note_dominated(rows)
        self.assertEqual([each['rung'] for each in table.front(rows)], ['B', 'A'])


class Bounds(unittest.TestCase):
    def test_an_error_above_its_bound_is_said_once_with_its_input(self):
        rows = [row('A', 10, 1.5, bound='1', core=core) for core in ('cortex-m3', 'arm926')]
        said, = table.above_bound(rows)
        for part in ('sine', 'A', '1.5', '-17', 'bound is 1'):
            self.assertIn(part, said)

    def test_an_error_at_its_bound_is_none(self):
        self.assertEqual(table.above_bound([row('A', 10, 1.001), row('B', 10, 0)]), [])

    def test_more_than_twice_is_loose(self):
        said, = table.loose([row('A', 10, 0.49, bound='1'), row('B', 10, 0.5, bound='1')], family('A', 'B'))
        self.assertIn('A', said)

    def test_a_reason_excuses(self):
        self.assertEqual(table.loose([row('A', 10, 0.1, bound='1')], family('A', slack='it is proven, not met')), [])

    def test_a_default_may_be_dominated_somewhere_but_not_everywhere(self):
        rows = [row('A', 20, 1), row('B', 10, 1), row('A', 10, 1, core='arm926'), row('B', 20, 1, core='arm926')]
        table.note_dominated(rows)
        self.assertEqual(table.useless_defaults(rows, family('A', 'B')), [])
        table.note_dominated(rows[:2])
        self.assertEqual(len(table.useless_defaults(rows[:2], family('A', 'B'))), 1)


class Growth(unittest.TestCase):
    def test_above_one_percent_is_said_with_both_figures(self):
        said, = table.grown([row('A', '101.10', 1)], [row('A', '100.00', 1)])
        for part in ('sine', 'A', 'cortex-m3', '101.10', '100.00'):
            self.assertIn(part, said)

    def test_one_percent_and_less_is_none(self):
        for now in ('101.00', '100.00', '50.00'):
            self.assertEqual(table.grown([row('A', now, 1)], [row('A', '100.00', 1)]), [])

    def test_rows_that_came_or_went_are_named(self):
        said = table.grown([row('A', 1, 1)], [row('B', 1, 1)])
        self.assertEqual(len(said), 2)
        self.assertIn('sine any angle A cortex-m3: not in the baseline', said)
        self.assertIn('sine any angle B cortex-m3: in the baseline, but not measured', said)


class Files(unittest.TestCase):
    def test_what_is_written_is_read_again(self):
        rows = [row('A', 10, 1, metric='near, far'), row('B<1, 2>', 10, 1)]
        with tempfile.TemporaryDirectory() as folder:
            table.write(Path(folder) / 'new/rows.csv', rows)
            self.assertEqual(table.read(Path(folder) / 'new/rows.csv'), rows)


class Shipped(unittest.TestCase):
    rows = [row(rung, instructions, 1, core=core, metric=load)
            for core in CORES for load in ('any angle', 'small') for rung, instructions in (('A', '12.34'), ('B', '-0.5'))]

    def test_hundredths_under_the_first_load(self):
        text = shipped.text([{**each, 'instructions': '99'} if each['metric'] == 'small' else each for each in self.rows])
        self.assertIn('{"sine", "A", {' + ', '.join(['1234'] * len(CORES)) + '}},', text)
        self.assertNotIn('9900', text)

    def test_what_costs_less_than_nothing_costs_nothing(self):
        self.assertIn('{"sine", "B", {' + ', '.join(['0'] * len(CORES)) + '}},', shipped.text(self.rows))

    def test_a_core_that_lacks_is_named(self):
        with self.assertRaisesRegex(Failure, 'sine, A.*arm926'):
            shipped.text([each for each in self.rows if each['core'] != 'arm926'])


class Choice(unittest.TestCase):
    rows = [row('Coarse', 10, 4), row('Fine', 20, 1), row('Finest', 30, 0.5), row('Fine', 5, 1, core='arm926'),
            row('Coarse', 10, 4, core='arm926'), row('Finest', 30, 0.5, core='arm926')]

    def chosen(self, error, core='cortex-m3'):
        return choose.choose(self.rows, 'sine', core, error).chosen['rung']

    def test_the_cheapest_that_meets_the_bound(self):
        self.assertEqual(self.chosen('4lsb'), 'Coarse')
        self.assertEqual(self.chosen('3.9lsb'), 'Fine')
        self.assertEqual(self.chosen('4lsb', 'arm926'), 'Fine')

    def test_a_bound_that_none_meets_names_the_best(self):
        with self.assertRaisesRegex(Failure, 'Finest, at most 0.5 lsb'):
            self.chosen('0.4lsb')

    def test_another_unit_is_refused(self):
        with self.assertRaisesRegex(Failure, "'lsb', not in 'ppm'"):
            self.chosen('4ppm')

    def test_what_there_is_none_of_is_said_with_what_is_like_it(self):
        with self.assertRaisesRegex(Failure, "did you mean 'sine'"):
            choose.choose(self.rows, 'sin', 'cortex-m3', '1')
        with self.assertRaisesRegex(Failure, "did you mean 'cortex-m3'"):
            choose.choose(self.rows, 'sine', 'cortexm3', '1')


if __name__ == '__main__':
    unittest.main()
