# SPDX-License-Identifier: MIT
"""The cheapest rung that meets a bound on a core, from the measured table."""
import difflib
import re
import typing

import table
from cores import CORES, Core, core_called
from measure import Failure
from table import Row, Rows


def one_of(name: str, known: list[str], what: str) -> str:
    """`name` if it is known; else a Failure that says what is like it."""
    if name in known:
        return name
    like = difflib.get_close_matches(name, known, 1)
    named = ", ".join(f"'{each}'" for each in known)
    raise Failure(f"no {what} '{name}'; " + (f"did you mean '{like[0]}'?" if like else f"there are {named}"))


def core_of(name: str) -> Core:
    """The core of that name; a Failure if there is none."""
    return core_called(name) or CORES[one_of(name, list(CORES), "core")]


def parsed_error(text: str, unit: str) -> float:
    """The number in `2lsb`, `0.5` or `12ppm`; the unit, if any, must be how the family's unit begins or one of its
    words."""
    match = re.fullmatch(r"\s*(\d+(?:\.\d*)?|\.\d+)\s*(.*?)\s*", text)
    if match is None:
        raise Failure(f"--error is a number and perhaps a unit, like 2lsb, not '{text}'")
    words = [word.rstrip("s") for word in unit.split() if word[0].isalpha() and word not in ("of", "the", "per")]
    given = match[2]
    if given and not unit.startswith(given) and given.rstrip("s") not in words:
        raise Failure(f"errors of this family are in '{unit}', not in '{given}'")
    return float(match[1])


def _within(rows: Rows, wanted: float) -> Rows:
    return [row for row in rows if float(row["bound"]) <= wanted]


def _cheapest(rows: Rows) -> Row:
    return min(rows, key=lambda row: (float(row["instructions"]), float(row["bound"])))


class Answer(typing.NamedTuple):
    """What was chosen under a load, and what matters beside it."""
    chosen: Row
    rivals: Rows  # the rows that compete: of the load
    loads: list[str]  # of the family
    elsewhere: Rows  # the chosen rung's rows of other loads under which it isn't within the error asked for
    anywhere: Row | None  # the cheapest that is within it under every load, if that is another and no load was asked for


def choose(rows: Rows, family: str, core: str, error: str, load: str | None = None) -> Answer:
    """The answer for a family on a core; a Failure names the best there is if no rung meets the bound."""
    family = one_of(family, sorted({row["family"] for row in rows}), "family")
    of_core = [row for row in rows if row["family"] == family and row["core"] == core_of(core).name]
    loads = list(dict.fromkeys(row["metric"] for row in of_core))
    asked, load = load, loads[0] if load is None else one_of(load, loads, "load")
    rivals = [row for row in of_core if row["metric"] == load]
    wanted = parsed_error(error, rivals[0]["unit"])
    meeting = _within(rivals, wanted)
    if not meeting:
        best = min(rivals, key=lambda row: (float(row["bound"]), float(row["instructions"])))
        raise Failure(f"no rung of {family} is that accurate; the best is {best['rung']}, {_error(best)}")
    chosen = _cheapest(meeting)
    elsewhere = [row for row in of_core if row["rung"] == chosen["rung"] and not _within([row], wanted)]
    within = [row["rung"] for row in _within(of_core, wanted)]
    always = [row for row in meeting if within.count(row["rung"]) == len(loads)]
    anywhere = _cheapest(always) if elsewhere and always and asked is None else None
    return Answer(chosen, rivals, loads, [] if asked else elsewhere, anywhere)


def described(answer: Answer, domains: dict[str, str] | None = None) -> str:
    """An answer in words: the rung, what a step up or down the staircase would cost or save, and under which loads it is
    less accurate. `domains`: which inputs a rung takes, where it isn't all."""
    def figures(row: Row) -> str:
        return (f"{row['rung']}: {_error(row)}, {row['instructions']} instructions, "
                f"{row['code_bytes']} bytes of code, {row['table_bytes']} of tables" +
                (f"; for {domains[row['rung']]}" if domains and domains.get(row["rung"]) else ""))

    chosen = answer.chosen
    lines = [figures(chosen)]
    stairs = table.front(answer.rivals)
    cheaper = [row for row in stairs if float(row["instructions"]) < float(chosen["instructions"])]
    finer = [row for row in stairs if float(row["bound"]) < float(chosen["bound"])]
    if cheaper:
        lines.append("  cheaper: " + figures(cheaper[-1]))
    if finer:
        lines.append("  finer:   " + figures(finer[0]))
    if len(answer.loads) > 1:
        lines.append(f"  under the load '{chosen['metric']}'; others (--load): " +
                     ", ".join(f"'{load}'" for load in answer.loads if load != chosen["metric"]))
    lines += [f"  under '{row['metric']}' it is off by more: {_error(row)}" for row in answer.elsewhere]
    if answer.anywhere:
        lines.append("  under all of them: " + figures(answer.anywhere))
    return "\n".join(lines)


def _error(row: Row) -> str:
    return "exact" if float(row["bound"]) == 0 else f"at most {float(row['bound']):,.7g} {row['unit']}"
