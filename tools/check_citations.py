#!/usr/bin/env python3
"""Fails when a paper key such as [MS06], used anywhere in sources or docs, is not defined by a line
starting with that key (a list item or heading) in docs/references.md."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
KEY = re.compile(r"\[([A-Z][A-Za-z]{0,5}[0-9]{2}[a-z]?)\]")
DEFINITION = re.compile(r"^[#*\-\s]*\[([A-Za-z]+[0-9]{2}[a-z]?)\]", re.MULTILINE)
FOLDERS = ["kernel", "blends", "io", "cli", "tests", "bench", "examples", "docs"]


def main():
    references = ROOT / "docs" / "references.md"
    defined = set(DEFINITION.findall(references.read_text(encoding="utf-8")))
    faults = []
    files = [ROOT / "README.md"]
    for folder in FOLDERS:
        files += sorted(f for f in (ROOT / folder).rglob("*") if f.suffix in (".h", ".cpp", ".md"))
    for file in files:
        if not file.exists():
            continue
        for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
            for key in KEY.findall(line):
                if key not in defined:
                    faults.append(f"{file.relative_to(ROOT)}:{number}: [{key}] is not in docs/references.md")
    print("\n".join(faults) if faults else "citations: clean")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
