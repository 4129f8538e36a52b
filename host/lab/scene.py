# SPDX-License-Identifier: MIT
"""The report's section on whole frames: what each knob costs and loses alone, and the joint front."""
import html
import tempfile
from pathlib import Path

from PIL import Image, ImageChops

import charts
import frames
from cores import CORES, Core
from measure import HOST, run
from table import Rows

plt = charts.plt
SHOWN_FRAME = 420
SHOWN_FIRST = ("cortex-m0plus", "cortex-m3")


def tornado(rivals: Rows) -> list[tuple[str, str, float, float]]:
    """[(knob, choice, instructions relative to the standard, mean error less the standard's)] of knobs alone."""
    standard = frames.standard_of(rivals)
    cost, error = float(standard["mean_instructions"]), float(standard["error_mean"])
    return [(knob, choice, float(row["mean_instructions"]) / cost - 1, float(row["error_mean"]) - error)
            for knob, moves in frames.alone(rivals).items() for choice, row in moves]


def tornado_chart(rivals: Rows, title: str) -> str:
    """Two bars a move: what it costs, and how the picture's error changes."""
    moves = tornado(rivals)
    figure, (costs, errors) = plt.subplots(1, 2, sharey=True, figsize=(4.0, 0.2 * len(moves) + 0.6))
    places = range(len(moves))
    costs.barh(places, [100 * cost for _, _, cost, _ in moves], color=charts.ACCENT, height=0.6)
    errors.barh(places, [error for _, _, _, error in moves], color=charts.SECOND, height=0.6)
    costs.set_yticks(list(places), [f"{knob} {choice}" for knob, choice, _, _ in moves])
    costs.invert_yaxis()
    costs.set_xlabel("instructions,\n% more")
    errors.set_xlabel("mean error,\nCIE76 more")
    for axes in (costs, errors):
        axes.axvline(0, color=charts.INK, linewidth=0.6)
        axes.grid(True, axis="x")
    figure.tight_layout()
    return charts.svg_of(figure, title)


def front_chart(rivals: Rows, title: str) -> str:
    """All settings: cost against error. What none beats is filled and joined; the standard one is marked."""
    stairs = frames.front(rivals)
    figure, axes = plt.subplots(figsize=(3.6, 2.6))
    at = {row["setting"]: (float(row["instructions"]) / 1e6, float(row["error_mean"])) for row in rivals}
    for row in rivals:
        axes.plot(*at[row["setting"]], "o", markersize=4, markeredgecolor=charts.ACCENT, markeredgewidth=0.9,
                  markerfacecolor=charts.ACCENT if row in stairs else "none")
    axes.step(*zip(*(at[row["setting"]] for row in stairs)), where="post", color=charts.ACCENT, linewidth=1)
    standard = at[frames.standard_of(rivals)["setting"]]
    axes.plot(*standard, "o", markersize=9, markeredgecolor=charts.SECOND, markerfacecolor="none", markeredgewidth=1.4)
    axes.annotate("as it is", standard, xytext=(7, 5), textcoords="offset points", color=charts.SECOND)
    axes.set_xlim(left=0)
    axes.set_ylim(bottom=-0.1)
    axes.grid(True)
    axes.set_xlabel("million instructions of the dearest frame")
    axes.set_ylabel("mean error, CIE76")
    return charts.svg_of(figure, title)


def _picture(app: str, variant: int, folder: str) -> Image.Image:
    file = Path(folder) / "frame.ppm"
    run(HOST / "bin/lab-scenes", "picture", app, variant, SHOWN_FRAME, file)
    return Image.open(file).convert("RGB").copy()


def pictures(scene: dict) -> list[tuple[str, Image.Image, Image.Image | None]]:
    """(caption, picture, eight times how it differs from the finest) of the standard setting and each knob alone."""
    shown = []
    first = scene["variants"][scene["fixed"]]["setting"]
    with tempfile.TemporaryDirectory() as folder:
        finest = _picture(scene["name"], scene["fixed"] - 1, folder)
        for number, variant in enumerate(scene["variants"]):
            turned = [f"{knob} = {choice}" for knob, choice in variant["setting"].items() if choice != first[knob]]
            if number < scene["fixed"] or len(turned) > 1:
                continue
            picture = _picture(scene["name"], number, folder)
            difference = ImageChops.difference(picture, finest).point(lambda level: min(255, level * 8))
            shown.append((turned[0] if turned else "as it is", picture, difference if difference.getbbox() else None))
        shown.append(("the finest", finest, None))
    return shown


def _figures(scene: dict) -> str:
    from page import png_data

    parts = []
    for caption, picture, difference in pictures(scene):
        parts.append(f'<figure><img alt="{html.escape(caption)}" src="{png_data(picture)}">'
                     f"<figcaption>{html.escape(caption)}</figcaption>")
        if difference is not None:
            parts.append(f'<img alt="difference of {html.escape(caption)}" src="{png_data(difference)}">'
                         "<figcaption>the difference from the finest, eight times</figcaption>")
        parts.append("</figure>")
    return "".join(parts)


def _programs_table(rows: Rows) -> str:
    lines = []
    for core in CORES.values():
        for app in dict.fromkeys(row["app"] for row in rows):
            rivals = frames.of(rows, app, core.name)
            if rivals:
                row = frames.standard_of(rivals)
                lines.append(f'<tr><td>{html.escape(core.title)}</td><td class="text">{app}</td>'
                             f"<td>{int(row['mean_instructions']):,}</td><td>{int(row['instructions']):,}</td>"
                             f"<td>{core.cycles(row):,.0f}</td><td>{int(row['loads']):,}</td><td>{int(row['stores']):,}</td>"
                             f"<td>{int(row['multiplies']):,}</td><td>{int(row['divides']):,}</td>"
                             f"<td>{int(row['stack_bytes']):,}</td></tr>")
    return ('<div class="wide"><table><tr><th>core</th><th class="text">program</th><th>instructions, mean</th>'
            "<th>dearest frame</th><th>its cycles, modelled</th><th>loads</th><th>stores</th><th>multiplies</th>"
            f"<th>divides</th><th>stack, bytes</th></tr>{''.join(lines)}</table></div>")


def html_fragment(rows: Rows, scenes: list[dict]) -> str:
    """The section. `rows` and `scenes` as frames.rows_of() gives them."""
    parts = ["<p>Whole frames of the programs in firmware/apps, 320x240 pixels of 8 bits: state, palette and picture. "
             "Counts are those of the dearest of the frames looked at, and the mean of all. "
             "<code>intaglio-lab budget</code> answers from this table whether a frame fits.</p>", _programs_table(rows)]
    for scene in scenes:
        if not scene["knobs"]:
            continue
        name = scene["name"]
        parts.append(f"<h3>The knobs of {html.escape(name)}</h3><ul>")
        parts += [f"<li><b>{html.escape(knob['name'])}</b>: {html.escape(knob['explained'])}. As it is: "
                  f"{html.escape(knob['standard'])}; finest: {html.escape(knob['finest'])}.</li>" for knob in scene["knobs"]]
        parts.append("</ul><p>Error is the mean distance of all pixels' colours (CIE 1976 L*a*b*) from the same frames with "
                     "every knob at its finest. First: each knob turned alone, against the program as it is. Then: filled "
                     f"settings are beaten by none of all {len(scene['settings']):,} in both; hollow ones are others that "
                     "were counted. Knobs are constants of the program's type; counted is one copy in which they are "
                     "variables, less what that costs in the standard setting: all combinations of knobs that one part of "
                     "the program asks. Other settings cost the sum of their parts, to the instruction, which is held "
                     "against counts of some of them.</p>")
        for core in CORES.values():
            rivals = frames.of(rows, name, core.name)
            if not rivals:
                continue
            parts.append(
                f"<details {'open' if core.name in SHOWN_FIRST else ''}><summary><b>{html.escape(core.title)}</b></summary>"
                f"<div class=\"cards\"><div class=\"card\">{tornado_chart(rivals, f'knobs of {name} alone, {core.name}')}"
                f"</div><div class=\"card\">{front_chart(rivals, f'settings of {name}, {core.name}')}</div></div>"
                f"{_front_table(core, rivals)}</details>")
        parts.append(f"<details><summary>Pictures: frame {SHOWN_FRAME} with each knob turned, and eight times how it differs "
                     f"from the finest</summary><div class=\"pictures\">{_figures(scene)}</div></details>")
    return "\n".join(parts)


def _front_table(core: Core, rivals: Rows) -> str:
    standard = frames.standard_of(rivals)
    lines = "".join(f'<tr><td>{html.escape(frames.changes(row, standard))}</td><td>{int(row["instructions"]):,}</td>'
                    f'<td>{core.cycles(row):,.0f}</td><td>{row["error_mean"]}</td><td>{row["error_worst"]}</td>'
                    f'<td>{row["wrong_ppm"]}</td></tr>' for row in frames.front(rivals))
    return ('<details><summary>Settings worth having: figures</summary><div class="wide"><table><tr><th>setting</th>'
            "<th>instructions</th><th>cycles, modelled</th><th>mean error, CIE76</th><th>worst, CIE76</th>"
            f"<th>pixels that differ, ppm</th></tr>{lines}</table></div></details>")
