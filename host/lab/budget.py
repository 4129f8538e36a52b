# SPDX-License-Identifier: MIT
"""Does a program's frame fit into the time there is, and which knob makes it fit at the least loss of accuracy?

Answers from the shipped table of frames. The dearest frame has to fit. Cycles are modelled (cores.py) or so many an
instruction.
"""
import frames
from choose import core_of, one_of
from frames import Cost
from measure import Failure
from table import Row, Rows


def budget(rows: Rows, app: str, core: str, mhz: float, fps: float,
           cycles_per_instruction: float | None = None) -> tuple[bool, str]:
    """(whether it fits as it is, the answer in words)."""
    app = one_of(app, list(dict.fromkeys(row["app"] for row in rows)), "program")
    found = core_of(core)
    for name, number in (("--mhz", mhz), ("--fps", fps), ("--cycles-per-instruction", cycles_per_instruction)):
        if number is not None and not 0 < number < float("inf"):
            raise Failure(f"{name} is a number above 0")
    rivals = frames.of(rows, app, found.name)
    if not rivals:
        raise Failure(f"the table has no frames of {app} on {found.name}")

    def cycles(row: Row) -> float:
        return found.cycles(row) if cycles_per_instruction is None else (
            float(row["instructions"]) * cycles_per_instruction)

    room = mhz * 1e6 / fps
    how = "modelled" if cycles_per_instruction is None else f"{cycles_per_instruction:g} an instruction"
    standard = frames.standard_of(rivals)
    lines = [f"{app} on {found.title} at {mhz:g} MHz: {room:,.0f} cycles a frame at {fps:g} frames a second.",
             f"Its dearest frame: {int(standard['instructions']):,} instructions, {cycles(standard):,.0f} cycles "
             f"({how}){_error(standard, rivals)}."]
    fits = cycles(standard) <= room
    lines += (_fitting if fits else _too_dear)(rivals, cycles, room)
    return fits, "\n".join(lines)


def _error(row: Row, rivals: Rows) -> str:
    return f", {_accuracy(row)}" if len(rivals) > 1 else ""


def _accuracy(row: Row) -> str:
    return f"{float(row['error_mean']):.2f} CIE76 from the finest picture"


def _share(part: float, room: float) -> str:
    return f"{100 * part / room:.0f} %"


def _move(row: Row, standard: Row, cycles: Cost, room: float) -> str:
    spent = cycles(row)
    verdict = f"{_share(room - spent, room)} left" if spent <= room else f"{spent / room:.2f} times too much"
    return f"  {frames.changes(row, standard)}: {spent:,.0f} cycles, {verdict}, {_accuracy(row)}"


def _by_loss(found: Rows, cycles: Cost) -> Rows:
    return sorted(found, key=lambda row: (float(row["error_mean"]), cycles(row)))


def _fitting(rivals: Rows, cycles: Cost, room: float) -> list[str]:
    standard = frames.standard_of(rivals)
    lines = [f"It fits: {_share(room - cycles(standard), room)} of the time is left."]
    finer = _by_loss([row for row in rivals if cycles(row) <= room and
                      float(row["error_mean"]) < float(standard["error_mean"])], cycles)
    if finer:
        lines += ["There is room for more accuracy:", _move(finer[0], standard, cycles, room)]
    return lines


def _too_dear(rivals: Rows, cycles: Cost, room: float) -> list[str]:
    standard = frames.standard_of(rivals)
    lines = [f"It doesn't fit: {cycles(standard) / room:.2f} times as much as there is time for."]
    if len(rivals) == 1:
        return [*lines, "It has no knobs to turn."]
    single = _by_loss([row for moves in frames.alone(rivals).values() for _, row in moves], cycles)
    enough = [row for row in single if cycles(row) <= room]
    any_enough = _by_loss([row for row in rivals if cycles(row) <= room], cycles)
    if not any_enough:
        cheapest = min(rivals, key=cycles)
        return [*lines, "No setting of its knobs fits. The cheapest:", _move(cheapest, standard, cycles, room)]
    if enough:
        lines += ["One knob is enough:", *(_move(row, standard, cycles, room) for row in enough[:3])]
    else:
        cheaper = [row for row in single if cycles(row) < cycles(standard)]
        gains = sorted(cheaper, key=lambda row: _loss(row, standard) / (cycles(standard) - cycles(row)))
        lines += ["No knob is enough alone. Most cycles for the least loss:",
                  *(_move(row, standard, cycles, room) for row in gains[:2])]
    if not enough or float(any_enough[0]["error_mean"]) < float(enough[0]["error_mean"]):
        lines += ["The most accurate combination that fits:", _move(any_enough[0], standard, cycles, room)]
    return lines


def _loss(row: Row, standard: Row) -> float:
    return float(row["error_mean"]) - float(standard["error_mean"])
