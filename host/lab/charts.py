# SPDX-License-Identifier: MIT
"""The lab's charts, as SVG that follows the page's colours, light and dark."""
import io
import re

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402  (the back end has to be chosen first)

from matplotlib.axes import Axes  # noqa: E402
from matplotlib.figure import Figure  # noqa: E402

from table import Rows  # noqa: E402

# Left, bottom, right, top.
Box = tuple[float, float, float, float]
# Drawn in these, replaced by what they stand for on the page.
INK, FAINT, ACCENT, SECOND, PAPER = "#010203", "#040506", "#070809", "#0a0b0c", "#0d0e0f"
_VARIABLES = {INK: "var(--ink)", FAINT: "var(--faint)", ACCENT: "var(--accent)", SECOND: "var(--second)",
              PAPER: "var(--paper)"}
# What the variables are where no page says it.
LIGHT = "--ink:#1b1f24;--faint:#c9ced6;--accent:#0b63ce;--second:#c2410c;--paper:#ffffff"
DARK = "--ink:#e6e8eb;--faint:#454b54;--accent:#6cb2ff;--second:#ff9a5c;--paper:#14171b"

plt.rcParams.update({
    "svg.fonttype": "none", "svg.hashsalt": "intaglio", "font.size": 8, "font.family": "sans-serif",
    "axes.edgecolor": FAINT, "axes.labelcolor": INK, "xtick.color": INK, "ytick.color": INK, "text.color": INK,
    "axes.spines.top": False, "axes.spines.right": False, "grid.color": FAINT, "grid.linewidth": 0.4,
})


def svg_of(figure: Figure, title: str, standalone: bool = False) -> str:
    """A figure's SVG. On its own it brings its colours along."""
    buffer = io.StringIO()
    figure.savefig(buffer, format="svg", transparent=True, bbox_inches="tight", metadata={"Date": None, "Title": title})
    plt.close(figure)
    text = buffer.getvalue()
    text = text[text.index("<svg"):]
    text = re.sub(r"<metadata>.*?</metadata>\s*", "", text, flags=re.DOTALL)
    text = re.sub(r"<!--.*?-->\s*", "", text, flags=re.DOTALL)
    # Names within the file must not meet those of the page's other charts.
    mark = re.sub(r"\W+", "-", title)
    text = re.sub(r'\bid="([^"]+)"', rf'id="{mark}-\1"', text)
    text = re.sub(r'href="#([^"]+)"', rf'href="#{mark}-\1"', text)
    text = re.sub(r"url\(#([^)]+)\)", rf"url(#{mark}-\1)", text)
    for colour, variable in _VARIABLES.items():
        text = text.replace(colour, variable)
    text = text.replace("<svg ", f'<svg role="img" aria-label="{title}" ', 1)
    if standalone:
        style = f"<style>svg{{{LIGHT};background:var(--paper)}}@media(prefers-color-scheme:dark){{svg{{{DARK}}}}}</style>"
        text = re.sub(r"(<svg [^>]*>)", rf"\1{style}", text, count=1, flags=re.DOTALL)
    return text


def _short(number: float) -> str:
    """A few characters: 0.02, 5, 200, 50k, 2M."""
    for limit, unit in ((1e6, "M"), (1e3, "k")):
        if number >= limit:
            return f"{number / limit:.3g}{unit}"
    return f"{number:.3g}"


def _finish_costs(axes: Axes, costs: list[float]) -> None:
    """A logarithmic axis with a few plain numbers on it."""
    axes.set_xscale("log")
    low, high = min(costs) / 1.4, max(costs) * 1.4
    axes.set_xlim(low, high)
    ticks = [m * 10 ** e for e in range(-3, 10) for m in (1, 2, 5)]
    if high < 8 * low:  # too near to each other for these
        ticks = matplotlib.ticker.MaxNLocator(5).tick_values(low, high)
    ticks = [tick for tick in ticks if low <= tick <= high]
    if len(ticks) > 6:
        ticks = [tick for tick in ticks if f"{tick:e}"[0] == "1"] or ticks[::2]
    axes.set_xticks(ticks, [_short(tick) for tick in ticks])
    axes.xaxis.set_minor_locator(matplotlib.ticker.NullLocator())


# Where a number may stand beside its point, in typographic points: its lower left corner if it has one digit.
_PLACES = ((4, 4), (4, -10), (-9, 4), (-9, -10), (-2, 7), (-2, -13), (7, -3), (-12, -3))


def _covered(box: Box, other: Box) -> float:
    """The area that two boxes (left, bottom, right, top) share."""
    return (max(0, min(box[2], other[2]) - max(box[0], other[0])) *
            max(0, min(box[3], other[3]) - max(box[1], other[1])))


def _number(axes: Axes, points: list[tuple[int, float, float]]) -> None:
    """Numbers beside their points, (number, x, y), each where it covers least of the points and the other numbers."""
    scale = 72 / axes.figure.dpi
    centres = [axes.transData.transform((x, y)) * scale for _, x, y in points]
    taken = [(x - 4, y - 4, x + 4, y + 4) for x, y in centres]
    for (number, x, y), (right, up) in zip(points, centres):
        def box(place, left=right, bottom=up):
            return left + place[0], bottom + place[1], left + place[0] + 5, bottom + place[1] + 7

        place = min(_PLACES, key=lambda place: sum(_covered(box(place), other) for other in taken))
        taken.append(box(place))
        axes.annotate(str(number), (x, y), xytext=place, textcoords="offset points")


def scatter(axes: Axes, points: list[tuple[int, float, float, bool]], unit: str, per: str) -> None:
    """Cost against worst error. `points`: (number, cost, error, dominated). What is exact lies on the lowest line;
    what is dominated is hollow; the line is the staircase of what is left."""
    inexact = [error for _, _, error, _ in points if error > 0]
    bottom = min(inexact) / 8 if inexact else 0.1
    exact_shown = any(error == 0 for _, _, error, _ in points)
    at = [(number, max(cost, 0.05), error if error > 0 else bottom, dominated) for number, cost, error, dominated in points]
    stairs = sorted((cost, error) for _, cost, error, dominated in at if not dominated)
    if stairs:
        axes.step([cost for cost, _ in stairs], [error for _, error in stairs], where="post", color=ACCENT, linewidth=1)
    for _, cost, error, dominated in at:
        axes.plot(cost, error, "o", markersize=6, markeredgecolor=ACCENT, markerfacecolor=PAPER if dominated else ACCENT,
                  markeredgewidth=1.2)
    axes.set_yscale("log")
    top = max(inexact) * 4 if inexact else 1
    axes.set_ylim(bottom / 2, top)
    axes.yaxis.set_minor_locator(matplotlib.ticker.NullLocator())
    decades = [10.0 ** e for e in range(-12, 12)
               if inexact and (bottom * 2 if exact_shown else bottom / 2) <= 10.0 ** e <= top]
    decades = decades[::max(1, len(decades) // 5)]
    ticks = ([bottom] if exact_shown else []) + decades
    axes.set_yticks(ticks, (["exact"] if exact_shown else []) + [_short(tick) for tick in decades])
    _finish_costs(axes, [cost for _, cost, _, _ in at])
    _number(axes, [(number, cost, error) for number, cost, error, _ in at])
    axes.grid(True)
    axes.set_xlabel(f"instructions a {per}")
    axes.set_ylabel(f"worst error,\n{unit}")


def family_chart(rivals: Rows, per: str, title: str) -> str:
    """The chart of one family, core and load; rivals in the order of their numbers."""
    figure, axes = plt.subplots(figsize=(3.3, 2.3))
    points = [(number, float(row["instructions"]), float(row["worst"]), bool(row["dominated_by"]))
              for number, row in enumerate(rivals, 1)]
    scatter(axes, points, rivals[0]["unit"], per)
    return svg_of(figure, title)


def turning_chart(families: list[tuple[str, str, str, list[tuple[str, float, float]]]]) -> str:
    """README's chart: for families whose ranking turns round, each rung's cost on two cores, joined by a line.
    `families`: (title, left core, right core, [(rung, left cost, right cost)])."""
    figure, all_axes = plt.subplots(1, len(families), figsize=(3.0 * len(families), 3.2))
    for axes, (title, left, right, rungs) in zip([all_axes] if len(families) == 1 else all_axes, families):
        for number, (rung, left_cost, right_cost) in enumerate(rungs):
            colour = ACCENT if number % 2 == 0 else SECOND
            axes.plot([0, 1], [left_cost, right_cost], "o-", color=colour, linewidth=1.6)
            axes.annotate(rung, (1, right_cost), xytext=(6, 0), textcoords="offset points", va="center",
                          fontsize=7, color=colour)
        axes.set_yscale("log")
        axes.set_xticks([0, 1], [left, right])
        axes.set_xlim(-0.15, 2.1)
        axes.yaxis.set_minor_locator(matplotlib.ticker.NullLocator())
        costs = [cost for _, a, b in rungs for cost in (a, b)]
        ticks = [m * 10 ** e for e in range(0, 8) for m in (1, 2, 5) if min(costs) / 1.3 <= m * 10 ** e <= max(costs) * 1.3]
        axes.set_yticks(ticks, [_short(tick) for tick in ticks])
        axes.set_title(title, fontsize=9)
        axes.set_ylabel("instructions a call")
    figure.tight_layout()
    return svg_of(figure, "The ranking turns round between cores", standalone=True)
