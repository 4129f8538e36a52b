# SPDX-License-Identifier: MIT
"""The table of the accuracy lab: rows of accuracy.csv, who dominates whom, and comparison with a baseline."""
import csv
from pathlib import Path

# A line of a table: texts by the columns' names.
Row = dict[str, str]
Rows = list[Row]

COLUMNS = ["family", "rung", "core", "metric", "unit", "bound", "worst", "mean", "instructions", "loads", "stores",
           "multiplies", "divides", "code_bytes", "table_bytes", "stack_bytes", "worst_input", "dominated_by"]
TOLERANCE = 1.01  # how much more instructions than in the baseline are no growth


def _text(number: float) -> str:
    return f"{number:.6g}" if number != int(number) or abs(number) >= 1e6 else str(int(number))


def rows_of(all_families: dict[str, dict], costs: dict[tuple, dict], errors: dict[tuple, dict]) -> Rows:
    """All rows, as dicts from column to text; `metric` is the load. Beside the columns each has `loop`, what the loop
    around the rung costs, which was subtracted."""
    rows = []
    for (family, load, rung, core), cost in costs.items():
        described = all_families[family]
        index = [entry["name"] for entry in described["loads"]].index(load)
        of_rung = next(entry for entry in described["rungs"] if entry["name"] == rung)
        error = errors[family, load, rung]
        rows.append({
            "family": family, "rung": rung, "core": core, "metric": load, "unit": of_rung["unit"],
            "bound": _text(of_rung["bounds"][index]), "worst": _text(error["worst"]), "mean": _text(error["mean"]),
            **{name: f"{cost[name]:.2f}" for name in ("instructions", "loads", "stores", "multiplies", "divides")},
            **{name: str(cost[name]) for name in ("code_bytes", "table_bytes", "stack_bytes")},
            "worst_input": error["worst_input"], "loop": cost["loop_instructions"]})
    note_dominated(rows)
    return rows


def groups(rows: Rows) -> dict[tuple[str, str, str], Rows]:
    """Rows that compete: of one family, core and load."""
    grouped: dict[tuple[str, str, str], Rows] = {}
    for row in rows:
        grouped.setdefault((row["family"], row["core"], row["metric"]), []).append(row)
    return grouped


def note_dominated(rows: Rows) -> None:
    """Fills `dominated_by`: the cheapest rung that is no dearer and no less accurate, and better in one of both."""
    for rivals in groups(rows).values():
        points = [(float(row["instructions"]), float(row["worst"])) for row in rivals]
        for row, (cost, error) in zip(rivals, points):
            better = [(other_cost, other["rung"]) for other, (other_cost, other_error) in zip(rivals, points)
                      if other_cost <= cost and other_error <= error and (other_cost, other_error) != (cost, error)]
            row["dominated_by"] = min(better)[1] if better else ""


def front(rivals: Rows) -> Rows:
    """The rows that no other dominates, cheapest first."""
    return sorted((row for row in rivals if not row["dominated_by"]), key=lambda row: float(row["instructions"]))


def write(path: Path, rows: Rows) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("w", newline="") as file:
        table = csv.DictWriter(file, COLUMNS, lineterminator="\n", extrasaction="ignore")
        table.writeheader()
        table.writerows(rows)


def read(path: Path) -> Rows:
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


def key_of(row: Row) -> tuple[str, str, str, str]:
    return row["family"], row["metric"], row["rung"], row["core"]


def above_bound(rows: Rows) -> list[str]:
    """What is wrong with rows whose error is above the stated bound; each error once, not once a core."""
    said: dict[tuple[str, ...], str] = {}
    for row in rows:
        if float(row["worst"]) > float(row["bound"]) * (1 + 1e-9):
            said.setdefault(key_of(row)[:3], f"{row['family']}, {row['rung']}, '{row['metric']}': an error of "
                            f"{row['worst']} {row['unit']} at {row['worst_input']}, the stated bound is {row['bound']}")
    return list(said.values())


def loose(rows: Rows, all_families: dict[str, dict]) -> list[str]:
    """Bounds more than twice the worst error, of rungs that don't say why."""
    said: dict[tuple[str, ...], str] = {}
    for row in rows:
        slack = next(rung["slack"] for rung in all_families[row["family"]]["rungs"] if rung["name"] == row["rung"])
        if not slack and float(row["worst"]) * 2 < float(row["bound"]):
            said.setdefault(key_of(row)[:3], f"{row['family']}, {row['rung']}, '{row['metric']}': the bound "
                            f"{row['bound']} is more than twice the worst error, {row['worst']}, and nothing says why")
    return list(said.values())


def useless_defaults(rows: Rows, all_families: dict[str, dict]) -> list[str]:
    """Defaults that are dominated on every core under every load."""
    found = []
    for family in all_families.values():
        of_default = [row for row in rows if row["family"] == family["name"] and row["rung"] == family["default"]]
        if of_default and all(row["dominated_by"] for row in of_default):
            found.append(f"{family['name']}: the default {family['default']} is dominated everywhere")
    return found


def grown(rows: Rows, baseline: Rows) -> list[str]:
    """Counts that have grown, and rows that the baseline lacks or has beside these."""
    before = {key_of(row): row for row in baseline}
    now = {key_of(row): row for row in rows}
    found = [f"{' '.join(key)}: not in the baseline" for key in now if key not in before]
    found += [f"{' '.join(key)}: in the baseline, but not measured" for key in before if key not in now]
    for key, row in now.items():
        if key in before and float(row["instructions"]) > float(before[key]["instructions"]) * TOLERANCE + 0.005:
            found.append(f"{' '.join(key)}: {row['instructions']} instructions, the baseline has "
                         f"{before[key]['instructions']}")
    return found
