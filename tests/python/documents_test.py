"""Documents: the builder, build, gaps, certificates, surfaces."""
import inspect
import json
import os
import pathlib
import signal
import subprocess
import threading
import time

import numpy as np
import pytest

import dupin
from conftest import EXAMPLES, ROOT


def reducer():
    return (dupin.Assembly(units="mm", tolerance=0.05)
            .pipe("inlet", from_=[-10, 0, 0], to=[0, 0, 0], radius=1)
            .pipe("outlet", from_=[10, 4, 0], direction=[1, 2, 10], length=10, radius=2)
            .cyclic_blend("blend", from_="inlet.end", to="outlet.start", radius_law="R1", k=10, l=20))


def test_the_builder_writes_the_example():
    assert reducer().to_dict() == json.loads((EXAMPLES / "reducer.json").read_text())


def test_dicts_files_and_the_builder_build_the_same_solid():
    ways = [reducer(), reducer().to_dict(), EXAMPLES / "reducer.json", str(EXAMPLES / "reducer.json"),
            dupin.read_document(EXAMPLES / "reducer.json"), dupin.Assembly.from_json(reducer().to_json())]
    volumes = {dupin.build(way, tolerance=0.5).solid.exact_volume for way in ways}
    assert len(volumes) == 1


def test_what_is_built_is_what_the_tool_builds(tmp_path):
    tool = os.environ["DUPIN_TOOL"]
    file = EXAMPLES / "reducer.json"
    assert os.spawnv(os.P_WAIT, tool, [tool, "build", str(file), "-o", str(tmp_path / "tool.stl"), "-q"]) == 0
    report = dupin.build(file).write(tmp_path / "python.stl")
    assert (tmp_path / "python.stl").read_bytes() == (tmp_path / "tool.stl").read_bytes()
    assert report["verification"] == "compare" and report["check"]["watertight"]


def test_a_build_reports_its_parts_and_gaps():
    built = dupin.build(reducer())
    assert [part["name"] for part in built.parts] == ["inlet", "outlet", "blend"]
    blend = built.parts[2]
    assert 0 < blend["margin_lower"] <= blend["margin_upper"] and blend["error_bound"] <= 0.05
    assert sorted(pair["verdict"] for pair in built.gaps) == ["open", "open", "welded", "welded"]
    assert built.findings == 0 and built.unit == "mm" and built.volumes is None
    assert set(built.solid.names) == {"inlet", "outlet", "blend", "inlet.start", "outlet.end"}
    labels = built.solid.labels
    assert len(labels) == len(built.solid.triangles) and labels.max() < len(built.solid.names)


def test_regions_add_up_exactly():
    document = dupin.Assembly(wall=1).pipe("run", from_=[0, 0, 0], to=[100, 0, 0], radius=10)
    document.pipe("side", from_=[50, 0, 0], to=[50, 0, 40], radius=6)
    volumes = {region: dupin.build(document, region=region, tolerance=0.5).solid.exact_volume
               for region in ("outer", "metal", "fluid")}
    assert volumes["outer"] == volumes["metal"] + volumes["fluid"]
    assert dupin.build(document, tolerance=0.5).volumes["metal"] == pytest.approx(float(volumes["metal"]))


def test_parts_are_named_by_numpy_values_and_copies():
    document = dupin.Assembly(values={"pitch": np.float64(5)})
    document.pipe("run", from_=np.zeros(3), to=np.array([50, 0, 0]), radius=np.int64(2))
    document.pipe("n{i}", from_=["=(i + 1) * pitch", 0, 0], direction=(0, 0, 1), length=8, radius=1, for_={"i": 3})
    assert len(dupin.build(document).parts) == 4


def test_a_method_for_each_key_and_an_argument_for_each_word():
    part = dupin.schema()["definitions"]["part"]["properties"]
    assert set(dupin.part_keys) <= set(part)

    def words(node):
        if isinstance(node, dict):
            for properties in ([node["properties"]] if "properties" in node and "definitions" not in node else []):
                yield from properties
            for below in node.get("oneOf", []):
                yield from words(below)

    for key in dupin.part_keys:
        method = getattr(dupin.Assembly, key)
        node = part[key]
        if "$ref" in node:
            node = dupin.schema()["definitions"][node["$ref"].rsplit("/", 1)[-1]]
        taken = {name.rstrip("_") for name in inspect.signature(method).parameters}
        assert set(words(node)) <= taken, key
        assert key in method.__doc__ or len(method.__doc__) > 20


@pytest.mark.parametrize("example", sorted(path.name for path in EXAMPLES.glob("*.json")))
def test_examples_pass_through_the_builder(example):
    document = dupin.read_document(EXAMPLES / example)
    again = dupin.Assembly.from_json(document.to_json())
    assert again == document and again.to_dict() == json.loads((EXAMPLES / example).read_text())


ERRORS = [
    (lambda: dupin.build(EXAMPLES / "tight.json"), "IrregularSurface", "irregular_surface", "blend", "tight.json#/parts/2"),
    (lambda: dupin.build({"units": "mm", "tolerance": 1, "parts": [{"name": "a"}]}), "ParseFailed", "parse_failed", "",
     "/parts/0"),
    (lambda: dupin.build({"units": "mm", "tolerance": float("nan"), "parts": []}), "InvalidArgument",
     "invalid_argument", "", "/tolerance"),
    (lambda: dupin.Assembly().pipe("a", from_=[0, 0, 0], to=[0, 0, object()], radius=1), "InvalidArgument",
     "invalid_argument", "", "/parts/0/pipe/to/2"),
    (lambda: dupin.build(reducer().pipe("x", from_="inlet.end", length=1)), "InvalidArgument", "invalid_argument", "",
     "/parts"),
    (lambda: dupin.build(reducer(), region="inside"), "InvalidArgument", "invalid_argument", "", "region"),
    (lambda: dupin.build(reducer(), most_triangles=10), "LimitExceeded", "limit_exceeded", "", ""),
    (lambda: dupin.build(reducer(), most_triangles=0), "InvalidArgument", "invalid_argument", "", ""),
    (lambda: dupin.certify(reducer(), most_triangles=0), "InvalidArgument", "invalid_argument", "", ""),
    (lambda: dupin.build("nothing.json"), "IoFailed", "io_failed", "", "nothing.json"),
    (lambda: dupin.build(5), "InvalidArgument", "invalid_argument", "", ""),
    (lambda: dupin.Assembly.from_json("{"), "ParseFailed", "parse_failed", "", "1:"),
    (lambda: dupin.schema("x"), "InvalidArgument", "invalid_argument", "", "kind"),
]


@pytest.mark.parametrize("number", range(len(ERRORS)))
def test_errors_say_code_part_and_place(number):
    action, kind, code, part, where = ERRORS[number]
    with pytest.raises(dupin.Error) as caught:
        action()
    error = caught.value
    assert type(error).__name__ == kind and error.code == code, error
    assert part in error.part and where in error.where, (error.part, error.where)
    assert error.message in str(error)


def test_every_code_has_a_class_and_errors_can_be_copied():
    import copy
    import pickle

    for code in dupin.error_codes:
        error = dupin.errors.error_of(code, "message", "part", "where", "text")
        assert type(error) is not dupin.Error and error.code == code
        for other in (copy.copy(error), pickle.loads(pickle.dumps(error))):
            assert (type(other), str(other), other.part, other.where) == (type(error), "text", "part", "where")


def test_files_that_the_system_refuses_raise_what_other_libraries_raise(tmp_path, box):
    import copy
    import errno
    import pickle

    missing = tmp_path / "none.off"
    for action, reason, name in [
            (lambda: dupin.read_mesh(missing), errno.ENOENT, missing),
            (lambda: dupin.build(tmp_path / "none.json"), errno.ENOENT, tmp_path / "none.json"),
            (lambda: dupin.read_mesh(tmp_path), errno.EISDIR, tmp_path),
            (lambda: dupin.as_solid(*box()).write(tmp_path / "no" / "a.off"), errno.ENOENT, tmp_path / "no" / "a.off")]:
        with pytest.raises(OSError) as caught:
            action()
        for error in (caught.value, copy.copy(caught.value), pickle.loads(pickle.dumps(caught.value))):
            assert isinstance(error, dupin.errors.IoFailed)
            assert (error.errno, error.strerror, error.filename) == (reason, os.strerror(reason), str(name))
            assert str(error).startswith(f"{name}: cannot ") and os.strerror(reason) in str(error)
    unexplained = dupin.errors.error_of("io_failed", "became shorter", where="a.stl")
    assert (unexplained.errno, unexplained.strerror, unexplained.filename) == (None, None, "a.stl")


class Named(dupin.Assembly):
    pass


@pytest.mark.parametrize("kind", [dupin.Assembly, Named])
def test_copies_of_an_assembly_are_their_own(kind):
    import copy
    import pickle

    original = kind(units="in", values={"r": [1, 2]}).pipe("a", from_=[0, 0, 0], to=[1, 0, 0], radius=1)
    original.remark = ["of the user"]
    for made in (copy.copy(original), copy.deepcopy(original), pickle.loads(pickle.dumps(original))):
        assert type(made) is kind and made == original and made.remark == original.remark
        made.pipe("b", from_=[0, 0, 0], to=[0, 1, 0], radius=1)
        made._document["values"]["r"].append(3)
        assert len(made) == 2 and len(original) == 1 and original.to_dict()["values"] == {"r": [1, 2]}


def test_gaps_are_measured_exactly():
    report = dupin.gaps({"units": "mm", "tolerance": 0.01, "parts": [
        {"name": "a", "pipe": {"from": [0, 0, 0], "to": [1, 0, 0], "radius": 1}},
        {"name": "b", "pipe": {"from": [1.125, 0, 0], "to": [2, 0, 0], "radius": 1}}]}, connect=0.5)
    assert report["findings"] == 1
    pair = next(pair for pair in report["pairs"] if pair["verdict"] == "gap")
    assert pair["axial"] == {"lower": 0.125, "upper": 0.125}


def test_certificates_are_written_and_verified(tmp_path):
    certificate = dupin.certify(EXAMPLES / "reducer.json")
    assert certificate.findings == 0 and certificate.summary["findings"] == 0
    file = tmp_path / "reducer.cert.json"
    certificate.write(file)
    assert dupin.verify(file, EXAMPLES / "reducer.json").findings == 0
    certificate.verify()
    with pytest.raises(dupin.errors.InvalidArgument):
        dupin.verify(file, dupin.Assembly().sphere("a", center=[0, 0, 0], radius=1))
    file.write_text(file.read_text().replace('"tolerance": 0.05', '"tolerance": 0.06'))
    with pytest.raises(dupin.errors.ParseFailed):
        dupin.verify(file)
    assert dupin.certify(EXAMPLES / "reducer.json", margin=0.5).findings > 0


def test_surfaces_and_bills():
    surfaces = dupin.nurbs(EXAMPLES / "reducer.json")
    assert [part["part"] for part in surfaces["parts"]] == ["inlet", "outlet", "blend"]
    assert surfaces["parts"][0]["error_bound"] == 0
    for tolerance in (-1, 0, float("inf"), float("nan")):
        for example in ("reducer.json", "tee.json", "junction.json"):
            with pytest.raises(dupin.errors.InvalidArgument, match="tolerance"):
                dupin.nurbs(EXAMPLES / example, tolerance=tolerance)
    bill = dupin.bill_of_materials(EXAMPLES / "reducer.json", density=7850)
    assert len(bill["parts"]) == 3 and bill["sum"]["metal"]["mass"] > 0
    for density in (-3, 0, float("inf"), float("nan")):
        with pytest.raises(dupin.errors.InvalidArgument, match="density"):
            dupin.bill_of_materials(EXAMPLES / "reducer.json", density=density)


def test_piping_files_and_graphs_become_documents():
    line = dupin.read_document(EXAMPLES / "line.pcf")
    assert len(line) > 3 and line.validate() is line
    graph = dupin.read_document(EXAMPLES / "frame.graph", radius=2.0)
    assert len(graph) > 3
    with pytest.raises(dupin.errors.InvalidArgument):
        dupin.build(EXAMPLES / "frame.graph")
    for file, options in (("tee.json", {"wall": 3}), ("tee.json", {"radius": 3}), ("tee.json", {"snap": 1}),
                          ("tee.json", {"bridge": 1}), ("tee.json", {"keep_going": True}), ("line.pcf", {"radius": 1}),
                          ("frame.graph", {"radius": 2, "snap": 1}), ("frame.graph", {"radius": 2, "bridge": 1})):
        with pytest.raises(dupin.errors.InvalidArgument, match=f"{file}: {list(options)[-1]} would do nothing"):
            dupin.read_document(EXAMPLES / file, **options)


def tool_says(*arguments, code=0):
    """What the tool prints with --json."""
    run = subprocess.run([os.environ["DUPIN_TOOL"], *map(str, arguments), "--json"], capture_output=True, check=False)
    assert run.returncode == code, run.stderr
    return json.loads(run.stdout)


@pytest.mark.parametrize("file", ["line.pcf", "neuron.swc", "vessel.json"])
def test_files_are_what_they_are_for_the_tool(file, tmp_path):
    path = EXAMPLES / file
    built = dupin.build(path)
    said = tool_says("build", path, "-o", tmp_path / "a.off", code=1 if built.findings else 0)
    del said["output"]
    assert built.report == said
    assert dupin.bill_of_materials(path, density=7850) == tool_says("bom", path, "--density", 7850)
    gaps = dupin.gaps(path)
    assert gaps == tool_says("gaps", path, code=1 if gaps["findings"] else 0)
    certificate = dupin.certify(path)
    certificate.write(tmp_path / "python.cert")
    tool_says("certify", path, "-o", tmp_path / "tool.cert", code=1 if certificate.findings else 0)
    assert (tmp_path / "python.cert").read_bytes() == (tmp_path / "tool.cert").read_bytes()
    dupin.verify(tmp_path / "tool.cert", path)


def test_insulation_is_a_region():
    document = dupin.Assembly(wall=1).pipe("run", from_=[0, 0, 0], to=[100, 0, 0], radius=10).to_dict()
    document["insulation"] = 5
    assert dupin.build(document, region="insulation").volumes["insulation"] == pytest.approx(
        np.pi * (15**2 - 10**2) * 100, rel=0.05)


def test_built_is_a_mesh_and_a_solid():
    built = dupin.build(reducer())
    assert dupin.check(built)["solid"] and dupin.as_solid(built).volume == built.solid.volume


def test_the_schemas_are_those_of_the_sources():
    for kind in ("assembly", "certificate"):
        assert dupin.schema(kind) == json.loads((ROOT / "io" / f"{kind}.schema.json").read_text())


def test_progress_is_told_and_can_cancel():
    stages = []
    dupin.build(reducer(), progress=lambda stage, fraction: stages.append((stage, fraction)))
    assert {"resolve", "certify", "mesh"} <= {stage for stage, _ in stages}
    assert all(0 <= fraction <= 1 for _, fraction in stages)
    with pytest.raises(dupin.errors.Cancelled):
        dupin.build(reducer(), progress=lambda stage, fraction: stage != "mesh")

    def fails(stage, fraction):
        raise KeyError(stage)

    with pytest.raises(KeyError, match="resolve"):
        dupin.build(reducer(), progress=fails)


def test_other_threads_run_meanwhile():
    """While one thread builds, another one counts: it would stand still without the lock."""
    counted, done = [], threading.Event()

    def count():
        while not done.is_set():
            counted.append(time.perf_counter())
            time.sleep(0.001)

    other = threading.Thread(target=count)
    other.start()
    begin = time.perf_counter()
    dupin.build(reducer(), tolerance=0.0005)
    end = time.perf_counter()
    done.set()
    other.join()
    during = [moment for moment in counted if begin < moment < end]
    assert end - begin > 0.02 and len(during) >= (end - begin) / 0.02


def test_an_interrupt_ends_whatever_is_long():
    solid = dupin.build(reducer(), tolerance=0.001).solid
    moved = solid.translate([0.25, 0.125, 0.0625])
    for action in (lambda: dupin.build(reducer(), tolerance=0.0005), lambda: solid.simplify(0.01),
                   lambda: solid + moved, lambda: solid - moved, lambda: solid & moved,
                   lambda: dupin.certify(reducer())):
        timer = threading.Timer(0.1, lambda: os.kill(os.getpid(), signal.SIGINT))
        timer.start()
        begin = time.perf_counter()
        with pytest.raises(KeyboardInterrupt):
            while time.perf_counter() - begin < 20:
                action()
        timer.join()


def test_all_that_is_public_is_described():
    for name in dupin.__all__:
        value = getattr(dupin, name)
        if callable(value) and name not in ("MeshLike", "SolidLike", "Document"):
            assert value.__doc__, name
    for kind in (dupin.Solid, dupin.Mesh, dupin.Certificate, dupin.Built, dupin.Assembly):
        for name, member in vars(kind).items():
            if not name.startswith("_"):
                assert member.__doc__, f"{kind.__name__}.{name}"


def test_the_stub_lists_what_the_module_has():
    """The extension has no annotations of its own."""
    import ast

    stub = ast.parse((ROOT / "python" / "dupin" / "_core.pyi").read_text())
    listed = set()
    for node in stub.body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            listed.add(node.name)
        if isinstance(node, ast.AnnAssign):
            listed.add(node.target.id)
        if isinstance(node, ast.ClassDef):
            kind = getattr(dupin._core, node.name)
            methods = {item.name for item in node.body if isinstance(item, ast.FunctionDef)}
            public = {name for name in vars(kind) if not name.startswith("__")}
            assert public == {name for name in methods if not name.startswith("__")}, node.name
    assert listed == {name for name in dir(dupin._core) if not name.startswith("__")} | {"__version__"}
    assert pathlib.Path(dupin.__file__).with_name("py.typed").exists()


def test_what_contains_itself_is_one_clear_error():
    document = {"units": "mm", "tolerance": 0.05, "parts": []}
    document["parts"].append(document)
    ring = [0, 0]
    ring.append(ring)
    with pytest.raises(dupin.errors.InvalidArgument, match="a dict contains itself") as caught:
        dupin.build(document)
    assert caught.value.where == "/parts/0"
    with pytest.raises(dupin.errors.InvalidArgument, match="a dict contains itself"):
        dupin.Assembly.from_dict(document)
    with pytest.raises(dupin.errors.InvalidArgument, match="a list contains itself") as caught:
        dupin.Assembly().pipe("a", from_=ring, to=[1, 0, 0], radius=1)
    assert caught.value.where == "/parts/0/pipe/from/2"
    deep = {}
    for _ in range(3000):
        deep = {"a": deep}
    with pytest.raises(dupin.errors.InvalidArgument, match="nested more than 100 deep"):
        dupin.build(deep)
    shared = [0, 0, 0]  # twice, but not in itself
    assert dupin.Assembly.from_dict({"parts": [shared, shared]}).to_dict()["parts"] == [shared, shared]


def test_what_json_cannot_hold_is_named_by_its_place_in_the_document():
    def pipe(name="a", radius=1):
        return {"name": name, "pipe": {"from": [0, 0, 0], "to": [1, 0, 0], "radius": radius}}

    for document, where, text in [
            ({"parts": [pipe("\ud800")]}, "/parts/0/name", r"lone surrogate, '\\ud800'"),
            ({"parts": [{**pipe(), "\udfff": 1}]}, "/parts/0", "lone surrogate"),
            ({"tolerance": 10 ** 400, "parts": [pipe()]}, "/tolerance", "beyond all floats"),
            ({"parts": [pipe(radius=-10 ** 5000)]}, "/parts/0/pipe/radius", "beyond all floats")]:
        for use in (dupin.build, dupin.Assembly.from_dict):
            with pytest.raises(dupin.errors.InvalidArgument, match=text) as caught:
                use(document)
            assert caught.value.where == where
    with pytest.raises(dupin.errors.InvalidArgument, match="lone surrogate") as caught:
        dupin.Assembly().pipe("\ud800", from_=[0, 0, 0], to=[1, 0, 0], radius=1)
    assert caught.value.where == "/parts/0/name"
    assert dupin.Assembly(tolerance=10 ** 308).to_dict()["tolerance"] == 10 ** 308
