# SPDX-License-Identifier: MIT
"""As much of GDB's remote protocol as it takes to stop a machine where it writes a register of a device."""
import socket
import time

from qemu import Failure


class Debugger:
    """Talks to QEMU's gdbstub on a Unix socket; the machine must have been started with `arguments(path)`."""

    @staticmethod
    def arguments(path):
        """QEMU arguments: listen there, and don't run before told."""
        return ["-S", "-chardev", f"socket,id=gdb,path={path},server=on,wait=off", "-gdb", "chardev:gdb"]

    def __init__(self, path, timeout=60):
        self._pending = b""
        self._watched = []
        self._stopped_at_write = False
        deadline = time.monotonic() + timeout
        while True:
            self._socket = socket.socket(socket.AF_UNIX)
            try:
                self._socket.connect(path)
                break
            except OSError:
                self._socket.close()
                if time.monotonic() > deadline:
                    raise Failure("QEMU's debugger port doesn't answer") from None
                time.sleep(0.01)
        self._socket.settimeout(timeout)
        self._ask("?")

    def close(self):
        self._socket.close()

    def watch_writes(self, address, length=4):
        """Stops the machine before each write to these bytes."""
        self._watched.append((address, length))
        self._command(f"Z2,{address:x},{length:x}")

    def stop_watching(self, address, length=4):
        """Undoes `watch_writes`."""
        self._watched.remove((address, length))
        self._command(f"z2,{address:x},{length:x}")

    def resume(self):
        """Lets the machine run to the next watched write; returns the watched address."""
        if self._stopped_at_write:
            # QEMU stops before the write, so it would stop there again.
            for address, length in self._watched:
                self._command(f"z2,{address:x},{length:x}")
            self._ask("s")
            for address, length in self._watched:
                self._command(f"Z2,{address:x},{length:x}")
        answer = self._ask("c")
        for field in answer[3:].split(";"):
            name, _, value = field.partition(":")
            if name == "watch":
                self._stopped_at_write = True
                return int(value, 16)
        raise Failure(f"the machine stopped for another reason than a watched write: {answer}")

    def word(self, address):
        """The 32-bit word at an address."""
        return int.from_bytes(bytes.fromhex(self._ask(f"m{address:x},4")), "little")

    def arm_registers(self):
        """(r0..r15, cpsr)."""
        numbers = bytes.fromhex(self._ask("g"))
        general = [int.from_bytes(numbers[4 * i:4 * i + 4], "little") for i in range(16)]
        # Eight registers of 12 bytes and a status word of a coprocessor long gone lie between.
        status = 16 * 4 + 8 * 12 + 4
        return general, int.from_bytes(numbers[status:status + 4], "little")

    def _command(self, command):
        answer = self._ask(command)
        if answer != "OK":
            raise Failure(f"QEMU's debugger port answers '{command}' with '{answer}'")

    def _ask(self, command):
        packet = command.encode()
        self._socket.sendall(b"$" + packet + b"#%02x" % (sum(packet) & 255))
        try:
            while True:
                start, end = self._pending.find(b"$"), self._pending.find(b"#")
                if 0 <= start < end and len(self._pending) >= end + 3:
                    break
                received = self._socket.recv(65536)
                if not received:
                    raise Failure("QEMU ended while being debugged")
                self._pending += received
        except TimeoutError:
            raise Failure(f"QEMU's debugger port doesn't answer '{command}'") from None
        answer = self._pending[start + 1:end].decode()
        self._pending = self._pending[end + 3:]
        self._socket.sendall(b"+")
        return answer
