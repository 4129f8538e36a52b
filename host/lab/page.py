# SPDX-License-Identifier: MIT
"""The lab's report: one page of HTML with all charts, tables and pictures in it."""
import base64
import io
import subprocess
import tempfile
from pathlib import Path

import jinja2
from PIL import Image, ImageChops

import charts
from cores import CORES

TEMPLATE = Path(__file__).resolve().parent / "report.html.jinja"
SHOWN_FIRST = ("cortex-m0plus", "cortex-m3")


def cycles(row):
    """Modelled cycles."""
    return CORES[row["core"]].cycles(row)


def turns(rows, factor=1.3):
    """Pairs of rungs whose order turns round between two cores: the most telling pair of each family.
    (family, load, rung cheaper on the first core, rung cheaper on the second, first, second, costs)."""
    costs, worst = {}, {}
    for row in rows:
        key = row["family"], row["metric"]
        costs.setdefault(key, {}).setdefault(row["rung"], {})[row["core"]] = float(row["instructions"])
        worst[key, row["rung"]] = float(row["worst"])
    best = {}
    cores = [name for name in CORES if name != "x86-64"]
    for (family, load), rungs in costs.items():
        for a, of_a in rungs.items():
            for b, of_b in rungs.items():
                for first in cores:
                    for second in cores:
                        if not all(core in of for core in (first, second) for of in (of_a, of_b)):
                            continue
                        if min(of_a[first], of_b[second]) <= 0:
                            continue
                        gain = min(of_b[first] / of_a[first], of_a[second] / of_b[second])
                        # Of rungs equally good it matters most.
                        weight = gain * (2 if worst[(family, load), a] == worst[(family, load), b] else 1)
                        if gain >= factor and weight > best.get(family, (0,))[0]:
                            best[family] = (weight, load, a, b, first, second, of_a[first], of_b[first], of_a[second],
                                            of_b[second])
    return sorted(((family, *found[1:]) for family, found in best.items()),
                  key=lambda found: -found[7] / found[6] * found[8] / found[9])


def figure(number):
    """A cost as a reader wants it: three digits or whole, thousands apart."""
    number = float(number)
    return f"{number:,.0f}" if number >= 100 else f"{number:.1f}" if number >= 10 else f"{number:.2f}"


def digits(number):
    """An error in three digits, or whole."""
    number = float(number)
    return f"{number:,.0f}" if number >= 1000 else f"{number:.3g}"


def by_value(of_keys):
    """(value, its keys) of a dict."""
    values = {}
    for key, value in of_keys.items():
        values.setdefault(value, []).append(key)
    return values.items()


def png_data(image):
    buffer = io.BytesIO()
    image.save(buffer, "png", optimize=True)
    return "data:image/png;base64," + base64.b64encode(buffer.getvalue()).decode()


def cropped(drawn, margin=4, least=64):
    """Pictures without what all of them leave empty, and small ones enlarged, pixel by pixel."""
    boxes = [picture.getbbox() for picture in drawn.values() if picture.getbbox()]
    width, height = next(iter(drawn.values())).size
    left, top = (max(0, min(box[i] for box in boxes) - margin) for i in (0, 1))
    right = min(width, max(left + least, max(box[2] for box in boxes) + margin))
    bottom = min(height, max(top + least, max(box[3] for box in boxes) + margin))
    times = max(1, min(width // (right - left), height // (bottom - top)))
    return {rung: picture.crop((left, top, right, bottom))
                         .resize(((right - left) * times, (bottom - top) * times), Image.Resampling.NEAREST)
            for rung, picture in drawn.items()}


def pictures(family, load, rivals):
    """What each rung draws, and eight times the difference from the most accurate one; empty if nothing is drawn."""
    drawn = {}
    with tempfile.TemporaryDirectory() as folder:
        for row in rivals:
            file = Path(folder) / "picture.pgm"
            subprocess.run([family["program"], "picture", row["rung"], load, file], check=True)
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


def _family(family, rows):
    """What the template needs of one family."""
    loads = []
    for load in family["loads"]:
        per_core = []
        for core in CORES.values():
            rivals = [row for row in rows if row["core"] == core.name and row["metric"] == load["name"]]
            if not rivals:
                continue
            title = f"{family['name']}, {load['name']}, {core.name}"
            per_core.append({"core": core, "rows": [{**row, "cycles": cycles(row)} for row in rivals],
                             "loop": rivals[0]["loop"],
                             "open": core.name in SHOWN_FIRST,
                             "chart": charts.family_chart(rivals, family["per"], title)})
        shown = pictures(family, load["name"], per_core[0]["rows"]) if per_core else []
        loads.append({**load, "cores": per_core, "pictures": shown})
    slack = {rung["name"]: rung["slack"] for rung in family["rungs"] if rung["slack"]}
    domains = {rung["name"]: rung["domain"] for rung in family["rungs"] if rung["domain"]}
    return {**family, "load_tables": loads, "slack": slack, "domains": domains}


def write(path, families, rows, errors, fragments, compilers):
    """Writes the report. `fragments`: (anchor, title, HTML) of further sections."""
    points = {}
    for (family, load, rung), error in errors.items():
        points.setdefault(family, {})[load] = f"{error['points']:,} points: {error['how']}"
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(TEMPLATE.parent), autoescape=True,
                                     undefined=jinja2.StrictUndefined, trim_blocks=True, lstrip_blocks=True)
    environment.filters.update(figure=figure, digits=digits, by_value=by_value)
    titles = {name: family["title"] for name, family in families.items()}
    page = environment.get_template(TEMPLATE.name).render(
        families=[_family(family, [row for row in rows if row["family"] == name]) for name, family in families.items()],
        turns=turns(rows), titles=titles, cores=list(CORES.values()), points=points, fragments=fragments,
        light=charts.LIGHT, dark=charts.DARK, compilers=compilers, count=len(rows))
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(page)
