# SPDX-License-Identifier: MIT
"""The lab's report: one page of HTML with all charts, tables and pictures in it."""
import base64
import io
import itertools
import tempfile
import typing
from pathlib import Path

import jinja2
from PIL import Image, ImageChops

import charts
from cores import CORES
from measure import run
from table import Row, Rows

TEMPLATE = Path(__file__).resolve().parent / "report.html.jinja"
SHOWN_FIRST = ("cortex-m0plus", "cortex-m3")


def cycles(row: Row) -> float:
    """Modelled cycles."""
    return CORES[row["core"]].cycles(row)


class Turn(typing.NamedTuple):
    """A pair of rungs whose order turns round between two cores."""
    family: str
    load: str
    here: str  # the core on which `cheaper` is
    there: str  # where `other` is
    cheaper: str
    other: str
    costs_here: tuple[float, float]  # of both
    costs_there: tuple[float, float]


def turns(rows: Rows, factor: float = 1.3) -> list[Turn]:
    """The most telling pair of each family, those that turn most first."""
    costs: dict[tuple[str, str], dict[str, dict[str, float]]] = {}
    worst = {}
    for row in rows:
        key = row["family"], row["metric"]
        costs.setdefault(key, {}).setdefault(row["rung"], {})[row["core"]] = float(row["instructions"])
        worst[key, row["rung"]] = float(row["worst"])
    best: dict[str, tuple[float, Turn]] = {}
    for (family, load), rungs in costs.items():
        for (a, of_a), (b, of_b) in itertools.permutations(rungs.items(), 2):
            cores = [name for name in CORES if name != "x86-64" and min(of_a.get(name, 0), of_b.get(name, 0)) > 0]
            for here, there in itertools.permutations(cores, 2):
                gain = min(of_b[here] / of_a[here], of_a[there] / of_b[there])
                # Of rungs equally good it matters most.
                weight = gain * (2 if worst[(family, load), a] == worst[(family, load), b] else 1)
                if gain >= factor and (family not in best or weight > best[family][0]):
                    best[family] = weight, Turn(family, load, here, there, a, b, (of_a[here], of_b[here]),
                                                (of_a[there], of_b[there]))

    def turned(turn):
        return turn.costs_here[1] / turn.costs_here[0] * turn.costs_there[0] / turn.costs_there[1]

    return sorted((turn for _, turn in best.values()), key=turned, reverse=True)


def figure(number: str | float) -> str:
    """A cost as a reader wants it: three digits or whole, thousands apart."""
    number = float(number)
    return f"{number:,.0f}" if number >= 100 else f"{number:.1f}" if number >= 10 else f"{number:.2f}"


def digits(number: str | float) -> str:
    """An error in three digits, or whole."""
    number = float(number)
    return f"{number:,.0f}" if number >= 1000 else f"{number:.3g}"


def by_value(of_keys: dict[str, str]) -> typing.Iterable[tuple[str, list[str]]]:
    """(value, its keys) of a dict."""
    values: dict[str, list[str]] = {}
    for key, value in of_keys.items():
        values.setdefault(value, []).append(key)
    return values.items()


def png_data(image: Image.Image) -> str:
    buffer = io.BytesIO()
    image.save(buffer, "png", optimize=True)
    return "data:image/png;base64," + base64.b64encode(buffer.getvalue()).decode()


def cropped(drawn: dict[str, Image.Image], margin: int = 4, least: int = 64) -> dict[str, Image.Image]:
    """Pictures without what all of them leave empty, and small ones enlarged, pixel by pixel."""
    boxes = [box for box in (picture.getbbox() for picture in drawn.values()) if box is not None]
    width, height = next(iter(drawn.values())).size
    left, top = (max(0, min(box[i] for box in boxes) - margin) for i in (0, 1))
    right = min(width, max(left + least, max(box[2] for box in boxes) + margin))
    bottom = min(height, max(top + least, max(box[3] for box in boxes) + margin))
    times = max(1, min(width // (right - left), height // (bottom - top)))
    return {rung: picture.crop((left, top, right, bottom))
                         .resize(((right - left) * times, (bottom - top) * times), Image.Resampling.NEAREST)
            for rung, picture in drawn.items()}


def pictures(family: dict, load: str, rivals: Rows) -> list[dict]:
    """What each rung draws, and eight times the difference from the most accurate one; empty if nothing is drawn."""
    drawn = {}
    with tempfile.TemporaryDirectory() as folder:
        for row in rivals:
            file = Path(folder) / "picture.pgm"
            run(family["program"], "picture", row["rung"], load, file)
            if not file.exists():
                return []
            drawn[row["rung"]] = Image.open(file).convert("L").copy()
    best = min(rivals, key=lambda row: (float(row["worst"]), float(row["mean"])))["rung"]
    drawn = cropped(drawn)
    shown = []
    for row in rivals:
        picture = drawn[row["rung"]]
        difference = ImageChops.difference(picture, drawn[best]).point(lambda level: min(255, level * 8))
        shown.append({"rung": row["rung"], "picture": png_data(picture), "best": row["rung"] == best,
                      "difference": png_data(difference) if difference.getbbox() else None})
    return shown


def _family(family: dict, rows: Rows) -> dict:
    """What the template needs of one family."""
    loads = []
    for load in family["loads"]:
        of_load = [row for row in rows if row["metric"] == load["name"]]
        per_core = []
        for core in CORES.values():
            rivals = [row for row in of_load if row["core"] == core.name]
            if not rivals:
                continue
            title = f"{family['name']}, {load['name']}, {core.name}"
            per_core.append({"core": core, "rows": rivals, "loop": rivals[0]["loop"], "open": core.name in SHOWN_FIRST,
                             "chart": charts.family_chart(rivals, family["per"], title)})
        shown = pictures(family, load["name"], [row for row in of_load if row["core"] == of_load[0]["core"]])
        loads.append({**load, "cores": per_core, "pictures": shown})
    slack = {rung["name"]: rung["slack"] for rung in family["rungs"] if rung["slack"]}
    domains = {rung["name"]: rung["domain"] for rung in family["rungs"] if rung["domain"]}
    return {**family, "load_tables": loads, "slack": slack, "domains": domains}


def write(path: Path, families: dict[str, dict], rows: Rows, errors: dict[tuple, dict],
          fragments: list[tuple[str, str, str]], compilers: list[str]) -> None:
    """Writes the report. `fragments`: (anchor, title, HTML) of further sections."""
    points: dict[str, dict[str, str]] = {}
    for (family, load, _), error in errors.items():
        points.setdefault(family, {})[load] = f"{error['points']:,} points: {error['how']}"
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(TEMPLATE.parent), autoescape=True,
                                     undefined=jinja2.StrictUndefined, trim_blocks=True, lstrip_blocks=True)
    environment.filters.update(cycles=cycles, figure=figure, digits=digits, by_value=by_value)
    titles = {name: family["title"] for name, family in families.items()}
    page = environment.get_template(TEMPLATE.name).render(
        families=[_family(family, [row for row in rows if row["family"] == name]) for name, family in families.items()],
        turns=turns(rows), titles=titles, cores=list(CORES.values()), points=points, fragments=fragments,
        light=charts.LIGHT, dark=charts.DARK, compilers=compilers, count=len(rows))
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(page)
