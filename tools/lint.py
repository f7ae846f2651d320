#!/usr/bin/env python3
"""lint.py BUILD [--since REVISION] [--all]: runs clang-tidy over our sources in a build tree's
compile_commands.json, one process per core.

Files that see CGAL are left out: they take a minute each. With --since, only what a change since
that revision can be seen in is read: the changed files, and the files that include a changed header.
Tests and benches, which only we compile, are read with --all.
"""
import argparse
import concurrent.futures
import functools
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
SEES_CGAL = re.compile(r'#\s*include\s*(<CGAL/|"dupin/interop/)')
QUOTED = re.compile(r'#\s*include\s*"([^"]+)"')


@functools.cache
def text_of(file):
    return file.read_text(encoding="utf-8")


@functools.cache
def included(file):
    """The headers of ours that a file includes itself."""
    room = file.relative_to(ROOT).parts[0]
    found = set()
    for name in QUOTED.findall(text_of(file)):
        owner = name.split("/")[1] if name.startswith("dupin/") else room
        for folder in (file.parent, ROOT / owner / "include", ROOT / room / "src", ROOT / room, ROOT / "tests"):
            if (folder / name).exists():
                found.add((folder / name).resolve())
                break
    return found


@functools.cache
def closure(file):
    """The file and all headers of ours that it comes to see."""
    seen, todo = {file}, [file]
    while todo:
        for header in included(todo.pop()) - seen:
            seen.add(header)
            todo.append(header)
    return seen


def sees_cgal(file):
    return any(SEES_CGAL.search(text_of(seen)) for seen in closure(file))


def changed_since(revision):
    out = subprocess.run(["git", "diff", "--name-only", "--diff-filter=d", revision, "--"], cwd=ROOT,
                         capture_output=True, text=True, check=True).stdout
    return {ROOT / name for name in out.split()}


def without_precompiled(command):
    """Clang cannot read GCC's precompiled headers, and files shall not rely on them."""
    return re.sub(r"-Winvalid-pch|-fpch-preprocess|-include \S+/cmake_pch\.hxx", "", command)


def lint(build, file):
    # Options of GCC's are none of clang's.
    ignored = ["--extra-arg=-Wno-unused-command-line-argument", "--extra-arg=-Wno-unknown-warning-option"]
    result = subprocess.run(["clang-tidy", "--quiet", "-p", build, *ignored, str(file)],
                            capture_output=True, text=True)
    # What stops it altogether is said on the other stream.
    return result.returncode, result.stdout or result.stderr


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--since")
    parser.add_argument("--all", action="store_true")
    options = parser.parse_args()
    commands = json.loads((options.build / "compile_commands.json").read_text())
    files = sorted({pathlib.Path(c["file"]) for c in commands})
    ours = [f for f in files if f.is_relative_to(ROOT) and not f.is_relative_to(ROOT / "build")]
    if not options.all:
        product = {"kernel", "blends", "io", "cli"}
        ours = [f for f in ours if f.relative_to(ROOT).parts[0] in product]
    chosen = [f for f in ours if not sees_cgal(f)]
    if options.since:
        changed = changed_since(options.since)
        if ROOT / ".clang-tidy" not in changed:
            chosen = [f for f in chosen if closure(f) & changed]
    status = 0
    with tempfile.TemporaryDirectory() as plain, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for command in commands:
            command["command"] = without_precompiled(command["command"])
        (pathlib.Path(plain) / "compile_commands.json").write_text(json.dumps(commands))
        for file, (code, output) in zip(chosen, pool.map(lambda file: lint(plain, file), chosen)):
            if code != 0:
                status = 1
                print(output or f"{file}: clang-tidy ends with {code}\n", end="")
    print(f"clang-tidy: {len(chosen)} of {len(ours)} files, {'faults' if status else 'clean'}")
    return status


if __name__ == "__main__":
    sys.exit(main())
