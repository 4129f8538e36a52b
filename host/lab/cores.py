# SPDX-License-Identifier: MIT
"""The cores that are counted on: how each is built for and emulated, and what its cycles are modelled by."""
import typing
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


class Model(typing.NamedTuple):
    """Cycles beyond one an instruction; of typical parts with memory that doesn't make them wait. Taken branches
    aren't counted apart, so they are not in it."""
    load: float
    store: float
    multiply: float
    divide: float
    source: str


class Core(typing.NamedTuple):
    """A core. `machine` is QEMU's; none: counted by callgrind."""
    name: str
    title: str
    divider: bool
    machine: tuple[str, ...]
    isa: str
    tools: str
    flags: tuple[str, ...]
    model: Model

    @property
    def build(self) -> Path:
        return ROOT / "build" / (self.name if self.machine else "host-release")

    def cycles(self, row: dict[str, str]) -> float:
        """Modelled cycles of a row's counts."""
        model = self.model
        return (float(row["instructions"]) + model.load * float(row["loads"]) + model.store * float(row["stores"]) +
                model.multiply * float(row["multiplies"]) + model.divide * float(row["divides"]))


_ARM = "arm-none-eabi-"
_RISCV = "riscv64-unknown-elf-"


def _arm(machine: str) -> tuple[str, ...]:
    return ("qemu-system-arm", "-M", machine)


# Code for the M0+ runs on the M3, which executes all of its instructions, each counted as one.
CORES = {core.name: core for core in (
    Core("cortex-m0plus", "Cortex-M0+, -Os", False, _arm("mps2-an385"), "thumb", _ARM,
         ("-mcpu=cortex-m0plus", "-mthumb"), Model(1, 1, 0, 0, "Cortex-M0+ TRM: loads and stores 2, multiply 1")),
    Core("cortex-m3", "Cortex-M3, -O2", True, _arm("mps2-an385"), "thumb", _ARM,
         ("-mcpu=cortex-m3", "-mthumb"),
         Model(1, 0, 0.5, 6, "Cortex-M3 TRM: load 2, store buffered, multiply 1 to 2, divide 2 to 12")),
    Core("cortex-m4", "Cortex-M4, -O2", True, _arm("mps2-an386"), "thumb", _ARM,
         ("-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=soft"),
         Model(1, 0, 0, 6, "Cortex-M4 TRM: load 2, store buffered, multiply 1, divide 2 to 12")),
    Core("cortex-m7", "Cortex-M7, -O2", True, _arm("mps2-an500"), "thumb", _ARM,
         ("-mcpu=cortex-m7", "-mthumb", "-mfloat-abi=soft"),
         Model(0, 0, 0, 8, "one an instruction (up to two are issued at once), divide 3 to 19")),
    Core("arm926", "ARM926, -O2", False, (*_arm("versatilepb"), "-audiodev", "none,id=quiet"), "arm", _ARM,
         ("-mcpu=arm926ej-s", "-marm"), Model(0, 0, 1, 0, "ARM926EJ-S TRM: loads 1 from the cache, multiply 2")),
    Core("rv32imac", "RV32IMAC, -O2", True, ("qemu-system-riscv32", "-M", "virt", "-bios", "none"), "riscv", _RISCV,
         ("-march=rv32imac", "-mabi=ilp32"), Model(1, 0, 4, 33, "a small core: load 2, multiply 5, divide 34")),
    Core("x86-64", "x86-64, -O2", True, (), "", "", (), Model(0, 0, 0, 0, "none: only for comparison")),
)}


def core_called(name: str) -> Core | None:
    """A core by its name; an M0 runs what an M0+ does."""
    return CORES.get({"cortex-m0": "cortex-m0plus"}.get(name, name))
