#!/usr/bin/env python3
"""check_symbols.py ARCHIVE...: fails where one name stands for two functions.

Two functions of one name, an inline one in a header and another elsewhere or those of two types of
one name, are undefined behaviour that no compiler reports: the linker keeps one for both. The debug
information of each object (-g1 is enough, optimised or not) says in which line a function that it
defines or inlines is written, so it has to be one line in all of them. That no two types have one
name is read in the sources, by check_layers.py: some have no function of their own.
"""
import collections
import os
import re
import subprocess
import sys

OURS = re.compile(r"_ZN?[rVK]*[RO]?5dupin")  # as mangled
DIE = re.compile(r" <\w+><(\w+)>: Abbrev Number: \d+ \(DW_TAG_(\w+)\)")
ATTRIBUTE = re.compile(r"    <\w+>   DW_AT_(decl_file|decl_line|linkage_name|declaration|specification|artificial) *: (.*)")
ROOM = re.compile(r".*/(?=(?:kernel|blends|io)/(?:src|include)/)")  # objects from a cache name other checkouts
ENTRY = re.compile(r"  \d+\t(?:\(udata\)\t(\d+)\t)?\(\w+\)\t\(offset: \w+\): (.*)")


def readelf(what, archive):
    process = subprocess.Popen(["readelf", "--wide", f"--debug-dump={what}", archive], text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    yield from process.stdout
    if process.wait() != 0:
        raise RuntimeError(f"readelf cannot read {archive}")


def file_tables(archive):
    """The paths of the files of one object after the other, as its functions refer to them."""
    tables, folders, files = [[]], [], []
    for line in readelf("rawline", archive):
        if line.startswith("File: "):
            tables.append([])
        elif line.startswith(" The Directory Table"):
            folders, files = [], None
        elif line.startswith(" The File Name Table"):
            files = tables[-1]
        elif match := ENTRY.match(line):
            if files is None:
                folders.append(match[2])
            else:
                path = os.path.normpath(os.path.join(folders[0], folders[int(match[1])], match[2]))
                files.append(ROOM.sub("", path))
    return tables


def functions(archive):
    """The (mangled name, file and line, object) of all functions of ours that objects define or inline."""
    tables = iter(file_tables(archive))
    member, files, die, dies = archive, next(tables), None, {}

    def place(one):
        declared = {**dies.get(one.get("specification"), {}), **one}
        if not {"decl_file", "decl_line"} <= declared.keys():
            return None
        return f"{files[int(declared['decl_file'])]}:{declared['decl_line']}"

    def found():
        for one in dies.values():
            name = one.get("linkage_name") or dies.get(one.get("specification"), {}).get("linkage_name", "")
            is_definition = "declaration" not in one and "artificial" not in one
            if is_definition and OURS.match(name) and (where := place(one)):
                yield name, where, member

    for line in readelf("info", archive):
        if match := DIE.match(line):
            die = dies.setdefault(match[1], {}) if match[2] == "subprogram" else None
        elif line.startswith("File: "):
            yield from found()
            member, files, die, dies = line[6:].strip(), next(tables), None, {}  # two objects may have one name
        elif die is not None and (match := ATTRIBUTE.match(line)):
            # "(form) value" or "(form) (offset: 0x..): value"
            die[match[1]] = match[2].rsplit(" ", 1)[-1].removeprefix("<0x").rstrip(">")
    yield from found()


def main():
    places = collections.defaultdict(dict)  # name -> place -> object
    for archive in sys.argv[1:]:
        for name, where, member in functions(archive):
            places[name].setdefault(where, member)
    if not places:
        print("check_symbols: no function of ours; built without -g1?")
        return 1
    several = {name: where for name, where in places.items() if len(where) > 1}
    for name, where in sorted(several.items()):
        print(f"check_symbols: {name} is {' and '.join(f'{line} in {member}' for line, member in sorted(where.items()))}")
    if not several:
        print(f"check_symbols: {len(places)} functions, one place each")
    return 1 if several else 0


if __name__ == "__main__":
    sys.exit(main())
