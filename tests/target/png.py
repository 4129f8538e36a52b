# SPDX-License-Identifier: MIT
"""Reads PNG pictures (8 bits a channel or palettes, not interlaced) as rows of (red, green, blue)."""
import struct
import zlib


def read(path):
    """The picture as a list of rows, each a list of (red, green, blue)."""
    with open(path, "rb") as file:
        data = file.read()
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        raise ValueError(f"{path} isn't a PNG file")
    header, colours, packed = None, b"", b""
    at = 8
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        at += 12 + length
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", body)
        elif kind == b"PLTE":
            colours = body
        elif kind == b"IDAT":
            packed += body
    width, height, depth, kind, _, _, interlaced = header
    channels = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}[kind]
    if interlaced or (depth != 8 and kind not in (0, 3)) or depth > 8:
        raise ValueError(f"{path}: a kind of PNG that isn't read here")
    rows = _unfilter(zlib.decompress(packed), height, (width * channels * depth + 7) // 8,
                     max(1, channels * depth // 8))
    return [_colours(row, width, depth, kind, channels, colours) for row in rows]


def _unfilter(data, height, stride, step):
    rows, above = [], bytes(stride)
    for y in range(height):
        start = y * (stride + 1)
        method, row = data[start], bytearray(data[start + 1:start + 1 + stride])
        if method:
            for i in range(stride):
                left = row[i - step] if i >= step else 0
                corner = above[i - step] if i >= step else 0
                row[i] = (row[i] + (left, above[i], (left + above[i]) // 2,
                                    _paeth(left, above[i], corner))[method - 1]) & 255
        above = bytes(row)
        rows.append(above)
    return rows


def _paeth(left, above, corner):
    guess = left + above - corner
    return min((left, above, corner), key=lambda value: abs(guess - value))


def _colours(row, width, depth, kind, channels, colours):
    if kind in (2, 6):
        return [tuple(row[i:i + 3]) for i in range(0, width * channels, channels)]
    mask = (1 << depth) - 1
    values = [row[x * channels * depth // 8] >> (8 - depth - x * depth % 8) & mask for x in range(width)]
    if kind == 3:
        return [tuple(colours[3 * v:3 * v + 3]) for v in values]
    return [(v * 255 // mask,) * 3 for v in values]
