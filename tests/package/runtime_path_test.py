"""runtime_path_test.py BUILD FILE...: none of these files of the build tree looks for libraries in the working directory, which
an empty entry of its path means, and the installed tool looks for them beside itself alone."""
import pathlib
import subprocess
import sys
import tempfile


def paths(file):
    """The entries of its runtime path; none without one."""
    said = subprocess.run(["readelf", "-d", file], capture_output=True, text=True, check=True).stdout
    return [entry for line in said.splitlines() if "(RUNPATH)" in line or "(RPATH)" in line
            for entry in line[line.index("[") + 1:line.rindex("]")].split(":")]


def main():
    build, *files = sys.argv[1:]
    for file in files:
        assert all(entry.startswith("/") for entry in paths(file)), (file, paths(file))
    with tempfile.TemporaryDirectory() as prefix:
        for _ in range(2):  # the second time it is there already
            subprocess.run(["cmake", "--install", build, "--prefix", prefix, "--component", "tool"], check=True,
                           capture_output=True)
            (entry,) = paths(pathlib.Path(prefix) / "bin/dupin")
            assert entry.startswith("$ORIGIN/../lib"), entry


if __name__ == "__main__":
    main()
