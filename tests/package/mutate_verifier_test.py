"""What tools/mutate_verifier.py knows of survivors is about one mutant each, of the sources as they are."""
import importlib.util
import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[2]


def tool():
    spec = importlib.util.spec_from_file_location("mutate_verifier", ROOT / "tools/mutate_verifier.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def main():
    mutate = tool()
    assert not mutate.misplaced_reasons(), mutate.misplaced_reasons()
    for misplaced in [("covering.cpp", "no line reads so", " < "), ("covering.cpp", "if (", " <= "),
                      ("gone.cpp", "if (", " < ")]:
        mutate.KNOWN[misplaced] = "none"
        assert len(mutate.misplaced_reasons()) == 1, misplaced
        del mutate.KNOWN[misplaced]


main()
