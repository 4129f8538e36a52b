# SPDX-License-Identifier: MIT
"""Runs board images under QEMU, headless: waits for what they say on the serial line, takes screendumps.

Every wait has a time-out, and a failure says what the image had said until then. QEMU is gone when the `with`
block ends, however it ends.
"""
import json
import os
import shutil
import socket
import subprocess
import tempfile
import time

MACHINES = {
    "clcd": ["qemu-system-arm", "-M", "versatilepb", "-audiodev", "none,id=quiet"],
    "oled": ["qemu-system-arm", "-M", "lm3s6965evb"],
    "microbit": ["qemu-system-arm", "-M", "microbit"],
    "virt": ["qemu-system-riscv32", "-M", "virt", "-bios", "none"],
}
SKIPPED = 77  # exit code that CTest shows as "skipped"


class Failure(Exception):
    """What went wrong, in words for whoever reads the test's output."""


def require(*programs):
    """Ends the test as skipped if a program isn't installed."""
    for program in programs:
        if shutil.which(program) is None:
            print(f"skipped: {program} isn't installed")
            raise SystemExit(SKIPPED)


def main(test):
    """Runs `test()`; a Failure ends the process with its text and exit code 1."""
    try:
        test()
    except Failure as failure:
        print(f"FAILED: {failure}")
        raise SystemExit(1) from None


class Machine:
    """A running board. `icount`: virtual nanoseconds of an instruction as a power of two; with it, time in the
    machine depends on nothing but the image."""

    def __init__(self, board, image, *, icount=None, extra=()):
        command = MACHINES[board]
        require(command[0])
        if not os.path.exists(image):
            raise Failure(f"there is no image {image}; was the cross build run?")
        self._folder = tempfile.mkdtemp(prefix="intaglio-qemu-")
        self._serial = os.path.join(self._folder, "serial")
        self._errors = os.path.join(self._folder, "errors")
        monitor = os.path.join(self._folder, "monitor")
        open(self._serial, "w").close()
        self.command = [*command, "-kernel", image, "-display", "none", "-monitor", "none",
                        "-serial", f"file:{self._serial}", "-qmp", f"unix:{monitor},server=on,wait=off", *extra]
        if icount is not None:
            self.command += ["-icount", f"shift={icount},sleep=off"]
        with open(self._errors, "w") as errors:
            self._process = subprocess.Popen(self.command, stdin=subprocess.DEVNULL, stdout=errors, stderr=errors)
        self._monitor = None
        try:
            self._connect(monitor)
        except BaseException:
            self.close()
            raise

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        if self._monitor:
            self._monitor.close()
        if self._process.poll() is None:
            self._process.kill()
        self._process.wait()
        shutil.rmtree(self._folder, ignore_errors=True)

    def folder(self):
        """A folder for files of this run; gone after `close`."""
        return self._folder

    def serial(self):
        """What the image has said so far."""
        with open(self._serial, errors="replace") as file:
            return file.read()

    def wait_for(self, marker, timeout=60):
        """Waits until a line that begins with `marker` is complete; returns all that was said."""
        deadline = time.monotonic() + timeout
        while True:
            ended = self._process.poll()
            said = self.serial()
            complete = said[:said.rfind("\n") + 1].splitlines()
            if any(line.startswith(marker) for line in complete):
                return said
            if any(line.startswith("failed:") for line in complete):
                raise self._failure("the image reports a failure")
            if ended is not None:
                raise self._failure(f"QEMU ended with exit code {ended}")
            if time.monotonic() > deadline:
                raise self._failure(f"no line '{marker}...' within {timeout} s")
            time.sleep(0.01)

    def screendump(self, path):
        """Writes what the display shows as PNG."""
        self._execute("screendump", filename=os.path.abspath(path), format="png")

    def _failure(self, what):
        with open(self._errors, errors="replace") as file:
            errors = file.read()
        return Failure(f"{what}\ncommand: {' '.join(self.command)}\nserial line, last 2000 characters:\n"
                       f"{self.serial()[-2000:]}\nQEMU's own messages:\n{errors[-2000:]}")

    def _connect(self, path, timeout=30):
        deadline = time.monotonic() + timeout
        while True:
            connection = socket.socket(socket.AF_UNIX)
            try:
                connection.connect(path)
                break
            except OSError:
                connection.close()
                if self._process.poll() is not None or time.monotonic() > deadline:
                    raise self._failure("QEMU doesn't start") from None
                time.sleep(0.01)
        connection.settimeout(timeout)
        self._monitor = connection.makefile("rw")
        connection.close()  # the file keeps it open
        self._answer()
        self._execute("qmp_capabilities")

    def _execute(self, name, **arguments):
        self._monitor.write(json.dumps({"execute": name, "arguments": arguments}) + "\n")
        self._monitor.flush()
        answer = self._answer()
        if "error" in answer:
            raise self._failure(f"QEMU refuses {name}: {answer['error']['desc']}")

    def _answer(self):
        while True:
            try:
                line = self._monitor.readline()
            except OSError:
                line = ""
            if not line:
                raise self._failure("QEMU's monitor doesn't answer")
            answer = json.loads(line)
            if "event" not in answer:
                return answer
