#!/usr/bin/env python3
"""Unions of pipes by us and by others: who is faster, where our time goes, and how it grows.

Usage: bench/rivals.py BUILD_FOLDER [table|files|growth|threads ...] [--cases NAME ...] [--limit SECONDS]
       [--repetitions N]
  table    make (solids of meshes), op (their union) and round (a mesh of it), ours and Manifold's
  files    file to file, verified, in binary STL and OFF: the tool, Manifold and CGAL's corefinement
  growth   our stages, their exponents in triangles, operands and crossings, and memory
  threads  what the second thread gains, stage by stage
All without a word. Each engine does each case in a process of its own, which is ended after the
limit: no crash and no case without end stops the table. Seconds of wall, minima over repetitions;
[processor seconds] beside them say what a busy machine hides.
"""
import argparse
import math
import os
import pathlib
import subprocess
import tempfile
import threading
import time

# Of issue 16, then what is unfavourable.
FIRST = ["tee_10k", "tee_1M_rot", "tee_100k_rot", "header_100_rot", "header_1000", "header_1000_rot", "rack",
         "rack_rot", "rack_fine", "rack_fine_rot", "rack_eq", "blend_1", "chain_100", "chain_100_fan"]
STARS = [f"{family}_{count}" for family in ["star", "star_general", "coaxial"] for count in [5, 10, 20, 40, 60, 100]]
RACKS = [f"{family}_{count}{turn}" for family in ["rack", "rack_eq"] for turn in ["", "_rot"]
         for count in [5, 10, 40, 60]]
BUNDLES = ["bundle_1000", "bundle_1000_rot", "coaxial_60_rot", "star_20_rot"]
CASES = FIRST + STARS + RACKS + BUNDLES
FILES = ["tee_10k", "tee_100k_rot", "tee_1M_rot", "header_100_rot", "rack_fine_rot", "chain_100"]
GROWTH = {
    "triangles": ([f"tee_thousands_{count}_rot" for count in [10, 40, 100, 400, 1000, 4000]], "before"),
    "operands": ([f"header_coarse_{count}_rot" for count in [10, 100, 1000, 10000]], "operands"),
    "operands apart": ([f"row_{count}" for count in [10, 100, 1000, 10000]], "operands"),
    "crossings": ([f"rack_{count}_rot" for count in [5, 10, 20, 40, 60]], "crossings"),
    "equal crossings": ([f"rack_eq_{count}" for count in [5, 10, 20, 40, 60]], "crossings"),
    "pipes through a point": ([f"star_{count}" for count in [5, 10, 20, 40]], "operands"),
}
STEPS = ["make", "op", "round"]


class Run:
    """What one engine printed about one case: minima of {step: (wall, processor)}, or how it ended."""

    def __init__(self, lines, ending):
        self.times, self.result, self.ending = {}, {}, ending
        for line in lines:
            words = line.split()
            if words[0] == "result":
                keys = ["before", "after", "volume", "operands", "memory"]
                self.result = dict(zip(keys, map(float, words[1:])))
                self.result["crossings"] = self.result["operands"] ** 2 / 4
            elif words[0] == "invalid":
                self.ending = self.ending or "invalid: " + " ".join(words[1:])
            else:
                step, took = " ".join(words[:-2]), (float(words[-2]), float(words[-1]))
                best = self.times.get(step, took)
                self.times[step] = (min(best[0], took[0]), min(best[1], took[1]))

    def took(self, *steps, clock=0):
        """The sum, by the wall's clock (0) or the processors' (1); None if a step was not reached."""
        return sum(self.times[step][clock] for step in steps) if all(step in self.times for step in steps) else None

    def text(self, step):
        if step not in self.times:
            return self.ending
        return f"{self.times[step][0]:.4f} [{self.times[step][1]:.4f}]"


def run_for(command, limit):
    """Lines of output, how it ended ("" if well), wall seconds, processor seconds, peak bytes."""
    start = time.monotonic()
    with subprocess.Popen([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                          text=True) as process:
        late = threading.Event()

        def end():
            late.set()
            process.kill()

        timer = threading.Timer(limit, end)
        timer.start()
        output = process.stdout.read()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        timer.cancel()
    ending = f">{limit:g}" if late.is_set() else "" if process.returncode == 0 else f"exit {process.returncode}"
    return (output.splitlines(), ending, time.monotonic() - start, usage.ru_utime + usage.ru_stime,
            usage.ru_maxrss * 1024)


def compete(options, engine, case, threads=2):
    # One repetition may take as long as the limit; no other begins after a sixth of it.
    command = [options.build / "bench" / engine, case, options.repetitions, options.limit / 6, threads]
    lines, ending, *_ = run_for(command, options.limit)
    return Run(lines, ending)


def ratio(mine, theirs):
    return theirs / mine if mine and theirs else None


def shown(value, form="{:.2f}"):
    return "-" if value is None else form.format(value)


def geometric_mean(values):
    values = [value for value in values if value]
    return math.exp(sum(map(math.log, values)) / len(values)) if values else None


def print_means(title, ratios):
    """`ratios`: per case, one per kind; None where somebody did not end."""
    print(f"{title:22}" + ", ".join(f"{kind} {shown(geometric_mean(values))}x" for kind, values in ratios.items()))


def table(options):
    rival = (options.build / "bench" / "manifold_contest").exists()
    print("ours / Manifold's; seconds of wall [of processors], minima; x: its time in units of ours; all: make + op "
          "+ round,\nof Manifold without its last step, which only hands out the mesh")
    print(f"{'case':18}{'triangles':>9} {'of results':^19} {'make':^36} {'op':^36} {'x':>7} {'round':^36} {'all x':>7}  of the other")
    rows, slower = {}, []
    for case in options.cases or CASES:
        ours = compete(options, "union_contest", case)
        other = compete(options, "manifold_contest", case) if rival else Run([], "not built")
        rows[case] = [ratio(ours.took(*mine, clock=clock), other.took(*theirs, clock=clock))
                      for clock in (0, 1) for mine, theirs in [(["op"], ["op"]), (STEPS, ["make", "op"])]]
        op, whole = rows[case][:2]
        notes = other.ending
        if ours.ending:
            notes += f" OURS: {ours.ending}"
        volumes = [run.result.get("volume") for run in (ours, other)]
        if None not in volumes and abs(volumes[0] - volumes[1]) > 1e-9 * abs(volumes[0]):
            notes += f" volume {volumes[1]:.9g}, ours {volumes[0]:.9g}"
        if any(value is not None and value < 1 for value in (op, whole)):
            slower.append(case)
        pairs = [f"{ours.text(step)} / {other.text(step)}" for step in STEPS]
        sizes = " / ".join(f"{run.result.get('after', 0):.0f}" for run in (ours, other))
        print(f"{case:18}{ours.result.get('before', 0):9.0f} {sizes:^19} {pairs[0]:^36} {pairs[1]:^36} {shown(op):>7} "
              f"{pairs[2]:^36} {shown(whole):>7}  {notes}", flush=True)
    for title, names in [("first fourteen", FIRST), ("all", list(rows))]:
        found = [rows[name] for name in names if name in rows]
        if found:
            kinds = ["op", "all", "op of processors", "all of processors"]
            print_means(title, {kind: [row[i] for row in found] for i, kind in enumerate(kinds)})
    print("slower than Manifold:", ", ".join(slower) or "nowhere")


def file_runs(options, case, extension, folder):
    """Per engine the best wall seconds with its processor seconds, or how it ended; the tool's peak memory."""
    made = subprocess.run([options.build / "bench" / "pipe_case_files", case, folder, extension], check=True,
                          capture_output=True, text=True).stdout.split()
    out = pathlib.Path(folder) / f"out.{extension}"
    bench = options.build / "bench"
    commands = {"ours": [options.build / "cli" / "dupin", "union", *made, "-o", out, "-q"],
                "Manifold": [bench / "manifold_files", out, *made],
                "corefinement": [bench / "corefinement_files", out, *made]}
    best, peak = {}, 0
    for engine, command in commands.items():
        if not command[0].exists():
            continue
        for _ in range(options.repetitions):
            _, ending, wall, processor, memory = run_for(command, options.limit)
            if ending:
                best[engine] = ending
                break
            best[engine] = min(best.get(engine, (wall, processor)), (wall, processor))
            if engine == "ours":
                peak = max(peak, memory)
            if wall > options.limit / 6:
                break
    return best, peak


def files(options):
    print("file to file; seconds of wall [of processors]; memory: of the tool at its peak, in MB")
    print(f"{'case':22}{'ours, verified':>20}{'Manifold':>20}{'x':>7}{'corefinement':>20}{'x':>7}{'memory':>8}")
    means = {"Manifold": [], "corefinement": []}
    for case in options.cases or FILES:
        for extension in ["stl", "off"]:
            with tempfile.TemporaryDirectory() as folder:
                best, peak = file_runs(options, case, extension, folder)
            texts, ratios = {}, {}
            for engine in ["ours", *means]:
                took = best.get(engine, "not built")
                texts[engine] = took if isinstance(took, str) else f"{took[0]:.3f} [{took[1]:.3f}]"
                if engine != "ours":
                    both = [best.get(name) for name in ("ours", engine)]
                    ratios[engine] = None if any(not isinstance(t, tuple) for t in both) else both[1][0] / both[0][0]
                    means[engine].append(ratios[engine])
            print(f"{case + '.' + extension:22}{texts['ours']:>20}{texts['Manifold']:>20}"
                  f"{shown(ratios['Manifold']):>7}{texts['corefinement']:>20}{shown(ratios['corefinement']):>7}"
                  f"{peak / 1e6:8.0f}", flush=True)
    print_means("geometric mean", means)


def slope(points):
    """Of a line through (log x, log y) by least squares; None for fewer than two points."""
    points = [(math.log(x), math.log(y)) for x, y in points if x and y]
    if len(points) < 2:
        return None
    middle = [sum(axis) / len(points) for axis in zip(*points)]
    return (sum((x - middle[0]) * (y - middle[1]) for x, y in points) /
            sum((x - middle[0]) ** 2 for x, _ in points))


def growth(options):
    print("ours, seconds of processors; the last lines: exponents over all, and over the two largest")
    for title, (names, size) in GROWTH.items():
        print(f"\nin {title}")
        runs = [compete(options, "union_contest", name) for name in names]
        steps = list(dict.fromkeys(step for run in runs for step in run.times))
        print(f"{'case':26}{size:>10}" + "".join(f"{step.split()[-1]:>12}" for step in steps) + f"{'bytes/tri':>11}")
        for name, run in zip(names, runs):
            of_size = shown(run.result.get(size), "{:.0f}")
            triangles = run.result.get("before", 0) + run.result.get("after", 0)
            print(f"{name:26}{of_size:>10}" +
                  "".join(f"{shown(run.times.get(step, (None, None))[1], '{:.4f}'):>12}" for step in steps) +
                  f"{run.result.get('memory', 0) / max(triangles, 1):11.0f}  {run.ending}")
        for text, chosen in [("exponent", runs), ("exponent at the end", runs[-2:])]:
            print(f"{text:36}" + "".join(
                "{:>12}".format(shown(slope([(run.result.get(size), run.times.get(step, (0, 0))[1]) for run in chosen])))
                for step in steps))


def threads(options):
    print("ours: wall seconds of one thread in units of those of two [processors that the two had on average]")
    for case in options.cases or ["tee_100k_rot", "tee_1M_rot", "header_100_rot", "header_1000_rot", "rack_rot",
                                  "rack_fine_rot", "rack_eq", "chain_100", "chain_100_fan"]:
        one, two = (compete(options, "union_contest", case, count) for count in (1, 2))
        gains = [f"{step.removeprefix('stage ')} {shown(ratio(two.took(step), one.took(step)))} "
                 f"[{shown(ratio(two.took(step), two.took(step, clock=1)))}]" for step in two.times]
        print(f"{case:18}" + ", ".join(gains), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    tasks = {"table": table, "files": files, "growth": growth, "threads": threads}
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("tasks", nargs="*", choices=[*tasks, []], metavar="TASK")
    parser.add_argument("--cases", nargs="+")
    parser.add_argument("--limit", type=float, default=60)
    parser.add_argument("--repetitions", type=int, default=5)
    options = parser.parse_args()
    for name in options.tasks or tasks:
        tasks[name](options)


if __name__ == "__main__":
    main()
