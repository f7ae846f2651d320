"""packages_test.py BUILD: `cpack` there, and its packages installed by dpkg into an empty root, used from there, and
removed without a trace."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
# The least that each package depends on: what its files cannot do without.
NEEDS = {
    "dupin": {"libc6", "libgmp10", "libmpfr6", "libtbb12", "libexpat1", "libjemalloc2", "libzip4",
              "libcairo2"},
    "libdupin-dev": {"libeigen3-dev", "libgmp-dev", "libmpfr-dev", "libmpfi-dev", "libtbb-dev", "libexpat1-dev",
                     "libzip4", "libcairo2"},
    "dupin-exchange": {"libc6", "libocct-data-exchange-7.6"},
    "dupin-mpi": {"libc6", "libopenmpi3"},
    "python3-dupin": {"python3", "python3-numpy", "libgmp10", "libzip4", "libcairo2"},
}
HOLDS = {
    "dupin": ["usr/bin/dupin", "usr/share/man/man1/dupin-build.1.gz", "usr/share/bash-completion/completions/dupin",
              "usr/share/zsh/vendor-completions/_dupin", "usr/share/fish/vendor_completions.d/dupin.fish",
              "usr/share/dupin/assembly.schema.json"],
    "libdupin-dev": ["usr/include/dupin/blends/build.h", "usr/lib/**/libdupin_kernel.a",
                     "usr/lib/**/cmake/dupin/dupinConfig.cmake", "usr/lib/**/pkgconfig/dupin.pc"],
    "dupin-exchange": ["usr/**/libdupin_occt.so"],
    "dupin-mpi": ["usr/**/libdupin_mpi.so"],
    "python3-dupin": ["usr/lib/python3/dist-packages/dupin/__init__.py", "usr/lib/python3/dist-packages/dupin/_core.pyi"],
}


def run(*command, **options):
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)
    assert result.returncode == 0, (command, result.stdout, result.stderr)
    return result.stdout


def fields(package):
    return {key: run("dpkg-deb", "-f", package, key).strip() for key in ("Package", "Version", "Depends", "Maintainer",
                                                                         "Description", "Architecture")}


def use(root, version):
    """The packages at work, as far as that can be without being root's own system."""
    assert run(root / "usr/bin/dupin", "--version") == f"dupin {version}\n"
    run(root / "usr/bin/dupin", "build", ROOT / "examples/reducer.json", "-o", root / "tmp/reducer.stl", "-q")
    environment = {**os.environ, "PYTHONPATH": str(root / "usr/lib/python3/dist-packages"), "PYTHONDONTWRITEBYTECODE": "1"}
    run("/usr/bin/python3", "-c", f"import dupin; assert dupin.Solid.read('{root}/tmp/reducer.stl').genus == 0",
        env=environment)
    os.unlink(root / "tmp/reducer.stl")
    run(root / "usr/bin/dupin", "build", ROOT / "examples/reducer.json", "-o", root / "tmp/reducer.step", "-q")
    os.unlink(root / "tmp/reducer.step")
    path = next(root.glob("usr/lib/**/pkgconfig"))
    flags = run("pkg-config", "--cflags", "--libs", "dupin", env={**os.environ, "PKG_CONFIG_PATH": str(path)}).split()
    assert {"-ldupin_io", "-ldupin_kernel", "-lgmp", "-lexpat"} <= set(flags), flags


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as name:
        folder, root = pathlib.Path(name) / "packages", pathlib.Path(name) / "root"
        run("cpack", "--config", build / "CPackConfig.cmake", "-B", folder, "-D", f"CPACK_PACKAGE_DIRECTORY={folder}",
            "-D", "CPACK_DEBIAN_COMPRESSION_TYPE=none", cwd=name)
        packages = {fields(file)["Package"]: file for file in folder.glob("*.deb")}
        assert set(packages) == set(NEEDS), packages
        for package, file in packages.items():
            said = fields(file)
            depends = {re.match(r"[a-z0-9.+-]+", word.strip())[0] for word in said["Depends"].split(",")}
            assert NEEDS[package] <= depends, (package, depends)
            assert said["Maintainer"] and said["Description"] and said["Architecture"] != "all", said
        for place in ("var/lib/dpkg/info", "var/lib/dpkg/updates", "tmp"):
            (root / place).mkdir(parents=True)
        (root / "var/lib/dpkg/status").touch()
        before = set(root.rglob("*"))
        dpkg = ["dpkg", f"--root={root}", "--force-depends", "--force-not-root", "--log=/dev/null"]
        # That of a module in the libraries' folder runs ldconfig, which this root has not.
        for module in ("dupin-exchange", "dupin-mpi"):
            run("dpkg-deb", "-x", packages.pop(module), root)
        run(*dpkg, "-i", *packages.values())
        for package, patterns in HOLDS.items():
            for pattern in patterns:
                assert len(list(root.glob(pattern))) == 1, (package, pattern)
        use(root, said["Version"])
        for module in ("libdupin_occt.so", "libdupin_mpi.so"):
            next(root.glob(f"usr/**/{module}")).unlink()
        run(*dpkg, "--purge", *packages)
        left = {path for path in set(root.rglob("*")) - before if "var/lib/dpkg" not in str(path)}
        assert not left, left


if __name__ == "__main__":
    main()
