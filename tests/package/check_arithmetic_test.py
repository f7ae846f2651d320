"""tools/check_arithmetic.py on functions that make solids, with and without the usual arithmetic."""
import importlib.util
import pathlib
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
HEADER = """namespace dupin {
[[nodiscard]] Solid unite(int a);
/// Solid told(int a);
[[nodiscard]] double length(int a);
[[nodiscard]] std::string solid_text(int a);
class Plan {
 public:
  [[nodiscard]] Built build() const;
};
}
"""
GUARDED = "  const UsualArithmetic usual;\n  return {a};\n"


def tool():
    spec = importlib.util.spec_from_file_location("check_arithmetic", ROOT / "tools/check_arithmetic.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def main():
    check = tool()
    assert not check.faults(ROOT), check.faults(ROOT)
    with tempfile.TemporaryDirectory() as name:
        root = pathlib.Path(name)
        (root / "kernel/include").mkdir(parents=True)
        (root / "kernel/src").mkdir()
        (root / "kernel/include/unite.h").write_text(HEADER)

        def faults(code, stem="unite", opened="namespace dupin {\n"):
            source = root / f"kernel/src/{stem}.cpp"
            source.write_text(opened + code + "}\n")
            found = check.faults(root)
            source.unlink()
            return found

        bare = "Solid unite(int a) {\n  int b = a;\n  return {b};\n}\n"
        assert faults(bare) == ["kernel/src/unite.cpp:2: unite needs a UsualArithmetic"]
        assert not faults("Solid unite(int a) {\n" + GUARDED + "}\n")
        assert faults("Built Plan::build() const { return {length(1)}; }\n")
        assert not faults("Built Plan::build() const { return unite(1); }\n")
        # One that calls the guarded one, and computes besides.
        assert faults("Built Plan::build() const {\n  int a = 1;\n  return unite(a);\n}\n")
        assert not faults("double length(int a) {\n  return a;\n}\nSolid told(int a) {\n  return {a};\n}\n")
        assert not faults("namespace {\n" + bare + "}  // namespace\n")
        assert not faults(bare, opened="namespace dupin::folder {\n")
        assert not faults(bare, stem="unite_absent")
        # What reads and writes is known by its name.
        reader = "std::string solid_text(int a) {\n  return text(a + 1);\n}\n"
        assert faults(reader) == ["kernel/src/unite.cpp:2: solid_text needs a UsualArithmetic"]
        assert not faults("std::string solid_text(int a) {\n  refuse();\n}\n")


if __name__ == "__main__":
    main()
