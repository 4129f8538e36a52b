# SPDX-License-Identifier: MIT
"""Runs mps2-count under QEMU and reads what it counted."""
import shutil
import subprocess
import sys
import typing
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

# Preset (core and optimisation) and QEMU machine. The M0+ code (-Os) runs on the M3, which executes all of its
# instructions, each counted as one.
MACHINES = {"cortex-m3": "mps2-an385", "cortex-m0plus": "mps2-an385", "cortex-m4": "mps2-an386"}


class Row(typing.NamedTuple):
    """One primitive."""
    name: str
    pixels: int
    instructions: int
    units: int


class Pair(typing.NamedTuple):
    """Instructions of a primitive that fills the window, and of one that reaches far beyond it."""
    name: str
    filling: int
    far: int


class Counts(typing.NamedTuple):
    """All that one core counted."""
    rows: list[Row]
    pairs: list[Pair]


def require_tools():
    """Ends the test, skipped, where it can't run."""
    for tool in ("qemu-system-arm", "arm-none-eabi-g++"):
        if shutil.which(tool) is None:
            print(f"skipped: {tool} isn't installed (packages in firmware/packages)")
            sys.exit(77)


def run(command):
    """What a command of the tree prints."""
    done = subprocess.run(command, cwd=ROOT, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=600,
                          check=False)
    if done.returncode != 0:
        print(done.stdout)
        sys.exit(77 if done.returncode == 77 else f"{command[0]} failed with exit code {done.returncode}")
    return done.stdout


def count(core):
    """The counts of one core, built first."""
    run(["tests/target/build_cross", core, "mps2-count"])
    emulate = ["qemu-system-arm", "-M", MACHINES[core], "-kernel", f"build/{core}/bin/mps2-count", "-nographic",
               "-monitor", "none", "-serial", "none", "-semihosting-config", "enable=on,target=native",
               "-icount", "shift=10,sleep=off"]
    output = run(emulate)
    if output != run(emulate):
        sys.exit(f"{core}: two runs differ")

    def lines(kind, make):
        for line in output.splitlines():
            if line.startswith(kind + " "):
                name, *numbers = line.removeprefix(kind + " ").split(";")
                yield make(name, *map(int, numbers))

    return Counts(list(lines("row", Row)), list(lines("pair", Pair)))
