"""tools/check_layers.py on a small house, with one fault after the other."""
import importlib.util
import pathlib
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
HOUSE = {
    "kernel/include/dupin/kernel/measure.h": "#pragma once\n",
    "kernel/src/support/blocks.h": "#pragma once\nnamespace dupin::support {\nstruct Block { int size; };\n}  // namespace dupin::support\n",
    "kernel/src/support/blocks.cpp": '#include "support/blocks.h"\n'
        "namespace dupin::support {\nstruct Block;\nnamespace {\nstruct Block {};\n}  // namespace\n}  // namespace dupin::support\n",
    "kernel/src/mesh/measure.cpp": '#include "dupin/kernel/measure.h"\n#include "support/blocks.h"\n',
    "tests/kernel/support/blocks_internal_test.cpp": '#include "support/blocks.h"\n',
    "tests/kernel/mesh/measure_test.cpp": '#include "dupin/kernel/measure.h"\n',
    "bench/measure_bench.cpp": '#include "dupin/kernel/measure.h"\n',
}
FAULTS = [  # path, its text, what is said
    ("bench/measure_bench.cpp", '#include "support/blocks.h"\n', "is private"),
    ("bench/measure_bench.cpp", '#include "blocks.h"\n', "is private"),
    ("bench/measure_bench.cpp", '#include "../kernel/src/support/blocks.h"\n', "is private"),
    ("bench/measure_bench.cpp", "#include <support/blocks.h>\n", "included in quotes"),
    ("tests/kernel/mesh/measure_test.cpp", '#include "kernel/src/support/blocks.h"\n', "is private"),
    ("cli/main.cpp", '#include "support/blocks.h"\n', "private to kernel"),
    ("kernel/src/support/blocks.h", "#pragma once\nnamespace dupin::mesh_of_old {\n}\n", "in the folder"),
    ("kernel/src/support/blocks.h", "#pragma once\nnamespace dupin {\n}\n", "public namespace"),
    ("kernel/src/support/blocks.h", "#pragma once\nnamespace dupin::detail {\n}\n", "says nothing"),
    ("kernel/src/support/blocks.cpp", '#include "dupin/kernel/measure.h"\n', "no arrow leads"),
    ("kernel/src/mesh/measure.cpp", "namespace dupin::support {\nstruct Block {\n};\n}  // namespace dupin::support\n",
     "another type"),
    ("kernel/src/support/other.cpp", "", "no header has its name"),
    ("kernel/src/mesh/measure.cpp", "#include <CLI/CLI.hpp>\n", "allowed only in"),
    ("kernel/src/mesh/measure.cpp", "\n" * 601, "at most 600"),
    ("kernel/include/dupin/kernel/measure.h", "\n" * 201, "at most 200"),
    ("tests/kernel/mesh/measure_test.cpp", None, "no test has its name"),
]


def faults(files):
    """What the check says about files, without what it says about folders that are not there."""
    with tempfile.TemporaryDirectory() as name:
        for path, text in files.items():
            file = pathlib.Path(name) / path
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
        spec = importlib.util.spec_from_file_location("check_layers", ROOT / "tools/check_layers.py")
        check = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(check)
        check.ROOT = pathlib.Path(name)
        return [fault for fault in check.faults() if "arrows differ" not in fault]


def main():
    assert faults(HOUSE) == [], faults(HOUSE)
    for path, text, said in FAULTS:
        files = {**HOUSE, path: text}
        if text is None:
            del files[path]
        found = faults(files)
        assert any(said in fault for fault in found), (path, text, said, found)


if __name__ == "__main__":
    main()
