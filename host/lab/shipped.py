# SPDX-License-Identifier: MIT
"""The table of costs that ships with the library, for choices at compile time: firmware/intaglio/number/measured_costs.hpp."""
from cores import CORES, ROOT
from measure import Failure
from table import Rows

FILE = ROOT / "firmware/intaglio/number/measured_costs.hpp"

_HEAD = """\
// SPDX-License-Identifier: MIT
//
// What each rung costs on each core: made by `intaglio-lab accept` from host/lab/baseline/accuracy.csv.
//
// Hundredths of an instruction a call (of drawing, also a pixel or what else its family is counted by), on
// {cores}, under the family's first load.
// Only programs that ask (cheapest.hpp) see it, and only while they are compiled.
#pragma once

#include <intaglio/number/core.hpp>

#include <array>

namespace intaglio::number {{

// clang-format off
inline constexpr std::array<MeasuredCost, {count}> measured_costs{{{{
"""
_END = """\
}};
// clang-format on

}  // namespace intaglio::number
"""


def text(rows: Rows) -> str:
    """The header that says what the rows say."""
    costs: dict[tuple[str, str], dict[str, int]] = {}
    families: dict[str, str] = {}
    for row in rows:
        first_load = families.setdefault(row["family"], row["metric"])
        if row["metric"] == first_load:
            costs.setdefault((row["family"], row["rung"]), {})[row["core"]] = (
                max(0, round(float(row["instructions"]) * 100)))
    lines, before = [], None
    for family, rung in sorted(costs, key=lambda key: list(families).index(key[0])):
        of_cores = costs[family, rung]
        if set(of_cores) != set(CORES):
            raise Failure(f"{family}, {rung}: not counted on {', '.join(set(CORES) - set(of_cores))}")
        if family != before:
            lines.append(f"    // {family}: {families[family]}")
            before = family
        lines.append(f'    {{"{family}", "{rung}", {{{", ".join(str(of_cores[core]) for core in CORES)}}}}},')
    head = _HEAD.format(cores=", ".join(CORES), count=len(costs))
    return head + "\n".join(lines) + "\n" + _END


def write(rows: Rows) -> None:
    FILE.write_text(text(rows))
