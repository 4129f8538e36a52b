# SPDX-License-Identifier: MIT
"""A PC with a Linux kernel that has simulated GPIO lines, USB, HID devices and screens, under QEMU.

The machine sees the files of the host, read only, so it runs the programs that were built here as they are, and
writes to one folder that outlives it. Its time is counted in instructions, two nanoseconds each, and leaps to the next
timer where there is nothing to do: sixty frames a second are just that, however busy the host is. But while it waits
for the host's files its time leaps as well, by minutes: nothing that is timed may read or write there.
"""
import gzip
import os
import pathlib
import shutil
import subprocess
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
SKIPPED = 77
APPLETS = "sh mount modprobe mkdir echo sed poweroff chroot cat ls sleep".split()


class Skip(Exception):
    """Why the machine can't be had here."""


def kernel():
    """The folder of the kernel and its modules."""
    found = subprocess.run([HERE / "kernel"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if found.returncode == SKIPPED:
        raise Skip(found.stderr.strip().splitlines()[-1].removeprefix("skipped: "))
    if found.returncode != 0:
        raise RuntimeError(f"no kernel: {found.stderr}")
    return pathlib.Path(found.stdout.strip().splitlines()[-1])


def _cpio_entry(name, mode, data=b"", *, device=(0, 0)):
    """One file of an archive in the format `newc`, which the kernel unpacks as its first file system."""
    fields = [0, mode, 0, 0, 1, 0, len(data), 0, 0, *device, len(name) + 1, 0]
    head = b"070701" + b"".join(b"%08X" % field for field in fields) + name.encode() + b"\0"
    return head + b"\0" * (-len(head) % 4) + data + b"\0" * (-len(data) % 4)


def initial_files(modules, tests):
    """The archive of busybox, the modules, `init`, and the command that it runs."""
    folders, files = {"bin", "dev", "proc", "sys", "run"}, {}
    busybox = pathlib.Path(shutil.which("busybox") or "/bin/busybox").read_bytes()
    files["bin/busybox"] = (0o100755, busybox)
    for applet in APPLETS:
        files[f"bin/{applet}"] = (0o120777, b"busybox")
    files["tests"] = (0o100644, tests.encode())
    files["init"] = (0o100755, (HERE / "init").read_bytes())
    for path in sorted(modules.rglob("*")):
        if path.is_file():
            name = path.relative_to(modules).as_posix()
            files[name] = (0o100644, path.read_bytes())
    for name in files:
        folders.update(parent.as_posix() for parent in pathlib.PurePosixPath(name).parents if parent.name)
    archive = [_cpio_entry(folder, 0o040755) for folder in sorted(folders)]
    archive.append(_cpio_entry("dev/console", 0o020600, device=(5, 1)))
    archive += [_cpio_entry(name, mode, data) for name, (mode, data) in files.items()]
    archive.append(_cpio_entry("TRAILER!!!", 0))
    return gzip.compress(b"".join(archive), 1)


def run(tests, out, *, timeout):
    """Boots once, runs the command line `tests` in the machine, and returns what the machine said on its console. The
    folder `out` is /run/out there."""
    if shutil.which("qemu-system-x86_64") is None:
        raise Skip("qemu-system-x86_64 isn't installed (Debian: qemu-system-x86)")
    if shutil.which("busybox") is None:
        raise Skip("busybox isn't installed (Debian: busybox-static)")
    folder = kernel()
    with tempfile.TemporaryDirectory() as scratch:
        initrd = pathlib.Path(scratch, "initrd.gz")
        initrd.write_bytes(initial_files(folder / "modules", tests))
        command = ["qemu-system-x86_64", "-accel", "tcg", "-icount", "shift=1,sleep=off", "-cpu", "max", "-m", "768",
                   "-nodefaults", "-no-reboot", "-display", "none", "-serial", "stdio",
                   "-kernel", str(folder / "vmlinuz"), "-initrd", str(initrd),
                   "-append", "console=ttyS0 quiet panic=-1 mitigations=off",
                   "-fsdev", "local,id=host,path=/,security_model=none,readonly=on,multidevs=remap",
                   "-device", "virtio-9p-pci,fsdev=host,mount_tag=host",
                   "-fsdev", f"local,id=out,path={out},security_model=none",
                   "-device", "virtio-9p-pci,fsdev=out,mount_tag=out"]
        begun = time.monotonic()
        machine = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        try:
            said, _ = machine.communicate(timeout=timeout)
        except subprocess.TimeoutExpired:
            machine.kill()
            said, _ = machine.communicate()
            raise RuntimeError(f"the machine hadn't ended after {timeout} s; it said:\n"
                               + said.decode(errors="replace")) from None
        print(f"the machine ran for {time.monotonic() - begun:.1f} s")
        return said.decode(errors="replace")
