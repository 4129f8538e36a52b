# SPDX-License-Identifier: MIT
"""Whole frames of the programs under settings of their knobs: the rows of frames.csv.

Counts are those of the dearest of the frames that are looked at, `mean_instructions` is over all of them. Errors are
distances of colours (CIE 1976) from the same frames with every knob at its finest. The first setting of a program is
the standard one. `counted` says whether a setting was counted or is a sum of counts of its parts (sums.py); of sums only
those are kept that no setting beats.
"""
import csv
import functools
import json
from pathlib import Path
from typing import Callable

import sums
import table
from cores import ROOT, Core
from measure import COUNTED, HOST, Failure, count, count_key, run
from table import Row, Rows
from work import Work

COLUMNS = ["app", "setting", "core", "frame", *COUNTED, "mean_instructions", "stack_bytes", "error_mean", "error_worst",
           "wrong_ppm", "counted"]
BASELINE = ROOT / "host/lab/baseline/frames.csv"
# Knobs as variables may cost so much more than as constants in the finest setting, beyond what they do in the standard.
VARIABLES_COST = 1.05
_FAULT = 1 << 31
Setting = dict[str, str]
Cost = Callable[[Row], float]


def scenes(work: Work) -> list[dict]:
    """What lab-scenes says: programs, knobs, variants, errors."""
    program = HOST / "bin/lab-scenes"
    return work.do("frames' pictures", {"scenes": (("scenes", work.hash_of(program)),
                                                   lambda: json.loads(run(program, "list")))})["scenes"]


def setting_text(setting: Setting) -> str:
    return " ".join(f"{knob}={choice}" for knob, choice in setting.items()) or "standard"


def parsed_setting(text: str) -> Setting:
    return dict(part.split("=", 1) for part in text.split()) if "=" in text else {}


def rows_of(work: Work, cores: list[Core]) -> tuple[Rows, list[dict]]:
    """(rows, scenes) measured. Fails if cores draw other frames than the desk does."""
    described = scenes(work)
    counted = work.do("frames", {
        core.name: (count_key(work, core, "lab-frames"), functools.partial(count, core, "lab-frames"))
        for core in cores})
    rows = []
    for core in cores:
        counts = iter(counted[core.name])
        for scene in described:
            rows += _rows_of_scene(core, scene, counts)
    return rows, described


def _rows_of_scene(core, scene, counts):
    counted = [_checked(core, scene, variant, [next(counts) for _ in scene["frames"]]) for variant in scene["variants"]]
    constants = [_row(core, scene, variant, *numbers)
                 for variant, numbers in zip(scene["variants"], counted[:scene["fixed"]])]
    if not scene["knobs"]:
        return constants
    turned = list(zip(scene["variants"], counted))[scene["fixed"]:]
    # What knobs as variables cost more than as constants, in the standard setting, is taken off all.
    extra = _each(lambda a, b: a - b, turned[0][1][0], counted[0][0])

    def row_of(variant, numbers, stack, how):
        return _row(core, scene, variant, _each(lambda a, b: max(0, a - b), numbers, extra), stack, how)

    rows = {}
    for variant, (numbers, stack) in turned:
        row = row_of(variant, numbers, stack, "yes")
        same = next((same for same in constants if same["setting"] == row["setting"]), None)
        if same is not None:
            _check_variables(core, row, same)
        rows[row["setting"]] = same or row
    total = sums.Sums(scene, {setting_text(variant["setting"]): numbers for variant, (numbers, _) in turned})
    stacks = {setting_text(variant["setting"]): stack for variant, (_, stack) in turned}
    summed = []
    for variant in scene["settings"]:
        numbers = total.of(variant["setting"])
        text = setting_text(variant["setting"])
        if text in rows:
            total.check(variant["setting"], f"{core.name}: {scene['name']}, {text}")
        else:
            stack = max(stacks[setting_text(part)] for part in total.parts_of(variant["setting"]))
            summed.append(row_of(variant, numbers, stack, "sum"))
    return [*rows.values(), *_unbeaten(core, [*rows.values(), *summed], summed)]


def _checked(core, scene, variant, counted):
    """(counts of each frame, stack) of a variant: no errors, and the pictures of the desk."""
    for frame, (_, stack, digest), seen in zip(scene["frames"], counted, variant["digests"]):
        if stack & _FAULT:
            raise Failure(f"{core.name}: {scene['name']} reports an error at frame {frame}")
        if digest != seen:
            raise Failure(f"{core.name}: frame {frame} of {scene['name']} isn't the desk's, "
                          f"{setting_text(variant['setting'])}")
    return [numbers for numbers, _, _ in counted], max(stack for _, stack, _ in counted)


def _each(function, ones, others):
    """Counts of each frame, from those of two."""
    return [[function(a, b) for a, b in zip(*pair)] for pair in zip(ones, others)]


def _unbeaten(core, rows, candidates):
    """Those of the candidates that no row beats, in instructions or in cycles."""
    unbeaten = {row["setting"] for cost in (_instructions, core.cycles) for row in front(rows, cost)}
    return [row for row in candidates if row["setting"] in unbeaten]


def _row(core, scene, variant, numbers, stack, how="yes"):
    dearest, frame = max((of_frame, -frame) for frame, of_frame in zip(scene["frames"], numbers))
    return {"app": scene["name"], "setting": setting_text(variant["setting"]), "core": core.name, "frame": str(-frame),
            **{name: str(number) for name, number in zip(COUNTED, dearest)},
            "mean_instructions": str(sum(of_frame[0] for of_frame in numbers) // len(numbers)),
            "stack_bytes": str(stack), "error_mean": f"{variant['mean']:.4f}", "error_worst": f"{variant['worst']:.2f}",
            "wrong_ppm": f"{variant['wrong_ppm']:.0f}", "counted": how}


def _check_variables(core, row, constants):
    """Knobs as variables draw what they draw as constants, at nearly the same cost."""
    for name in ("error_mean", "error_worst", "wrong_ppm"):
        if constants[name] != row[name]:
            raise Failure(f"{row['app']}, {row['setting']}: another picture with its knobs as variables")
    larger = float(row["instructions"]) / float(constants["instructions"])
    if not 1 / VARIABLES_COST < larger < VARIABLES_COST:
        raise Failure(f"{core.name}: {row['app']}, {row['setting']}: knobs as variables cost {larger:.3f} times as much")


def of(rows: Rows, app: str, core: str) -> Rows:
    """The rows of a program on a core, the standard one first."""
    return [row for row in rows if row["app"] == app and row["core"] == core]


def standard_of(rivals: Rows) -> Row:
    return rivals[0]


def alone(rivals: Rows) -> dict[str, list[tuple[str, Row]]]:
    """By knob: the rows in which it alone is turned, with its choice."""
    standard = parsed_setting(rivals[0]["setting"])
    found: dict[str, list[tuple[str, Row]]] = {knob: [] for knob in standard}
    for row in rivals[1:]:
        turned = [(knob, choice) for knob, choice in parsed_setting(row["setting"]).items() if standard[knob] != choice]
        if len(turned) == 1:
            found[turned[0][0]].append((turned[0][1], row))
    return found


def _instructions(row: Row) -> float:
    return float(row["instructions"])


def front(rivals: Rows, cost: Cost = _instructions) -> Rows:
    """The rows that none beats in both cost and mean error, cheapest first."""
    points = sorted(rivals, key=lambda row: (cost(row), float(row["error_mean"])))
    stairs: Rows = []
    for row in points:
        if not stairs or float(row["error_mean"]) < float(stairs[-1]["error_mean"]):
            stairs.append(row)
    return stairs


def changes(row: Row, standard: Row) -> str:
    """How a row's setting differs from the standard one, in words."""
    usual = parsed_setting(standard["setting"])
    turned = [f"{knob} = {choice}" for knob, choice in parsed_setting(row["setting"]).items() if usual[knob] != choice]
    return ", ".join(turned) or "as it is"


def write(path: Path, rows: Rows) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def read(path: Path = BASELINE) -> Rows:
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


def grown(rows: Rows, baseline: Rows) -> list[str]:
    """Frames that cost more than in the baseline, look different from it, or aren't in it."""
    def key(row):
        return row["app"], row["setting"], row["core"]

    before, now = {key(row): row for row in baseline}, {key(row): row for row in rows}
    found = [f"frame of {' '.join(name)}: not in the baseline" for name in now if name not in before]
    found += [f"frame of {' '.join(name)}: in the baseline, but not measured" for name in before if name not in now]
    for name, row in now.items():
        if name not in before:
            continue
        for column in ("instructions", "mean_instructions"):
            if float(row[column]) > float(before[name][column]) * table.TOLERANCE:
                found.append(f"frame of {' '.join(name)}: {row[column]} {column}, the baseline has {before[name][column]}")
        if abs(float(row["error_mean"]) - float(before[name]["error_mean"])) > 1e-4:
            found.append(f"frame of {' '.join(name)}: {row['error_mean']} CIE76 off, the baseline has "
                         f"{before[name]['error_mean']}")
    return found
