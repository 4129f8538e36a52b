#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""libfixmath side by side with this library: error and bytes on x86-64, instructions there and on two microcontrollers.

  peers.py            measures what can be built here, prints it
  peers.py --accept   and makes it the baseline, host/lab/baseline/peers.csv

Measured is Debian's libfixmath-dev where it is installed, and, for that isn't compiled with optimisation, its source
with -O2 where the build's INTAGLIO_LIBFIXMATH_SOURCE names it (`apt-get source libfixmath`).
"""
import argparse
import csv
import functools
import html
import json
import sys
from pathlib import Path

import measure
from cores import CORES, ROOT, Core
from table import Rows
from work import Work

BASELINE = ROOT / "host/lab/baseline/peers.csv"
# Counted beside x86-64, where there is the source to compile: without and with a divider.
ELSEWHERE = [CORES["cortex-m0plus"], CORES["cortex-m3"]]
COLUMNS = ["job", "load", "function", "build", "worst", "mean", "instructions", *(core.name for core in ELSEWHERE),
           "code_bytes", "table_bytes", "memory_bytes", "worst_input", "points"]
OURS = "this library"
# As libfixmath calls them, and what comments in its source say of them.
FUNCTIONS = {"Fix16Sin": "fix16_sin", "Fix16SinParabola": "fix16_sin_parabola", "Fix16Sqrt": "fix16_sqrt",
             "Fix16Div": "fix16_div", "Fix16Atan2": "fix16_atan2"}
CLAIMS = {("fix16_sin", "package"): 0.021, ("fix16_sin", "cached"): 0.021, ("fix16_sin", "uncached"): 0.021,
          ("fix16_sin", "fast"): 0.023}
BUILDS = {"package": "Debian's package, not optimised", "cached": "-O2, caches results", "uncached": "-O2, FIXMATH_NO_CACHE",
          "fast": "-O2, FIXMATH_NO_CACHE, FIXMATH_FAST_SIN", "table": "-O2, FIXMATH_NO_CACHE, FIXMATH_SIN_LUT"}
# What an option of the build changes; of the rest one build says all.
OF_BUILD = {"uncached": ("fix16_sin", "fix16_atan2"), "fast": ("fix16_sin",), "table": ("fix16_sin",)}
WORK = ROOT / "build/lab"
HERE = CORES["x86-64"]


def _build() -> list[str]:
    """Builds what can be; the names of the builds that there are."""
    measure.build([])
    measure.run("cmake", "--build", measure.HOST, "--target", "lab-peers")
    targets = measure.run("cmake", "--build", measure.HOST, "--target", "help")
    return [build for build in BUILDS if f"lab-peers-{build}:" in targets]


def _images(build: str) -> list[tuple[Core, Path]]:
    """Builds a build's images of other cores; (core, image), none if there is no source of it."""
    variables = measure.run("cmake", "-L", "-N", measure.HOST)
    source = next((line.split("=", 1)[1] for line in variables.splitlines()
                   if line.startswith("INTAGLIO_LIBFIXMATH_SOURCE:")), "")
    if build == "package" or not source:
        return []
    images = []
    for core in ELSEWHERE:
        measure.run("cmake", "--preset", core.name, f"-DINTAGLIO_LIBFIXMATH_SOURCE={source}")
        measure.run(ROOT / "tests/target/build_cross", core.name, f"lab-peers-{build}")
        images.append((core, core.build / f"bin/lab-peers-{build}"))
    return images


def _libraries(build: str) -> list[Path | str]:
    folder = measure.HOST / "host/lab/peers"
    libfixmath: Path | str = "-llibfixmath" if build == "package" else folder / f"libfixmath_{build}.a"
    return [folder / f"liblab_peers_{build}.a", *measure.archives(HERE), libfixmath]


def _measured(build: str, images: list[tuple[Core, Path]], full: bool) -> Rows:
    """Rows of one build."""
    program = measure.HOST / f"bin/lab-peers-{build}"
    families = json.loads(measure.run(program, "errors", *(["--full"] if full else [])))
    counts = iter(measure.count_here(program, "count"))
    elsewhere = {core.name: iter(measure.count(core, image.name)) for core, image in images}
    symbols = measure.kernels(HERE, Path(_libraries(build)[0]))
    rows = []
    for family in families:
        empty = measure.sections(HERE, symbols[family["type"], "Nothing"], _libraries(build))
        for load in family["loads"]:
            loop = next(counts)[0][0]
            loops = {core: next(of_core)[0][0] for core, of_core in elsewhere.items()}
            for rung in load["rungs"]:
                instructions = (next(counts)[0][0] - loop) / load["calls"]
                on_others = {core: f"{(next(of_core)[0][0] - loops[core]) / load['calls']:.2f}"
                             for core, of_core in elsewhere.items()}
                weight = measure.sections(HERE, symbols[family["type"], rung["name"]], _libraries(build))
                code, tables, memory = (max(0, own - none) for own, none in zip(weight, empty))
                rows.append({
                    "job": family["title"], "load": load["name"],
                    "function": FUNCTIONS.get(rung["name"], rung["name"]),
                    "build": build if rung["name"] in FUNCTIONS else OURS, "worst": f"{rung['worst']:.4g}",
                    "mean": f"{rung['mean']:.4g}", "instructions": f"{instructions:.2f}", **on_others, "code_bytes": str(code),
                    "table_bytes": str(tables), "memory_bytes": str(memory), "worst_input": rung["worst_input"],
                    "points": f"{rung['points']:,} points: {rung['how']}"})
    return rows


def rows(work: Work, full: bool = True) -> Rows:
    """All rows: measured where libfixmath is there, and those of the baseline that can't be measured here."""
    pieces = {}
    for build in _build():
        images = _images(build)
        programs = [measure.HOST / f"bin/lab-peers-{build}", *(image for _, image in images)]
        pieces[build] = (("peers", *map(work.hash_of, programs), full),
                         functools.partial(_measured, build, images, full))
    measured = work.do("libfixmath", pieces)
    found: dict[tuple[str, ...], dict[str, str]] = {}
    # This library's own figures come from the first; a build that is the package's wasn't counted elsewhere.
    for build, of_build in sorted(measured.items(), key=lambda item: item[0] == "package"):
        for row in of_build:
            if row["function"] in OF_BUILD.get(build, (row["function"],)):
                found.setdefault((row["job"], row["load"], row["function"], row["build"]), row)
    if BASELINE.exists():
        with BASELINE.open(newline="") as file:
            for row in csv.DictReader(file):
                key = (row["job"], row["load"], row["function"], row["build"])
                if row["build"] not in measured and (row["build"] != OURS or not measured):
                    found.setdefault(key, row)
                elif key in found:
                    for core in ELSEWHERE:
                        found[key].setdefault(core.name, row.get(core.name, ""))
    order = list(dict.fromkeys((row["job"], row["load"]) for row in found.values()))
    builds = [OURS, *BUILDS]
    return sorted(found.values(), key=lambda row: (order.index((row["job"], row["load"])), builds.index(row["build"])))


def write(all_rows: Rows) -> None:
    with BASELINE.open("w", newline="") as file:
        written = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        written.writeheader()
        written.writerows(all_rows)


def _share(text: str) -> str:
    return f"{100 * float(text) / 65536:.2g} %"


def html_fragment(all_rows: Rows) -> str:
    """The report's section."""
    others = "".join(f"<th>{core.title.partition(',')[0]}</th>" for core in ELSEWHERE)
    parts = ["""<p>libfixmath is a library of fixed-point numbers (16.16) for microcontrollers; Debian has it as
libfixmath-dev. Its functions are measured as this library's are: by the same loop, errors against the C library's in
long double of the input's exact value. Errors are in 2<sup>-16</sup>, angles in 2<sup>-16</sup> radian (a step of this
library's angles is 6.3 of them); instructions are a call's, on x86-64 under callgrind, on the Cortex-M cores under
QEMU (on the M0+ with this library compiled by -Os, as its figures elsewhere);
bytes are what the linker keeps on x86-64 for a program that calls this alone, memory is what its cache of results
takes.</p>
<p>Debian's archive is compiled without optimisation: upstream's CMakeLists.txt sets its own flags, without -O, in place of
the package's; so cost is to be compared with the builds by -O2 from the package's source. By default the sine and the
arc tangent keep results in a cache: the load of 16 angles shows it. A source comment calls the sine
&ldquo;accurate to ~2.1%&rdquo; and the fast one &ldquo;~2.3%&rdquo;: of the amplitude, within one turn, that is kept by
the first and not by the second, and beyond a turn the first's error grows, for its turn is 411,774, not
411,774.83. With FIXMATH_SIN_LUT the sine is more accurate than this library's default, by a table of 200 KiB.
On the Cortex-M cores, which have no 64-bit registers, its square root is the cheaper, for this library's takes any number
of 64 bits; its division and this library's cost about the same.</p>"""]
    if not all_rows:
        parts.append("<p>Not measured here: libfixmath-dev isn't installed.</p>")
    for job in dict.fromkeys(row["job"] for row in all_rows):
        lines = []
        for row in (row for row in all_rows if row["job"] == job):
            claim = CLAIMS.get((row["function"], row["build"]))
            mark = "" if claim is None or "up to" in job else f", stated ~{100 * claim:g} %"
            share = f" ({_share(row['worst'])}{mark})" if job.startswith("Sine") else ""
            name = f"<b>{html.escape(row['function'])}</b>" if row["build"] == OURS else html.escape(row["function"])
            lines.append(
                f'<tr><td>{name}</td><td class="text">{html.escape(BUILDS.get(row["build"], row["build"]))}</td>'
                f'<td class="text">{html.escape(row["load"])}</td>'
                f"<td>{row['worst']}{share}</td><td>{row['mean']}</td><td>{row['instructions']}</td>"
                + "".join(f"<td>{row.get(core.name) or '&ndash;'}</td>" for core in ELSEWHERE) +
                f"<td>{row['code_bytes']}</td><td>{row['table_bytes']}</td><td>{row['memory_bytes']}</td>"
                f'<td class="text">{html.escape(row["worst_input"])}</td></tr>')
        parts.append(f"""<h3>{html.escape(job)}</h3>
<div class="wide"><table>
<tr><th>function</th><th class="text">build</th><th class="text">load</th><th>worst error</th><th>mean</th>
<th>instructions, x86-64</th>{others}<th>code, bytes</th><th>tables</th><th>memory</th><th class="text">worst input</th></tr>
{chr(10).join(lines)}
</table></div>""")
    return "\n".join(parts)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--accept", action="store_true", help="make it the baseline")
    arguments = parser.parse_args()
    try:
        found = rows(Work(WORK))
    except measure.Failure as failure:
        sys.exit(f"peers.py: {failure}")
    for row in found:
        print(f"{row['job']}, {row['load']}: {row['function']} ({row['build']}): worst {row['worst']}, mean {row['mean']}, "
              f"{row['instructions']} instructions, {row['code_bytes']} bytes of code, {row['table_bytes']} of tables, "
              f"{row['memory_bytes']} of memory")
    if arguments.accept:
        write(found)


if __name__ == "__main__":
    main()
