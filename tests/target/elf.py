# SPDX-License-Identifier: MIT
"""Symbols and sections of 32-bit little-endian ELF files, whatever the machine."""
import struct
from collections import namedtuple

Section = namedtuple("Section", "name kind flags address size link data")
Symbol = namedtuple("Symbol", "name value size kind section")

ALLOCATED, WRITABLE = 2, 1
NO_BITS, SYMBOL_TABLE = 8, 2
UNDEFINED = 0


class File:
    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        if data[:6] != b"\x7fELF\x01\x01":
            raise ValueError(f"{path} isn't a 32-bit little-endian ELF file")
        start, = struct.unpack_from("<I", data, 32)
        entry_size, count, names = struct.unpack_from("<HHH", data, 46)
        headers = [struct.unpack_from("<10I", data, start + i * entry_size) for i in range(count)]
        name_table = _body(data, headers[names])
        self.sections = [Section(_text(name_table, h[0]), h[1], h[2], h[3], h[5], h[6], _body(data, h))
                         for h in headers]

    def symbols(self):
        """All named symbols, those that are only referred to included."""
        for table in self.sections:
            if table.kind != SYMBOL_TABLE:
                continue
            strings = self.sections[table.link].data
            for name, value, size, info, _, section in struct.iter_unpack("<IIIBBH", table.data):
                if name:
                    yield Symbol(_text(strings, name), value, size, info & 15, section)

    def bytes_of_code(self):
        """Bytes that an image takes of read-only memory, initial values of variables included."""
        return sum(s.size for s in self.sections if s.flags & ALLOCATED and s.kind != NO_BITS)

    def bytes_of_variables(self):
        """Bytes of static RAM."""
        return sum(s.size for s in self.sections if s.flags & ALLOCATED and s.flags & WRITABLE)


def _body(data, header):
    return b"" if header[1] == NO_BITS else data[header[4]:header[4] + header[5]]


def _text(table, start):
    return table[start:table.index(b"\0", start)].decode()
