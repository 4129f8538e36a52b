# SPDX-License-Identifier: MIT
"""Measures families: what a rung costs on a core, what it weighs, and how far off it is.

The programs are built from firmware/lab and host/lab; what each measures is said there.
"""
import functools
import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any, Callable, Iterator, Sequence

import callgrind
from cores import CORES, ROOT, Core
from work import Work

COUNTED = ("instructions", "loads", "stores", "multiplies", "divides")
HOST = ROOT / "build/host-release"
# Counts as COUNTED names them, bytes of stack, a digest of the results.
Counted = tuple[list[int], int, int]


class Failure(Exception):
    """What went wrong, in words for the user."""


class MissingTool(Failure):
    """A program that isn't installed."""


def run(*command: object, timeout: float = 1800) -> str:
    """What a command prints; a Failure if it fails."""
    words = [str(part) for part in command]
    if shutil.which(words[0]) is None:
        raise MissingTool(f"{words[0]} isn't installed (packages in host/packages, firmware/packages, tests/packages)")
    done = subprocess.run(words, cwd=ROOT, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=timeout,
                          check=False)
    if done.returncode != 0:
        raise Failure(f"{' '.join(words)} failed with exit code {done.returncode}:\n{done.stdout}{done.stderr}")
    return done.stdout


def build(cores: list[Core], quiet: bool = True) -> None:
    """Builds the lab's programs for the desk and for these cores."""
    def say(title):
        if not quiet:
            print(f"building for {title}", file=sys.stderr, flush=True)

    say("the desk")
    if not (HOST / "build.ninja").exists():
        run("cmake", "--preset", "host-release")
    run("cmake", "--build", HOST, "--target", "lab")
    for core in cores:
        if core.machine:
            compiler = core.tools + "g++"
            if shutil.which(compiler) is None:
                raise MissingTool(f"{compiler} isn't installed (packages in firmware/packages)")
            say(core.title)
            run(ROOT / "tests/target/build_cross", core.name, "lab-count", "lab-frames")


def families(work: Work) -> dict[str, dict]:
    """The families as their programs describe them, by name; `program` is the program."""
    programs = sorted((HOST / "bin").glob("lab-errors-*"))
    wanted = {path.stem for path in (ROOT / "firmware/lab/families").glob("*.hpp")}
    programs = [program for program in programs if program.name.removeprefix("lab-errors-") in wanted]
    found = {}
    for program in programs:
        family = json.loads(run(program, "list"))
        family["program"] = program
        found[family["name"]] = family
    return found


def measured_loads(family: dict) -> Iterator[tuple[str, list[str]]]:
    """(load, rungs that take it) of a family; where a rung refuses a load it has no bound."""
    for index, load in enumerate(family["loads"]):
        yield load["name"], [rung["name"] for rung in family["rungs"] if rung["bounds"][index] is not None]


def slots(all_families: dict[str, dict]) -> Iterator[tuple[str, str, str | None]]:
    """(family, load, rung) in the order in which they are counted; the rung None is the loop alone."""
    by_file = sorted(all_families.values(), key=lambda family: family["program"].name)
    for family in by_file:
        for load, rungs in measured_loads(family):
            for rung in (None, *rungs):
                yield family["name"], load, rung


def _count_in_qemu(core: Core, folder: Path, program: str) -> list[str]:
    image = core.build / "bin" / program
    symbols = run(core.tools + "nm", image)
    mailbox, = re.findall(r"^([0-9a-f]+) . lab_mailbox$", symbols, re.MULTILINE)
    out = folder / "counts"
    plugin = f"{HOST}/lib/lab_qemu_counter.so,mailbox=0x{mailbox},isa={core.isa},out={out}"
    run(*core.machine, "-kernel", image, "-display", "none", "-monitor", "none", "-serial", "none", "-plugin", plugin)
    lines = out.read_text().splitlines()
    if lines[-1:] != ["done"]:
        raise Failure(f"{core.name}: the image didn't come to its end")
    return lines[:-1]


def _count_in_callgrind(folder: Path, *program: str | Path) -> list[str]:
    out = folder / "counts"
    printed = run("valgrind", "-q", "--tool=callgrind", *callgrind.OPTIONS, f"--callgrind-out-file={out}",
                  *program).split()
    lines = []
    for number in range(len(printed) // 2):
        counts = callgrind.counts((folder / f"counts.{number + 1}").read_text(), _kinds_in)
        lines += [" ".join(map(str, counts)), *printed[2 * number:2 * number + 2]]
    return lines


@functools.cache
def _kinds_in(binary: str) -> dict[int, int]:
    return callgrind.kinds_of(run("objdump", "-d", "--no-show-raw-insn", binary))


def count(core: Core, program: str = "lab-count", times: int = 2) -> list[Counted]:
    """What one core counts, a list of (counts, stack, digest) in the order of slots(), or of lab-frames."""
    if not core.machine:
        return count_here(core.build / "bin" / program, times=times)
    return _repeated(core.name, times, lambda folder: _count_in_qemu(core, folder, program))


def count_key(work: Work, core: Core, program: str) -> tuple[str, ...]:
    """What the counts of a program depend on."""
    return "count", work.hash_of(core.build / "bin" / program), *(() if core.machine else callgrind.OPTIONS)


def count_here(program: Path, *arguments: str, times: int = 2) -> list[Counted]:
    """What a program for the desk counts, as count() says it."""
    return _repeated(program.name, times, lambda folder: _count_in_callgrind(folder, program, *arguments))


def _repeated(name: str, times: int, lines_of: Callable[[Path], list[str]]) -> list[Counted]:
    """What is counted, parsed. Counted `times` times: a count that doesn't repeat is none."""
    runs = []
    for _ in range(times):
        with tempfile.TemporaryDirectory() as folder:
            runs.append(lines_of(Path(folder)))
    lines = runs[0]
    if any(lines != other for other in runs):
        raise Failure(f"{name}: two runs count differently")
    return [([int(number) for number in lines[i].split()], int(lines[i + 1]), int(lines[i + 2]))
            for i in range(0, len(lines), 3)]


def archives(core: Core) -> list[Path]:
    """What the lab's loops are linked from."""
    return [core.build / "firmware/lab/libintaglio_lab.a", core.build / "firmware/libintaglio_core.a"]


def kernels(core: Core, archive: Path | None = None) -> dict[tuple[str, str], str]:
    """Symbols of the counted loops, by (family's type, rung's name)."""
    archive = archive or archives(core)[0]
    mangled = re.findall(r"^[0-9a-f]+ [TtWw] (_ZN3lab6kernelI\S+)", run(core.tools + "nm", archive), re.MULTILINE)
    names = run(core.tools + "c++filt", *mangled).splitlines()
    found = {}
    for symbol, name in zip(mangled, names):
        for family, rung in re.findall(r"^void lab::kernel<lab::(\w+), (.*)>\(", name):
            found[family, without_namespaces(rung)] = symbol
    return found


def stack_frames(core: Core) -> dict[tuple[str, str], int]:
    """Bytes of stack of the counted loops alone, as the compiler says (-fstack-usage), by (family's type, rung's name).
    What a loop reserves and doesn't touch isn't seen when it runs; what it calls isn't in it."""
    found = {}
    for file in (core.build / "firmware/lab/CMakeFiles/intaglio_lab.dir/generated").glob("*.su"):
        for line in file.read_text().splitlines():
            function, size, kind = line.split("\t")
            match = re.search(r":void lab::kernel\(.*\[with F = (?:lab::)?(\w+); R = (.*?)(?:; \w+ = .*)?\]$", function)
            if match is None:
                continue
            if kind == "dynamic":
                raise Failure(f"{core.name}: the stack of {function} has no bound")
            found[match[1], without_namespaces(match[2])] = int(size)
    return found


def without_namespaces(name: str) -> str:
    """A C++ type's name as the programs print it."""
    head, bracket, arguments = name.partition("<")
    return head.rsplit("::", 1)[-1] + bracket + arguments


def weigh(core: Core, symbol: str) -> tuple[int, int]:
    """(bytes of code, bytes of constant tables) of what the linker keeps for a symbol."""
    return sections(core, symbol, archives(core))[:2]


def sections(core: Core, symbol: str, libraries: Sequence[str | Path]) -> tuple[int, int, int]:
    """(bytes of code, of constant tables, of memory) of what the linker keeps of these libraries for a symbol."""
    with tempfile.TemporaryDirectory() as name:
        image = Path(name) / "image"
        run(core.tools + "g++", *core.flags, "-nostdlib", "-static", "-Wl,--gc-sections", f"-Wl,-e,{symbol}",
            "-Wl,--unresolved-symbols=ignore-all", "-Wl,--build-id=none", "-o", image, *libraries, "-lgcc")
        sizes = run(core.tools + "size", "-A", image)
    section = {line.split()[0]: int(line.split()[1]) for line in sizes.splitlines() if line.startswith(".")}
    code = section.get(".text", 0)
    tables = section.get(".rodata", 0) + section.get(".srodata", 0)
    memory = sum(section.get(name, 0) for name in (".data", ".sdata", ".bss", ".sbss"))
    return code, tables, memory


def type_of(family: dict) -> str:
    """The C++ type of a family: its file's name in another spelling."""
    return "".join(word.capitalize() for word in family["program"].name.removeprefix("lab-errors-").split("_"))


def costs(work: Work, all_families: dict[str, dict], cores: list[Core]) -> dict[tuple, dict[str, Any]]:
    """By (family, load, rung, core): what is counted a unit, bytes, stack, digest. Fails if cores disagree on results."""
    counted = work.do("counts", {
        core.name: (count_key(work, core, "lab-count"), functools.partial(count, core))
        for core in cores})
    order = list(slots(all_families))
    weights = _weights(work, all_families, cores)
    table: dict[tuple, dict[str, Any]] = {}
    digests: dict[tuple, int] = {}
    for core in cores:
        own_frames = stack_frames(core)
        if len(counted[core.name]) != len(order):
            raise Failure(f"{core.name}: {len(counted[core.name])} counts for {len(order)} rungs and loads")
        for (family, load, rung), (counts, stack, digest) in zip(order, counted[core.name]):
            stack = max(stack, own_frames[type_of(all_families[family]), rung or "Nothing"])
            if rung is None:
                loop, loop_stack = counts, stack
                continue
            if digests.setdefault((family, load, rung), digest) != digest:
                raise Failure(f"{family}, {rung}: other results on {core.name} than on {cores[0].name} under '{load}'")
            units = next(entry["units"] for entry in all_families[family]["loads"] if entry["name"] == load)
            row = {name: (counted_one - of_loop) / units
                   for name, counted_one, of_loop in zip(COUNTED, counts, loop)}
            row["stack_bytes"] = max(0, stack - loop_stack)
            row["code_bytes"], row["table_bytes"] = weights[core.name, family, rung]
            row["loop_instructions"] = loop[0] / units
            table[family, load, rung, core.name] = row
    return table


def _weights(work, all_families, cores):
    pieces = {}
    for core in cores:
        key = [work.hash_of(path) for path in archives(core)]
        symbols = kernels(core)
        for family in all_families.values():
            for rung in ["Nothing", *(rung["name"] for rung in family["rungs"])]:
                symbol = symbols.get((type_of(family), rung))
                if symbol is None:
                    raise Failure(f"{core.name}: no loop of {family['name']} calls {rung}")
                pieces[core.name, family["name"], rung] = (
                    ("weigh", 2, *key, symbol), functools.partial(weigh, core, symbol))
    weighed = work.do("weights", pieces)
    return {(core, family, rung): [max(0, own - loop) for own, loop in zip(bytes_of, weighed[core, family, "Nothing"])]
            for (core, family, rung), bytes_of in weighed.items() if rung != "Nothing"}


def _said(*command: str | Path) -> Any:
    """The JSON that a command prints."""
    return json.loads(run(*command))


def errors(work: Work, all_families: dict[str, dict], full: bool) -> dict[tuple, dict]:
    """By (family, load, rung): worst, mean, worst_input, points, how."""
    pieces = {}
    for family in all_families.values():
        for load, rungs in measured_loads(family):
            for rung in rungs:
                command = [family["program"], "measure", rung, load, *(["--full"] if full else [])]
                key = ("errors", work.hash_of(family["program"]), *map(str, command[1:]))
                pieces[family["name"], load, rung] = key, functools.partial(_said, *command)
    return work.do("errors", pieces)


def replay(family: dict, rung: str, load: str, worst_input: str) -> float:
    """The error at one input."""
    return float(run(family["program"], "replay", rung, load, worst_input))


def compilers(cores: list[Core]) -> list[str]:
    """Which compilers made the counted code, one line each."""
    tools = sorted({core.tools for core in cores})
    return [run(tool + "g++", "--version").splitlines()[0] for tool in tools]


def all_cores() -> list[Core]:
    return list(CORES.values())
