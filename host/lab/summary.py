# SPDX-License-Identifier: MIT
"""What README.md shows of the lab: for each job the cheapest way that is as accurate as the library's own, on a core
without a divider and on one with it; and where two ways change places between these cores."""
from table import Row, Rows

WITHOUT, WITH = "cortex-m0plus", "cortex-m3"


def _by_job(rows: Rows) -> dict[str, dict[str, Rows]]:
    """Rows of both cores under a family's first load: {family: {core: [rows]}}."""
    first: dict[str, str] = {}
    jobs: dict[str, dict[str, Rows]] = {}
    for row in rows:
        if row["core"] in (WITHOUT, WITH) and row["metric"] == first.setdefault(row["family"], row["metric"]):
            jobs.setdefault(row["family"], {}).setdefault(row["core"], []).append(row)
    return jobs


def cheapest(rivals: Rows, error: float) -> Row:
    """The cheapest of these rows that promises to be off by no more than `error`."""
    return min((row for row in rivals if float(row["bound"]) <= error), key=lambda row: float(row["instructions"]))


def exact_or(error: float, unit: str) -> str:
    return "exact" if error == 0 else f"{error:.3g} {unit}"


def turning(rows: Rows, factor: float = 1.25) -> list[tuple]:
    """Jobs whose two ways change places: [(family, error in words, on WITHOUT the cheaper way, on WITH the cheaper way,
    {way: (cost without, cost with)})], those that change most first."""
    found = []
    for family, cores in _by_job(rows).items():
        costs = {row["rung"]: (float(row["instructions"]), float(other["instructions"]), float(row["worst"]), row["unit"])
                 for row in cores.get(WITHOUT, []) for other in cores.get(WITH, []) if other["rung"] == row["rung"]}
        pairs = []
        for a, (a_without, a_with, a_error, unit) in costs.items():
            for b, (b_without, b_with, b_error, _) in costs.items():
                if a_error != b_error or min(a_without, a_with, b_without, b_with) <= 0:
                    continue  # only ways that are equally good are compared
                gain = min(b_without / a_without, a_with / b_with)
                if gain >= factor:
                    pairs.append((gain, a, b, exact_or(a_error, unit)))
        if pairs:
            gain, a, b, error = max(pairs)
            found.append((gain, family, error, a, b, {way: costs[way][:2] for way in (a, b)}))
    return [entry[1:] for entry in sorted(found, reverse=True)]


def table(rows: Rows, families: dict[str, dict]) -> list[list[str]]:
    """Lines (job, load, error, cheapest without a divider, cheapest with it), those that differ first. `families`: as in
    the baseline's families.json."""
    lines = []
    for family, cores in _by_job(rows).items():
        default = next(row for row in cores[WITHOUT] if row["rung"] == families[family]["default"])
        error = float(default["bound"])
        per = families[family]["per"]
        without, with_divider = (cheapest(cores[core], error) for core in (WITHOUT, WITH))
        cells = [f"{row['rung']} {float(row['instructions']):,.0f}" + ("" if per == "call" else f" a {per}")
                 for row in (without, with_divider)]
        differ = without["rung"] != with_divider["rung"]
        lines.append((not differ, family, [family.replace("-", " "), default["metric"], exact_or(error, default["unit"]),
                                           cells[0], f"**{cells[1]}**" if differ else cells[1]]))
    return [line for _, _, line in sorted(lines)]
