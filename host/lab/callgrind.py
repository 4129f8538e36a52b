# SPDX-License-Identifier: MIT
"""What one dump of callgrind's counts, in the order of measure.COUNTED.

Callgrind tells instructions, loads and stores. How many of them multiply or divide follows from its counts of each
instruction (--dump-instr=yes) and the disassembly of the objects that they lie in. A SIMD instruction that multiplies
several numbers counts once, as any.
"""
import re
from typing import Callable

MULTIPLY, DIVIDE = range(2)
_KINDS = ((re.compile(r"v?p?i?mul|v?pmadd"), MULTIPLY), (re.compile(r"i?div"), DIVIDE))
# Dumps that counts() can read.
OPTIONS = ("--cache-sim=yes", "--dump-instr=yes", "--dump-line=no", "--compress-strings=no", "--compress-pos=no")


def kinds_of(listing: str) -> dict[int, int]:
    """Where the instructions are that multiply and divide, from what `objdump -d --no-show-raw-insn` says."""
    found = {}
    for address, name in re.findall(r"^ *([0-9a-f]+):\t([a-z]\w*)", listing, re.MULTILINE):
        for pattern, kind in _KINDS:
            if pattern.match(name):
                found[int(address, 16)] = kind
    return found


def counts(dump: str, kinds_in: Callable[[str], dict[int, int]]) -> tuple[int, ...]:
    """(instructions, loads, stores, multiplies, divides). `kinds_in(object)`: as kinds_of() says it of an object file."""
    (instructions, loads, stores), = re.findall(r"^totals: (\d+) (\d+) (\d+)", dump, re.MULTILINE)
    special = [0, 0]
    kinds: dict[int, int] = {}
    seen, of_callee = 0, False
    for line in dump.splitlines():
        if line.startswith("0x"):
            # The line after `calls=` says what the callee took, which stands at the callee's own instructions, too.
            if not of_callee:
                address, count, *_ = line.split()
                seen += int(count)
                kind = kinds.get(int(address, 16))
                if kind is not None:
                    special[kind] += int(count)
            of_callee = False
        elif line.startswith("ob="):
            kinds = kinds_in(line.removeprefix("ob="))
        elif line.startswith("calls="):
            of_callee = True
    if seen != int(instructions):
        raise ValueError(f"callgrind's instructions are {seen}, their total is {instructions}")
    return (int(instructions), int(loads), int(stores), *special)
