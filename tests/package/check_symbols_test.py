"""tools/check_symbols.py on objects that agree about what a function is, and on some that do not."""
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
HEADER = """#include <vector>
namespace dupin::folder {
struct Run { int begin = 0, end = 0; int length() const { return end - begin; } };
inline int first() { return 1; }
template <typename T> T twice(T x) { return x + x; }
int declared(int x);
}
"""
ONE = """namespace dupin::folder {
int one() { std::vector<Run> runs; runs.push_back({}); return first() + twice(3) + runs[0].length() + declared(2); }
}
"""
OTHER = """namespace dupin::folder {
int declared(int x) { return x + first() + twice(x) + Run{1, x}.length(); }
namespace { int own() { return 2; } }
int other() { return own(); }
}
"""
FAULTS = [  # what the other object has instead of the header, and the name that is said to have two places
    ("struct Run { int a = 0; int length() const { return a; } };", "_ZNK5dupin6folder3Run6lengthEv"),
    ("inline int first() { return 2; }", "_ZN5dupin6folder5firstEv"),
    ("int first() { return 1; }", "_ZN5dupin6folder5firstEv"),  # not inline
    ("template <typename T> T twice(T x) { return 2 * x; }", "_ZN5dupin6folder5twiceIiEET_S2_"),
]


def check(compiler, folder, optimisation, *sources):
    """What the tool says of an archive of objects of these (path, text), which may have one name."""
    archive = folder / "lib.a"
    archive.unlink(missing_ok=True)
    for path, text in sources:
        source = folder / "kernel/src" / path
        source.parent.mkdir(parents=True, exist_ok=True)
        source.write_text(text)
        made = source.with_suffix(".o")
        subprocess.run([compiler, "-std=c++20", "-g1", optimisation, "-c", str(source), "-o", str(made),
                        "-I", str(folder / "kernel/src")], check=True)
        subprocess.run(["ar", "qc", str(archive), str(made)], check=True)
    done = subprocess.run([sys.executable, str(ROOT / "tools/check_symbols.py"), str(archive)],
                          capture_output=True, text=True)
    return done.returncode, done.stdout


def main():
    compiler = sys.argv[1]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "kernel/src").mkdir(parents=True)
        (folder / "kernel/src/run.h").write_text(HEADER)
        one = "a/user.cpp", '#include "run.h"\n' + ONE
        for optimisation in "-O0", "-O2":
            status, said = check(compiler, folder, optimisation, one, ("b/user.cpp", '#include "run.h"\n' + OTHER))
            assert status == 0 and "one place each" in said, said
            for definition, name in FAULTS:
                text = "\n\n\nnamespace dupin::folder { " + definition + "\nint use() { "
                text += "return Run{}.length(); } }" if "Run" in definition else (
                    "return twice(4); } }" if "twice" in definition else "return first(); } }")
                status, said = check(compiler, folder, optimisation, one, ("b/user.cpp", text))
                assert status == 1, (optimisation, definition, said)
                assert f"{name} is kernel/src/b/user.cpp:4 in" in said and "kernel/src/run.h:" in said, said
        status, said = check(compiler, folder, "-O2", ("c.cpp", "int foreign() { return 1; }"))
        assert status == 1 and "no function of ours" in said, said


if __name__ == "__main__":
    main()
