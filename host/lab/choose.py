# SPDX-License-Identifier: MIT
"""The cheapest rung that meets a bound on a core, from the measured table."""
import difflib
import re

import table
from cores import CORES, core_called
from measure import Failure


def one_of(name, known, what):
    """`name` if it is known; else a Failure that says what is like it."""
    if name in known:
        return name
    like = difflib.get_close_matches(name, known, 1)
    raise Failure(f"no {what} '{name}'; " + (f"did you mean '{like[0]}'?" if like else f"there are {', '.join(known)}"))


def parsed_error(text, unit):
    """The number in `2lsb`, `0.5` or `12ppm`; the unit, if any, must be how the family's unit begins or one of its
    words."""
    match = re.fullmatch(r"\s*(\d+(?:\.\d*)?|\.\d+)\s*(.*?)\s*", text)
    if match is None:
        raise Failure(f"--error is a number and perhaps a unit, like 2lsb, not '{text}'")
    words = unit.replace("1/65536 ", "").split()
    given = match[2]
    if given and not unit.startswith(given) and given.rstrip("s") not in [word.rstrip("s") for word in words]:
        raise Failure(f"errors of this family are in '{unit}', not in '{given}'")
    return float(match[1])


def choose(rows, family, core, error, load=None):
    """(chosen row, all rows that compete) of a family on a core; a Failure names the best there is if none does."""
    family = one_of(family, sorted({row["family"] for row in rows}), "family")
    found = core_called(core)
    if found is None:
        one_of(core, list(CORES), "core")
    rivals = [row for row in rows if row["family"] == family and row["core"] == found.name]
    loads = list(dict.fromkeys(row["metric"] for row in rivals))
    load = loads[0] if load is None else one_of(load, loads, "load")
    rivals = [row for row in rivals if row["metric"] == load]
    wanted = parsed_error(error, rivals[0]["unit"])
    meeting = [row for row in rivals if float(row["bound"]) <= wanted]
    if not meeting:
        best = min(rivals, key=lambda row: (float(row["bound"]), float(row["instructions"])))
        raise Failure(f"no rung of {family} is that accurate; the best is {best['rung']}, {best['bound']} {best['unit']}")
    return min(meeting, key=lambda row: (float(row["instructions"]), float(row["bound"]))), rivals


def described(chosen, rivals, domains=None):
    """An answer in words: the rung, and what a step up or down the staircase would cost or save. `domains`: which inputs a
    rung takes, where it isn't all."""
    def figures(row):
        error = "exact" if float(row["bound"]) == 0 else f"at most {row['bound']} {row['unit']}"
        return (f"{row['rung']}: {error}, {row['instructions']} instructions, "
                f"{row['code_bytes']} bytes of code, {row['table_bytes']} of tables" +
                (f"; for {domains[row['rung']]}" if domains and domains.get(row["rung"]) else ""))

    lines = [figures(chosen)]
    stairs = table.front(rivals)
    cheaper = [row for row in stairs if float(row["instructions"]) < float(chosen["instructions"])]
    finer = [row for row in stairs if float(row["bound"]) < float(chosen["bound"])]
    if cheaper:
        lines.append("  cheaper: " + figures(cheaper[-1]))
    if finer:
        lines.append("  finer:   " + figures(finer[0]))
    return "\n".join(lines)
