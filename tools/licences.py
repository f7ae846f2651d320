#!/usr/bin/env python3
"""Which licences the headers of CGAL carry that the product was compiled from, as the build recorded
them (ninja's dependency log). Fails if one under the GPL is seen outside of what DUPIN_CROSS_CHECK=OFF
and DUPIN_MESHING=OFF leave out. Usage: tools/licences.py BUILD_FOLDER"""
import collections
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PRODUCT = ["kernel/src", "blends/src", "io/src", "cli"]
OPTIONAL = ("kernel/src/cross_check/", "kernel/src/meshing/delaunay_refinement.cpp")
SPDX = re.compile(r"SPDX-License-Identifier:\s*(.+)")


def objects(build):
    """The product's object files with their sources."""
    for entry in json.loads((build / "compile_commands.json").read_text(encoding="utf-8")):
        source = pathlib.Path(entry["directory"], entry["file"]).resolve()
        if source.is_relative_to(ROOT):
            path = source.relative_to(ROOT).as_posix()
            if path.startswith(tuple(room + "/" for room in PRODUCT)):
                yield re.search(r" -o (\S+)", entry["command"]).group(1), path


def headers_of(build, outputs):
    """The headers of CGAL that went into each object."""
    log = subprocess.run(["ninja", "-C", str(build), "-t", "deps", *outputs],
                         capture_output=True, text=True, check=True).stdout
    headers = collections.defaultdict(list)
    for line in log.splitlines():
        if line.startswith("    "):
            if "/CGAL/" in line:
                headers[current].append(line.strip())
        elif ": #deps" in line:
            current = line.split(":", 1)[0]
            headers[current] = []
    return headers


def licence_of(header):
    match = SPDX.search(pathlib.Path(header).read_text(encoding="utf-8", errors="replace")[:4000])
    return match.group(1).strip() if match else "none stated"


def main():
    build = pathlib.Path(sys.argv[1])
    sources = dict(objects(build))
    headers = headers_of(build, list(sources))
    if missing := sorted(sources[output] for output in sources if output not in headers):
        print(f"not built yet, so nothing is known of them: {', '.join(missing)}")
        return 1
    licences = {header: licence_of(header) for seen in headers.values() for header in seen}
    is_gpl = {header: licence.startswith("GPL") for header, licence in licences.items()}
    everywhere = {header for output, seen in headers.items() for header in seen
                  if not sources[output].startswith(OPTIONAL)}
    for title, chosen in [("what can be left out, alone", set(licences) - everywhere),
                          ("everything else", everywhere)]:
        print(f"headers of CGAL in {title}:")
        for licence, count in collections.Counter(licences[h] for h in chosen).most_common():
            print(f"  {count:5} {licence}")
    if not everywhere:
        print("no header of CGAL at all: this cannot be right")
        return 1
    faults = [f"{sources[output]} sees {header}, which is under the GPL"
              for output, seen in headers.items() for header in seen
              if is_gpl[header] and header in everywhere
              and not sources[output].startswith(OPTIONAL)]
    print("\n".join(sorted(faults)) if faults else "licences: clean")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
