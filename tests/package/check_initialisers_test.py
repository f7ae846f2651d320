"""tools/check_initialisers.py on constants that are there at once, and on some that wait."""
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCE = """{include}
#include <string>
int number();
namespace dupin::folder {{
namespace {{
{constant}
}}
const void* user() {{ return &kConstant; }}
const void* other() {{ static const std::string text(number(), 'a'); return &text; }}
}}
"""


def status(compiler, folder, constant, include=""):
    source, archive = folder / "one.cpp", folder / "lib.a"
    source.write_text(SOURCE.format(constant=constant, include=include))
    archive.unlink(missing_ok=True)
    subprocess.run([compiler, "-std=c++20", "-O1", "-c", str(source), "-o", str(folder / "one.o")], check=True)
    subprocess.run(["ar", "rc", str(archive), str(folder / "one.o")], check=True)
    return subprocess.run([sys.executable, str(ROOT / "tools/check_initialisers.py"), str(archive)],
                          capture_output=True, text=True)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for include in ("", "#include <iostream>"):
            same = status(sys.argv[1], folder, "constexpr double kConstant = 1;", include)
            assert same.returncode == 0, same.stdout
            waiting = status(sys.argv[1], folder, 'const std::string kConstant = "along the axis, across it";', include)
            assert waiting.returncode == 1, waiting.stdout
            assert "kConstant" in waiting.stdout, waiting.stdout


if __name__ == "__main__":
    main()
