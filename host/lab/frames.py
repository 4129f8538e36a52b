# SPDX-License-Identifier: MIT
"""Whole frames of the programs under every setting of their knobs: the rows of frames.csv.

Counts are those of the dearest of the frames that are looked at, `mean_instructions` is over all of them. Errors are
distances of colours (CIE 1976) from the same frames with every knob at its finest. The first setting of a program is
the standard one.
"""
import csv
import json

import table
from cores import ROOT
from measure import COUNTED, HOST, Failure, count, run

COLUMNS = ["app", "setting", "core", "frame", *COUNTED, "mean_instructions", "stack_bytes", "error_mean", "error_worst",
           "wrong_ppm"]
BASELINE = ROOT / "host/lab/baseline/frames.csv"
# Knobs as variables may cost so much more than as constants in the finest setting, beyond what they do in the standard.
VARIABLES_COST = 1.02
_FAULT = 1 << 31


def scenes(work):
    """What lab-scenes says: programs, knobs, variants, errors."""
    program = HOST / "bin/lab-scenes"
    return work.do("frames' pictures", {"scenes": (("scenes", work.hash_of(program)),
                                                   lambda: json.loads(run(program, "list")))})["scenes"]


def setting_text(setting):
    return " ".join(f"{knob}={choice}" for knob, choice in setting.items()) or "standard"


def parsed_setting(text):
    return dict(part.split("=", 1) for part in text.split()) if "=" in text else {}


def rows_of(work, cores):
    """(rows, scenes) measured. Fails if cores draw other frames than the desk does."""
    described = scenes(work)
    counted = work.do("frames", {
        core.name: (("frames", work.hash_of(core.build / "bin/lab-frames")),
                    lambda core=core: count(core, "lab-frames", times=1)) for core in cores})
    rows = []
    for core in cores:
        counts = iter(counted[core.name])
        for scene in described:
            rows += _rows_of_scene(core, scene, counts)
    return rows, described


def _rows_of_scene(core, scene, counts):
    rows, fixed, extra = [], [], None
    for number, variant in enumerate(scene["variants"]):
        counted = [next(counts) for _ in scene["frames"]]
        for frame, (_, stack, digest), seen in zip(scene["frames"], counted, variant["digests"]):
            if stack & _FAULT:
                raise Failure(f"{core.name}: {scene['name']} reports an error at frame {frame}")
            if digest != seen:
                raise Failure(f"{core.name}: frame {frame} of {scene['name']} isn't the desk's, "
                              f"{setting_text(variant['setting'])}")
        numbers = [numbers for numbers, _, _ in counted]
        stack = max(stack for _, stack, _ in counted)
        if number < scene["fixed"]:
            fixed.append((_row(core, scene, variant, numbers, stack), numbers))
            continue
        # What knobs as variables cost more than as constants, in the standard setting, is taken off all.
        extra = extra or [[a - b for a, b in zip(*pair)] for pair in zip(numbers, fixed[0][1])]
        numbers = [[max(0, a - b) for a, b in zip(*pair)] for pair in zip(numbers, extra)]
        row = _row(core, scene, variant, numbers, stack)
        for same, _ in fixed:
            if same["setting"] == row["setting"]:
                _check_variables(core, row, same)
                row = same
        rows.append(row)
    return rows or [row for row, _ in fixed]


def _row(core, scene, variant, numbers, stack):
    dearest, frame = max((of_frame, -frame) for frame, of_frame in zip(scene["frames"], numbers))
    return {"app": scene["name"], "setting": setting_text(variant["setting"]), "core": core.name, "frame": str(-frame),
            **{name: str(number) for name, number in zip(COUNTED, dearest)},
            "mean_instructions": str(sum(of_frame[0] for of_frame in numbers) // len(numbers)),
            "stack_bytes": str(stack), "error_mean": f"{variant['mean']:.4f}", "error_worst": f"{variant['worst']:.2f}",
            "wrong_ppm": f"{variant['wrong_ppm']:.0f}"}


def _check_variables(core, row, constants):
    """Knobs as variables draw what they draw as constants, at nearly the same cost."""
    for name in ("error_mean", "error_worst", "wrong_ppm"):
        if constants[name] != row[name]:
            raise Failure(f"{row['app']}, {row['setting']}: another picture with its knobs as variables")
    larger = float(row["instructions"]) / float(constants["instructions"])
    if not 1 / VARIABLES_COST < larger < VARIABLES_COST:
        raise Failure(f"{core.name}: {row['app']}, {row['setting']}: knobs as variables cost {larger:.3f} times as much")


def of(rows, app, core):
    """The rows of a program on a core, the standard one first."""
    return [row for row in rows if row["app"] == app and row["core"] == core]


def standard_of(rivals):
    return rivals[0]


def alone(rivals):
    """By knob: the rows in which it alone is turned, with its choice."""
    standard = parsed_setting(rivals[0]["setting"])
    found = {knob: [] for knob in standard}
    for row in rivals[1:]:
        turned = [(knob, choice) for knob, choice in parsed_setting(row["setting"]).items() if standard[knob] != choice]
        if len(turned) == 1:
            found[turned[0][0]].append((turned[0][1], row))
    return found


def front(rivals):
    """The rows that none beats in both instructions and mean error, cheapest first."""
    points = sorted(rivals, key=lambda row: (float(row["instructions"]), float(row["error_mean"])))
    stairs = []
    for row in points:
        if not stairs or float(row["error_mean"]) < float(stairs[-1]["error_mean"]):
            stairs.append(row)
    return stairs


def changes(row, standard):
    """How a row's setting differs from the standard one, in words."""
    usual = parsed_setting(standard["setting"])
    turned = [f"{knob} = {choice}" for knob, choice in parsed_setting(row["setting"]).items() if usual[knob] != choice]
    return ", ".join(turned) or "as it is"


def write(path, rows):
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def read(path=BASELINE):
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


def grown(rows, baseline):
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
