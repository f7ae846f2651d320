"""Builds wheels with CMake (PEP 517, PEP 660). Debian 12 has no scikit-build-core, and a wheel is a zip file.

    pip install .
    pip install . --config-settings build-dir=build/release   # takes what is built there already

The extension is for the interpreter that runs pip. Its own build tree is build/wheel-TAG.
"""
import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
EPOCH = (1980, 1, 1, 0, 0, 0)  # the same input gives the same bytes


def version():
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(dupin VERSION (\S+)", text)[1]


def tag():
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    return f"{python}-{python}-{platform}"


def metadata():
    """Of pyproject.toml, which Python 3.9 cannot parse: what stands there on single lines."""
    text = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
    value = {key: re.search(rf'^{key} = "(.*)"$', text, re.M)[1] for key in ("name", "description", "requires-python")}
    needs = re.search(r"^dependencies = \[(.*)\]$", text, re.M)[1]
    extras = re.search(r"^meshes = \[(.*)\]$", text, re.M)[1]
    lines = ["Metadata-Version: 2.1", f"Name: {value['name']}", f"Version: {version()}",
             f"Summary: {value['description']}", "License: GPL-3.0-or-later",
             f"Requires-Python: {value['requires-python']}"]
    lines += [f"Requires-Dist: {need}" for need in re.findall(r'"(.*?)"', needs)]
    lines += ["Provides-Extra: meshes"]
    lines += [f'Requires-Dist: {extra}; extra == "meshes"' for extra in re.findall(r'"(.*?)"', extras)]
    lines += ["Description-Content-Type: text/markdown", "", (ROOT / "README.md").read_text(encoding="utf-8")]
    return "\n".join(lines)


def run(*command):
    subprocess.run([str(part) for part in command], check=True, cwd=ROOT)


def configured_for(build):
    """The interpreter that a build tree is configured for, or None."""
    cache = build / "CMakeCache.txt"
    if not cache.exists():
        return None
    found = re.search(r"^Python3_EXECUTABLE:\w+=(.*)$", cache.read_text(encoding="utf-8"), re.M)
    return found and found[1]


def tag_of(interpreter):
    code = "import sys, sysconfig; print(sysconfig.get_config_var('EXT_SUFFIX'))"
    return subprocess.run([interpreter, "-c", code], capture_output=True, text=True, check=True).stdout.strip()


def build_tree(settings):
    given = (settings or {}).get("build-dir")
    if not given:
        build = ROOT / "build" / f"wheel-{tag()}"
        generator = ["-G", "Ninja"] if any((pathlib.Path(folder) / "ninja").exists()
                                           for folder in os.get_exec_path()) else []
        run("cmake", "-S", ROOT, "-B", build, *generator, "-D", "CMAKE_BUILD_TYPE=Release", "-D", "DUPIN_PYTHON=ON",
            "-D", f"Python3_EXECUTABLE={sys.executable}", "-D", "DUPIN_BUILD_TESTS=OFF", "-D", "DUPIN_BUILD_BENCH=OFF",
            "-D", "DUPIN_BUILD_CLI=OFF")
        return build
    build = (ROOT / given).resolve()
    interpreter = configured_for(build)
    if interpreter is None:
        raise SystemExit(f"{build} is no configured build tree with the Python package")
    if tag_of(interpreter) != sysconfig.get_config_var("EXT_SUFFIX"):
        raise SystemExit(f"{build} is for {interpreter}, whose extensions {sys.executable} cannot load")
    return build


def installed(settings, prefix):
    """The package, as the component "python" installs it."""
    build = build_tree(settings)
    run("cmake", "--build", build, "--target", "dupin_python", "-j", os.cpu_count() or 1)
    run("cmake", "--install", build, "--component", "python", "--prefix", prefix)
    return next(pathlib.Path(prefix).rglob("dupin/__init__.py")).parent


def record_line(name, data):
    digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(data)}"


def write_wheel(folder, files):
    info = f"dupin-{version()}.dist-info"
    files = {**files, f"{info}/METADATA": metadata().encode(),
             f"{info}/WHEEL": f"Wheel-Version: 1.0\nGenerator: dupin_backend\nRoot-Is-Purelib: false\nTag: {tag()}\n".encode(),
             f"{info}/LICENSE": (ROOT / "LICENSE").read_bytes()}
    record = "\n".join([record_line(name, data) for name, data in files.items()] + [f"{info}/RECORD,,", ""])
    name = f"dupin-{version()}-{tag()}.whl"
    with zipfile.ZipFile(pathlib.Path(folder) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, data in {**files, f"{info}/RECORD": record.encode()}.items():
            entry = zipfile.ZipInfo(path, EPOCH)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            wheel.writestr(entry, data)
    return name


# The hooks that pip calls.


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    with tempfile.TemporaryDirectory() as prefix:
        package = installed(config_settings, prefix)
        files = {f"dupin/{file.relative_to(package).as_posix()}": file.read_bytes()
                 for file in sorted(package.rglob("*")) if file.is_file() and "__pycache__" not in file.parts}
    return write_wheel(wheel_directory, files)


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    """A wheel that points to the build tree, in which the Python files are links to the sources."""
    build = build_tree(config_settings)
    run("cmake", "--build", build, "--target", "dupin_python", "-j", os.cpu_count() or 1)
    return write_wheel(wheel_directory, {"dupin.pth": f"{build / 'python'}\n".encode()})


def build_sdist(sdist_directory, config_settings=None):
    """What git has: the sources that the wheel is built from."""
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, check=True).stdout
    base = f"dupin-{version()}"
    with tarfile.open(pathlib.Path(sdist_directory) / f"{base}.tar.gz", "w:gz", format=tarfile.PAX_FORMAT) as archive:
        for name in sorted(filter(None, listed.decode().split("\0"))):
            if (ROOT / name).is_file():
                archive.add(ROOT / name, f"{base}/{name}")
        with tempfile.NamedTemporaryFile() as info:
            info.write(metadata().encode())
            info.flush()
            archive.add(info.name, f"{base}/PKG-INFO")
    return f"{base}.tar.gz"
