# SPDX-License-Identifier: MIT
"""Compares what a board drew with what the simulator drew."""
from qemu import Failure

FRAMES = 120
# Size of a pixel on QEMU's display; what it shows of a colour component.
DISPLAYS = {
    "clcd": (1, lambda component: component & 0xF8),
    "oled": (4, lambda component: component),
}


def digests(text):
    return [line for line in text.splitlines() if line.startswith("frame ")]


def compare_digests(expected, got):
    if len(expected) != FRAMES or len(got) != FRAMES:
        raise Failure(f"{len(expected)} digests from the simulator and {len(got)} from the board, not {FRAMES}")
    different = [(a, b) for a, b in zip(expected, got) if a != b]
    if different:
        raise Failure(f"{len(different)} of {FRAMES} frames differ; the first: simulator '{different[0][0]}', "
                      f"board '{different[0][1]}'")


def compare_pictures(drawn, shown, magnification, depth):
    expected = [[tuple(map(depth, colour)) for colour in row for _ in range(magnification)]
                for row in drawn for _ in range(magnification)]
    sizes = [(len(picture[0]), len(picture)) for picture in (expected, shown)]
    if sizes[0] != sizes[1]:
        raise Failure(f"the display shows {sizes[1]} pixels, not {sizes[0]}")
    different = [(x, y) for y, (a, b) in enumerate(zip(expected, shown)) if a != b
                 for x in range(len(a)) if a[x] != b[x]]
    if different:
        x, y = different[0]
        raise Failure(f"{len(different)} pixels of the display differ; the first, ({x}, {y}), is "
                      f"{shown[y][x]}, should be {expected[y][x]}")
    if len(set(colour for row in shown for colour in row)) < 2:
        raise Failure("the display shows one colour only; nothing is compared")
