# SPDX-License-Identifier: MIT
"""Counts out of callgrind's dumps."""
import unittest

import callgrind

LISTING = """
program:     file format elf64-x86-64

0000000000001000 <multiply>:
    1000:\timul   %rdi,%rsi
    1004:\tmull   (%rax)
    1006:\tpmuludq %xmm0,%xmm1
    100a:\tvpmaddwd %ymm0,%ymm1,%ymm2
    100e:\tmov    %rdi,%rax
    1011:\tidivl  0x8(%rsp)
    1015:\tdiv    %rcx
    1018:\tlea    0x0(,%rdi,8),%rax
    101c:\tcall   2000 <divide>
"""
DUMP = """# callgrind format
part: 1

positions: instr
events: Ir Dr Dw I1mr
summary: 46 5 3

ob=/program
fl=???
fn=main
cob=/library
cfn=divide
calls=1 0x2000
0x101c 12 1
0x101c 1
0x1000 20 2 1
0x1015 3

ob=/library
fl=???
fn=divide
0x1000 10 2 2
0x2011 12 1

totals: 46 5 3
"""


class Callgrind(unittest.TestCase):
    def test_what_multiplies_and_what_divides(self):
        self.assertEqual(callgrind.kinds_of(LISTING), {
            0x1000: callgrind.MULTIPLY, 0x1004: callgrind.MULTIPLY, 0x1006: callgrind.MULTIPLY,
            0x100a: callgrind.MULTIPLY, 0x1011: callgrind.DIVIDE, 0x1015: callgrind.DIVIDE})

    def test_each_object_has_its_own_addresses_and_callees_count_once(self):
        objects = {"/program": callgrind.kinds_of(LISTING), "/library": {0x2011: callgrind.DIVIDE}}
        self.assertEqual(callgrind.counts(DUMP, objects.__getitem__), (46, 5, 3, 20, 15))

    def test_a_dump_that_does_not_add_up_is_refused(self):
        with self.assertRaisesRegex(ValueError, "45, their total is 46"):
            callgrind.counts(DUMP.replace("0x1015 3", "0x1015 2"), lambda _: {})


if __name__ == "__main__":
    unittest.main()
