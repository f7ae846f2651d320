#!/usr/bin/env python3
"""check_symbols.py ARCHIVE...: fails where one name stands for two things.

Two types of one name in one namespace are undefined behaviour that no compiler reports: the linker
keeps one of their inline functions for both. Built with -O0 each object has its own copy of every
inline function it uses, so the copies can be compared: those of one symbol must have the same
bytes. Relocations are not part of them, so where a function lies does not matter. Nor may a
function be inline in one object and not in another: the linker keeps the latter for both.
"""
import collections
import hashlib
import struct
import sys

OURS = b"5dupin"  # as mangled
GLOBAL, WEAK = 1, 2


def members(path):
    """The (name, bytes) of the objects of an archive."""
    data = open(path, "rb").read()
    if data[:8] != b"!<arch>\n":
        yield path, data
        return
    at, names = 8, b""
    while at < len(data):
        name = data[at:at + 16].rstrip()
        size = int(data[at + 48:at + 58])
        body = data[at + 60:at + 60 + size]
        at += 60 + size + size % 2
        if name == b"//":
            names = body
        elif name not in (b"/", b"/SYM64/"):
            if name[:1] == b"/":
                start = int(name[1:])
                name = names[start:names.index(b"\n", start)]
            yield name.rstrip(b"/").decode(), body


def symbols(elf):
    """The (binding, mangled name, bytes) of the global and weak symbols that a 64-bit little-endian
    object defines."""
    if elf[:6] != b"\x7fELF\x02\x01":
        raise ValueError("not a 64-bit little-endian ELF object")
    table, = struct.unpack_from("<Q", elf, 40)
    entry, count = struct.unpack_from("<HH", elf, 58)
    sections = [struct.unpack_from("<IIQQQQIIQQ", elf, table + i * entry) for i in range(count)]
    if count == 0:  # more than 65279: the first section says how many
        count = struct.unpack_from("<IIQQQQIIQQ", elf, table)[5]
        sections = [struct.unpack_from("<IIQQQQIIQQ", elf, table + i * entry) for i in range(count)]
    for section in sections:
        if section[1] != 2:  # SHT_SYMTAB
            continue
        strings = sections[section[6]]
        for at in range(section[4], section[4] + section[5], 24):
            name, info, _, index, value, size = struct.unpack_from("<IBBHQQ", elf, at)
            if info >> 4 not in (GLOBAL, WEAK) or not 0 < index < 0xff00 or size == 0:
                continue
            start = strings[4] + name
            text = elf[start:elf.index(b"\0", start)]
            home = sections[index]
            body = b"" if home[1] == 8 else elf[home[4] + value:home[4] + value + size]
            yield info >> 4, text, body


def main():
    copies = collections.defaultdict(dict)  # inline symbol -> digest -> where
    homes = {}  # of the others
    for path in sys.argv[1:]:
        for member, elf in members(path):
            for binding, name, body in symbols(elf):
                if OURS not in name:
                    continue
                if binding == GLOBAL:
                    homes[name] = f"{path}({member})"
                else:
                    digest = hashlib.sha256(body).hexdigest()
                    copies[name].setdefault(digest, f"{path}({member})")
    if not copies:
        print("check_symbols: no weak symbol of ours; built without -O0?")
        return 1
    faults = [f"{name.decode()}: differs in {', '.join(where.values())}"
              for name, where in sorted(copies.items()) if len(where) > 1]
    faults += [f"{name.decode()}: inline in {', '.join(copies[name].values())}, not in {home}"
               for name, home in sorted(homes.items()) if name in copies]
    print("\n".join(faults) if faults else f"symbols: {len(copies)} names, each one thing")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
