#!/usr/bin/env python3
"""Runs clang-tidy over our sources in a build tree's compile_commands.json, one process per core.
Files that see CGAL are left out: they take a minute each. Tests and benches, which only we compile,
are read with --all."""
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SEES_CGAL = re.compile(r'#\s*include\s*(<CGAL/|"dupin/interop/|"exact)')


def sees_cgal(file):
    """True when the file, or a private header of its own folder that it includes, includes CGAL."""
    text = file.read_text(encoding="utf-8")
    if SEES_CGAL.search(text):
        return True
    quoted = re.findall(r'#\s*include\s*"([^"]+)"', text)
    near = (file.parent / name for name in quoted if not name.startswith("dupin/"))
    return any(header.exists() and sees_cgal(header) for header in near)


def lint(build, file):
    # Options of GCC's are none of clang's.
    ignored = ["--extra-arg=-Wno-unused-command-line-argument", "--extra-arg=-Wno-unknown-warning-option"]
    result = subprocess.run(["clang-tidy", "--quiet", "-p", build, *ignored, str(file)],
                            capture_output=True, text=True)
    return result.returncode, result.stdout


def main():
    build = sys.argv[1]
    commands = json.loads((pathlib.Path(build) / "compile_commands.json").read_text())
    files = sorted({pathlib.Path(c["file"]) for c in commands})
    ours = [f for f in files if f.is_relative_to(ROOT) and not f.is_relative_to(ROOT / "build")]
    if "--all" not in sys.argv:
        product = {"kernel", "blends", "io", "cli"}
        ours = [f for f in ours if f.relative_to(ROOT).parts[0] in product]
    chosen = [f for f in ours if not sees_cgal(f)]
    status = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for code, output in pool.map(lambda file: lint(build, file), chosen):
            if code != 0:
                status = 1
                print(output, end="")
    print(f"clang-tidy: {len(chosen)} of {len(ours)} files, {'faults' if status else 'clean'}")
    return status


if __name__ == "__main__":
    sys.exit(main())
