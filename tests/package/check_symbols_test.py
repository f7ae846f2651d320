"""tools/check_symbols.py on two objects that agree about a type and a function, and on some that do not."""
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCE = """#include <vector>
namespace dupin::folder {{
struct Run {{ {members} }};
{begin} int first() {{ return 1; }}
int {user}() {{ std::vector<Run> runs; runs.push_back({{}}); return first(); }}
}}
"""


def status(compiler, folder, first, second, begin="inline"):
    objects = []
    for user, members, how in (("one", first, "inline"), ("two", second, begin)):
        source = folder / f"{user}.cpp"
        source.write_text(SOURCE.format(members=members, user=user, begin=how))
        objects.append(str(source.with_suffix(".o")))
        subprocess.run([compiler, "-std=c++20", "-O0", "-c", str(source), "-o", objects[-1]], check=True)
    archive = str(folder / "lib.a")
    pathlib.Path(archive).unlink(missing_ok=True)
    subprocess.run(["ar", "rc", archive, *objects], check=True)
    return subprocess.run([sys.executable, str(ROOT / "tools/check_symbols.py"), archive],
                          capture_output=True, text=True)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        same = status(sys.argv[1], folder, "int begin, end;", "int begin, end;")
        assert same.returncode == 0, same.stdout
        differing = status(sys.argv[1], folder, "int begin, end;", "std::vector<int> parts;")
        assert differing.returncode == 1, differing.stdout
        assert "dupin6folder3Run" in differing.stdout, differing.stdout
        defined = status(sys.argv[1], folder, "int begin, end;", "int begin, end;", begin="")
        assert defined.returncode == 1, defined.stdout
        assert "dupin6folder5firstEv: inline in" in defined.stdout, defined.stdout


if __name__ == "__main__":
    main()
