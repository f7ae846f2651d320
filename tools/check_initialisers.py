#!/usr/bin/env python3
"""check_initialisers.py ARCHIVE...: fails where a constant of ours waits for an initialiser.

A program whose own static objects use the library gets zeros then: its objects come before the
archives in link order. Constants are constexpr or constinit, made in functions, or functions. What
includes CGAL has initialisers of others, which do not matter; there it may have no variables at
namespace scope that begin as zeros.
"""
import re
import subprocess
import sys

INITIALISER = re.compile(r" _GLOBAL__sub_I_")
OF_OTHERS = re.compile(r" [a-zA-Z] (std::__ioinit|guard variable for CGAL::)")
VARIABLE = re.compile(r" [bB] (dupin::.*)")


def faults(archive):
    text = subprocess.run(["nm", "-C", archive], capture_output=True, text=True, check=True).stdout
    for member in re.split(r"\n\n", text):
        if not INITIALISER.search(member):
            continue
        name = member.strip().split("\n")[0].rstrip(":")
        found = [variable for variable in VARIABLE.findall(member)
                 if ")::" not in variable.replace("(anonymous namespace)::", "")]  # of no function
        if found or not OF_OTHERS.search(member):
            yield f"{archive}({name}): {', '.join(found) or 'an initialiser'}"


def main():
    found = [fault for archive in sys.argv[1:] for fault in faults(archive)]
    for fault in found:
        print(f"{fault}: constants must not wait for an initialiser; make it constexpr, constinit or a function")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
