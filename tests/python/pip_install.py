"""pip_install.py BUILD: `pip install .` into an environment of its own, without network, from what BUILD holds; then
the package is used from there, and removed."""
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
USE = """
import dupin, pathlib, sys
assert pathlib.Path(dupin.__file__).is_relative_to(sys.prefix), dupin.__file__
assert (pathlib.Path(dupin.__file__).parent / "_core.pyi").exists()
assert dupin.build(sys.argv[1], tolerance=0.5).solid.volume > 0
"""


def main():
    environment = {key: value for key, value in os.environ.items() if key not in ("PYTHONPATH", "PYTHONHOME")}
    environment.update(PIP_NO_INDEX="1", PIP_DISABLE_PIP_VERSION_CHECK="1")
    with tempfile.TemporaryDirectory() as folder:
        python = f"{folder}/bin/python"

        def run(*command):
            subprocess.run(command, check=True, cwd=folder, env=environment)

        run(sys.executable, "-m", "venv", "--system-site-packages", folder)
        run(python, "-m", "pip", "install", "-q", str(ROOT), "--config-settings", f"build-dir={sys.argv[1]}")
        run(python, "-c", USE, str(ROOT / "examples/reducer.json"))
        run(python, "-m", "pip", "uninstall", "-q", "-y", "dupin")
        left = [path for path in pathlib.Path(folder).rglob("*dupin*")]
        assert not left, left


if __name__ == "__main__":
    main()
