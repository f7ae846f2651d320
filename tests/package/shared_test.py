"""shared_test.py BUILD: what a build with BUILD_SHARED_LIBS installs works where it is put: the tool finds the library, and the
library its module for STEP."""
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def run(*command):
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    assert result.returncode == 0, (command, result.stdout, result.stderr)
    return result.stdout


def main():
    with tempfile.TemporaryDirectory() as name:
        prefix = pathlib.Path(name) / "prefix"
        for component in ("tool", "library", "exchange"):
            run("cmake", "--install", sys.argv[1], "--prefix", prefix, "--component", component)
        library = next(prefix.glob("lib/**/libdupin.so.*.*.*"))
        said = run("objdump", "-p", library)
        assert f"SONAME               libdupin.so.{'.'.join(library.name.split('.')[2:4])}" in said, said
        tool = prefix / "bin/dupin"
        run(tool, "build", ROOT / "examples/reducer.json", "-o", prefix / "reducer.stl", "-q")
        if list(prefix.glob("lib/**/libdupin_occt.so")):
            run(tool, "build", ROOT / "examples/reducer.json", "-o", prefix / "reducer.step", "-q")


if __name__ == "__main__":
    main()
