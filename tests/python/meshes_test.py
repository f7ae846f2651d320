"""Meshes, solids and set operations on NumPy's arrays."""
import copy
import gc
import os
import pickle
import sys
from fractions import Fraction

import numpy as np
import pytest

import dupin


def test_a_box_of_arrays_is_a_solid(box):
    solid = dupin.as_solid(*box())
    assert solid.volume == 1 and solid.exact_volume == Fraction(1) and solid.area == 6
    assert (solid.components, solid.genus, solid.euler_number, solid.shells) == (1, 0, 2, 1)
    assert not solid.is_empty and dupin.Solid().is_empty


@pytest.mark.parametrize("points_kind", [np.float64, np.float32, np.int32, ">f8"])
@pytest.mark.parametrize("triangles_kind", [np.uint32, np.int32, np.int64, np.uint64, np.uint8, ">i4"])
@pytest.mark.parametrize("order", ["C", "F"])
def test_arrays_of_any_kind_are_the_same_mesh(box, points_kind, triangles_kind, order):
    points, triangles = box((0, 0, 0), (2, 3, 4))
    mesh = dupin.Mesh(np.array(points, points_kind, order=order), np.array(triangles, triangles_kind, order=order))
    assert (mesh.points == points).all() and (mesh.triangles == triangles).all()


def test_strided_arrays_and_lists_are_read(box):
    points, triangles = box()
    spread = np.zeros((len(points), 6))
    spread[:, ::2] = points
    assert (dupin.Mesh(spread[:, ::2], triangles.tolist()).points == points).all()


def test_arrays_out_are_views_that_keep_their_owner_alive(box):
    mesh = dupin.Mesh(*box())
    points, again = mesh.points, mesh.points
    assert points.base is mesh and np.shares_memory(points, again)
    assert not points.flags.writeable
    del mesh
    gc.collect()
    assert points.sum() == 12
    triangles = dupin.as_solid(*box()).triangles
    gc.collect()
    assert triangles.max() == 7 and not triangles.flags.writeable


def test_what_is_written_to_the_arrays_later_is_not_the_mesh(box):
    points, triangles = box()
    mesh = dupin.Mesh(points, triangles)
    points[:] = 7
    assert mesh.points.max() == 1


BAD_ARRAYS = [
    (dict(points=np.zeros((4, 2)), triangles=[[0, 1, 2]]), "points", "(4, 2)"),
    (dict(points=np.zeros(12), triangles=[[0, 1, 2]]), "points", "(12,)"),
    (dict(points=[["a", "b", "c"]], triangles=[[0, 0, 0]]), "points", "real numbers"),
    (dict(points=np.zeros((4, 3), complex), triangles=[[0, 1, 2]]), "points", "complex"),
    (dict(points=np.zeros((4, 3)), triangles=[[0, 1]]), "triangles", "(1, 2)"),
    (dict(points=np.zeros((4, 3)), triangles=[[0.0, 1.0, 2.0]]), "triangles", "float64"),
    (dict(points=np.zeros((4, 3)), triangles=[[0, 1, -1]]), "triangles", "-1"),
    (dict(points=np.zeros((4, 3)), triangles=[[0, 1, 2 ** 32]]), "triangles", "4294967296"),
    (dict(points=np.zeros((4, 3)), triangles=[[0, 1, 4]]), "triangles", "only 4 points"),
    (dict(points=np.zeros((4, 3)), triangles=[[0, 1, 2]], labels=[[0]]), "labels", "(1, 1)"),
    (dict(points=np.zeros((4, 3)), triangles=[[0, 1, 2]], labels=[0.5]), "labels", "whole"),
]


@pytest.mark.parametrize("arguments,where,said", BAD_ARRAYS)
def test_bad_arrays_are_refused_by_name(arguments, where, said):
    with pytest.raises(dupin.errors.InvalidArgument) as caught:
        dupin.Mesh(**arguments)
    assert caught.value.where == where and said in str(caught.value)


def test_set_operations_are_exact(box):
    a, b = dupin.as_solid(*box()), dupin.as_solid(*box((0.5, 0.5, 0.5), (2, 2, 2)))
    assert (a + b).exact_volume == a.exact_volume + b.exact_volume - (a & b).exact_volume
    assert (a | b).exact_volume == (a + b).exact_volume
    assert (a - b).exact_volume == Fraction(7, 8) == dupin.subtract(a, b).exact_volume
    assert dupin.intersection(a, b).exact_volume == Fraction(1, 8)
    assert dupin.union(a, b).exact_volume == (a + b).exact_volume
    assert dupin.union().is_empty
    with pytest.raises(dupin.errors.InvalidArgument):
        dupin.intersection()


def test_expressions_take_arrays_files_and_solids(box, tmp_path):
    file = tmp_path / "c.stl"
    dupin.write_mesh(file, box((0.25, 0.25, -1), (0.75, 0.75, 2)))
    a, b = box(), dupin.as_solid(*box((1, 0, 0), (2, 1, 1)))
    result = dupin.boolean("(a + b) - c", a=a, b=b, c=str(file))
    assert result.exact_volume == Fraction(2) - Fraction(1, 4) and result.genus == 1
    assert set(result.sources[:, 0]) <= {0, 1, 2}
    assert dupin.boolean('"x 1" & y', {"x 1": a, "y": a}).volume == 1


def test_faults_of_expressions_and_operands_are_named(box):
    with pytest.raises(dupin.errors.ParseFailed):
        dupin.boolean("a +", a=box())
    with pytest.raises(dupin.errors.InvalidArgument, match="b"):
        dupin.boolean("a + b", a=box())
    points, triangles = box()
    with pytest.raises(dupin.errors.NotClosed) as caught:
        dupin.boolean("a + b", a=box(), b=(points, triangles[1:]))
    assert caught.value.part == "b"
    with pytest.raises(dupin.errors.InvalidArgument, match="int is no mesh"):
        dupin.union(1)
    solid = dupin.as_solid(box())
    for wrong in ([solid, solid], (solid, solid), [solid] * 3, [solid], ["a.stl", "b.stl"], [dupin.Mesh(*box())] * 2):
        with pytest.raises(dupin.errors.InvalidArgument, match=r"separate arguments, as in union\(a, b\)"):
            dupin.union(wrong)
    with pytest.raises(dupin.errors.InvalidArgument, match="'report' or 'refuse'"):
        dupin.union(box(), contacts="perhaps")


def test_contacts_are_reported_or_refused(box):
    a, b = box(), box((1, 1, 0), (2, 2, 1))
    united = dupin.union(a, b)
    assert [contact["kind"] for contact in united.contacts] == ["edge"]
    assert united.separate(0.1).contacts == [] and united.bridge(0.1).components == 1
    with pytest.raises(dupin.errors.ContactRefused):
        dupin.union(a, b, contacts="refuse")


def test_places_are_exact(box):
    solid = dupin.as_solid(*box())
    moved = solid.rotate([0, 0, 1], 90).scale(2).translate([0.5, 0, 0])
    assert moved.exact_volume == 8
    assert (moved.points.min(0) == [-1.5, 0, 0]).all()
    # Exactly a turn, whatever the angle: volumes stay.
    assert solid.rotate([1, 2, 3], 17).exact_volume == 1
    assert all(isinstance(x, Fraction) for x in moved.exact_point(0))
    with pytest.raises(IndexError):
        moved.exact_point(99)


def test_check_counts_every_fault(box):
    points, triangles = box()
    assert dupin.check(points, triangles)["solid"]
    report = dupin.check(points, triangles[1:])
    assert not report["solid"] and report["counts"]["boundary_edge"] == 3
    assert report["volume"] is None and report["genus"] is None and report["area"] == 5.5
    assert len(dupin.check(points, triangles[1:], limit=1)["findings"]) == 1
    assert dupin.check((points, triangles[:, ::-1]))["counts"]["inside_out_component"] == 1


def test_repair_says_what_it_did(box):
    points, triangles = box()
    doubled = (np.concatenate([points, points]), np.concatenate([triangles[:6], triangles[6:] + 8]))
    solid, report = dupin.repair(doubled)
    assert solid.volume == 1 and report["merged_points"] == 8
    with pytest.raises(dupin.errors.NotClosed):
        dupin.repair(points, triangles[1:])


def test_rounding_gives_a_solid_of_its_own_numbers(box):
    a = dupin.as_solid(*box()).rotate([1, 2, 3], 10)
    b = dupin.as_solid(*box((0.3, 0.3, 0.3), (1.3, 1.3, 1.3)))
    mesh = (a + b).mesh(coordinates="binary32")
    assert (mesh.points == mesh.points.astype(np.float32)).all()
    assert dupin.check(mesh)["solid"]
    with pytest.raises(dupin.errors.InvalidArgument):
        a.mesh(coordinates="binary16")


def test_files_come_back_and_bad_ones_are_errors(box, tmp_path):
    solid = dupin.as_solid(*box())
    for key in dupin.mesh_formats:
        file = tmp_path / f"box-{key}"
        try:
            report = solid.write(file, format=key, unit="mm")
        except dupin.Error as error:  # a format that is only read, or only written
            pytest.fail(f"{key}: {error}")
        assert report["check"]["watertight"]
    assert dupin.Solid.read(tmp_path / "box-off").volume == 1
    with pytest.raises(dupin.errors.InvalidArgument):
        solid.write(tmp_path / "box.txt")
    with pytest.raises(dupin.errors.InvalidArgument, match="'x' is no format"):
        solid.write(tmp_path / "box.stl", format="x")
    with pytest.raises(OSError) as caught:
        dupin.read_mesh(tmp_path / "nothing.stl")
    assert caught.value.code == "io_failed"
    (tmp_path / "bad.off").write_text("OFF\n1 1 0\n0 0\n")
    with pytest.raises(dupin.errors.ParseFailed) as caught:
        dupin.read_mesh(tmp_path / "bad.off")
    assert "bad.off:" in caught.value.where
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted(
        ["bad.off"] + [f"box-{key}" for key in dupin.mesh_formats])


def test_names_of_files_are_bytes_of_any_kind_without_a_nul(box, tmp_path):
    solid = dupin.as_solid(*box())
    name = os.fsencode(tmp_path) + b"/\xff\xfe.off"
    for file in (name, os.fsdecode(name)):
        solid.write(file)
        assert dupin.read_mesh(file).points.shape == (8, 3) and dupin.as_solid(file).volume == 1
    with pytest.raises(OSError) as caught:
        dupin.read_mesh(name + b"x")
    assert os.fsencode(caught.value.filename) == name + b"x"
    before = sorted(os.listdir(tmp_path))
    for action in (lambda file: solid.write(file), dupin.read_mesh, dupin.build,
                   lambda file: dupin.write_mesh(file, solid), dupin.Assembly().write):
        with pytest.raises(ValueError, match="NUL"):
            action(str(tmp_path / "a\0b.off"))
    assert sorted(os.listdir(tmp_path)) == before
    with pytest.raises(dupin.errors.ParseFailed):
        dupin.boolean("a\0 - b", a=solid, b=solid)


def test_stl_of_what_touches_itself_is_apart(box, tmp_path):
    united = dupin.union(box(), box((1, 1, 0), (2, 2, 1)))
    report = united.write(tmp_path / "a.stl")
    assert report["settled"]["policy"] == "separate" and 0 < report["settled"]["length"] < 1e-5
    assert report["contacts"] == [] and dupin.check(tmp_path / "a.stl")["solid"]
    assert "settled" not in united.write(tmp_path / "a.off")


def test_numbers_are_real_and_there(box):
    solid = dupin.as_solid(*box())
    for action in (solid.translate, lambda v: solid.rotate(v, 90), lambda v: solid.mesh(origin=v),
                   lambda v: solid.rotate([0, 0, 1], 90, about=v)):
        for vector in (np.ma.array([1.0, 2, 3], mask=[1, 0, 0]), [1, 2, 3j], [1, 2], 5, "abc", [[1, 2, 3]]):
            with pytest.raises(dupin.errors.InvalidArgument):
                action(vector)
        action((1, 0, 0))


def test_labels_and_units_are_looked_at(box, tmp_path):
    points, triangles = box()
    with pytest.raises(dupin.errors.InvalidArgument, match="one for each of the 12 triangles, not 3"):
        dupin.Mesh(points, triangles, np.zeros(3, int), ["a"])
    for write in (dupin.as_solid(points, triangles).write, lambda file, unit: dupin.write_mesh(file, box(), unit=unit)):
        with pytest.raises(dupin.errors.InvalidArgument, match="um, mm, cm, m, in or ft, not 'foo'"):
            write(tmp_path / "a.off", unit="foo")
    with pytest.raises(dupin.errors.InvalidArgument, match="not 9223372036854775811"):
        dupin.as_mesh(points, triangles.astype(np.uint64) + np.uint64(2**63 + 3))
    assert list(tmp_path.iterdir()) == []


def test_long_operations_tell_and_can_be_ended(box):
    touching = dupin.union(box(), box((1, 1, 0), (2, 2, 1)))
    (points, triangles), (more, _) = box(), box((0.5, 0.5, 0.5), (2, 2, 2))
    crossing = np.concatenate([points, more]), np.concatenate([triangles, triangles + 8])
    for action in (lambda p: touching.separate(0.1, progress=p), lambda p: touching.bridge(0.1, progress=p),
                   lambda p: touching.simplify(0.1, progress=p), lambda p: dupin.repair(crossing, progress=p),
                   lambda p: dupin.union(box(), box((0.5, 0.5, 0.5), (2, 2, 2)), progress=p)):
        stages = []
        action(lambda stage, fraction: stages.append(stage))
        assert stages
        for no in (False, 0, np.False_, ""):
            with pytest.raises(dupin.errors.Cancelled):
                action(lambda stage, fraction: no)
        for yes in (None, True, 1, np.True_, "go on"):
            action(lambda stage, fraction: yes)
    with pytest.raises(ValueError, match="ambiguous"):
        touching.simplify(0.1, progress=lambda stage, fraction: np.zeros(2))


def test_simplify_keeps_a_solid(box):
    a, b = dupin.as_solid(*box()), dupin.as_solid(*box((0.25, 0.25, 0.5), (0.75, 0.75, 1.5)))
    united = dupin.union(a, b, box((0.5, 0, 0), (1, 1, 1)))
    mesh = united.simplify(1e-6)
    assert len(mesh.triangles) < len(united.triangles) and dupin.check(mesh)["solid"]


@pytest.mark.skipif(not dupin.has_mesh_generator, reason="this build makes no meshes for solvers")
def test_remesh_makes_well_shaped_triangles(box):
    stages = []
    made, report = dupin.remesh(box((0, 0, 0), (4, 2, 1)), 0.01, size=0.5,
                                progress=lambda stage, fraction: stages.append((stage, fraction)))
    points, triangles = made.points, made.triangles
    corners = points[triangles]
    sides = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
    a, b, c = np.sort(sides, axis=1).T
    smallest = np.arccos((b * b + c * c - a * a) / (2 * b * c)).min()
    assert smallest == pytest.approx(report["smallest_angle"]) and smallest >= np.radians(25)
    assert report["poor_triangles"] == report["poor_between_edges"] == 0 and report["worst"] == []
    assert c.max() <= 0.5 and report["deviation"] <= 0.01 == report["distance"]
    assert made.volume == pytest.approx(8) and made.components == 1
    assert {"mesh", "prove"} <= {stage for stage, _ in stages}
    assert all(0 <= fraction <= 1 for _, fraction in stages)


@pytest.mark.skipif(not dupin.has_mesh_generator, reason="this build makes no meshes for solvers")
def test_remesh_says_what_is_wrong_and_can_be_ended(box):
    with pytest.raises(dupin.errors.InvalidArgument, match="distance"):
        dupin.remesh(box(), 0)
    with pytest.raises(dupin.errors.InvalidArgument, match="30 degrees"):
        dupin.remesh(box(), 0.1, angle=31)
    with pytest.raises(dupin.errors.LimitExceeded):
        dupin.remesh(box(), 0.1, size=0.01, most_points=100)
    with pytest.raises(dupin.errors.Cancelled):
        dupin.remesh(box(), 0.1, progress=lambda stage, fraction: False)

    class Own(Exception):
        pass

    def fail(stage, fraction):
        raise Own

    with pytest.raises(Own):
        dupin.remesh(box(), 0.1, progress=fail)
    touching = dupin.union(box(), box((1, 1, 0), (2, 2, 1)))
    with pytest.raises(dupin.Error) as caught:
        dupin.remesh(touching, 0.1)
    assert caught.value.code == "contact"


def test_gaps_of_meshes(box):
    report = dupin.mesh_gaps(box(), box((1.001, 0, 0), (2, 1, 1)), connect=0.01)
    assert len(report["facing"]) == 1 and report["components"] == 2
    points, triangles = box()
    assert len(dupin.mesh_gaps((points, triangles[1:]))["boundary_a"]) == 1


def test_meshes_of_other_libraries(box):
    points, triangles = box()

    class Trimesh:  # as trimesh has them
        vertices, faces = points, triangles.astype(np.int64)

    class Block:
        type, data = "triangle", triangles

    class Meshio:
        cells = [Block]

    Meshio.points = points

    class PolyData:
        faces = np.hstack([np.full((12, 1), 3), triangles]).ravel()

    PolyData.points = points
    for mesh in (Trimesh, Meshio, PolyData):
        assert dupin.as_solid(mesh).volume == 1

    class Quads(PolyData):
        faces = np.array([4, 0, 1, 2, 3])

    with pytest.raises(dupin.errors.InvalidArgument, match="must be triangles"):
        dupin.as_mesh(Quads)


@pytest.mark.parametrize("library", ["trimesh", "meshio", "pyvista"])
def test_meshes_go_to_other_libraries_and_come_back(box, library):
    pytest.importorskip(library)
    solid = dupin.as_solid(*box())
    other = getattr(solid, f"to_{library}")()
    assert type(other).__module__.split(".")[0] == library
    assert dupin.as_solid(other).volume == 1


def test_a_library_that_is_not_there_is_named(box, monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "trimesh", None)
    with pytest.raises(ImportError, match="trimesh is not installed"):
        dupin.as_mesh(box()).to_trimesh()


@pytest.mark.parametrize("points", [np.array([2**63 + 1, 2**53, 1], np.uint64), np.array([2**53 + 1, -2**53, 0]),
                                    np.array([-2**63, 2**62, 2**53 + 1]),
                                    np.array(["0.1"], np.longdouble).repeat(3)])
def test_points_that_doubles_do_not_hold_are_refused(points):
    with pytest.raises(dupin.errors.InvalidArgument, match="float64 holds exactly"):
        dupin.as_mesh(points.reshape(1, 3), np.zeros((0, 3), np.uint32))


@pytest.mark.parametrize("points", [np.array([2**63, 2**53, 1], np.uint64), np.array([2**53 + 2, -2**53, 0]),
                                    np.array([0.5, np.nan, np.inf], np.longdouble)])
def test_points_that_doubles_hold_are_taken(points):
    mesh = dupin.as_mesh(points.reshape(1, 3), np.zeros((0, 3), np.uint32))
    assert np.array_equal(mesh.points[0], points.astype(float), equal_nan=True)


def test_masked_points_are_refused(box):
    points, triangles = box()
    with pytest.raises(dupin.errors.InvalidArgument, match="masked"):
        dupin.as_mesh(np.ma.masked_greater(points, 0.5), triangles)
    assert dupin.as_solid(np.ma.masked_greater(points, 5), triangles).volume == 1


def test_what_cannot_change_is_its_own_copy_and_meshes_are_pickled(box):
    solid = dupin.as_solid(*box())
    mesh = solid.mesh()
    for one in (solid, mesh):
        assert copy.copy(one) is one and copy.deepcopy([one])[0] is one
    labelled = dupin.Mesh(mesh.points, mesh.triangles, np.arange(12, dtype=np.uint32) % 2, ["a", "b"])
    for one in (mesh, labelled):
        back = pickle.loads(pickle.dumps(one))
        assert np.array_equal(back.points, one.points) and np.array_equal(back.triangles, one.triangles)
        assert back.names == one.names
        assert (back.labels is None) == (one.labels is None)
    assert np.array_equal(back.labels, labelled.labels)


@pytest.mark.parametrize("settle", [dupin.Solid.separate, dupin.Solid.bridge])
def test_lengths_that_contacts_cannot_be_settled_within_are_told_apart(settle, box):
    touching = dupin.union(box(), box((1, 1, 1), (2, 2, 2)))
    assert touching.contacts and not settle(touching, 0.1).contacts
    with pytest.raises(dupin.errors.ContactRefused, match="the length must be above"):
        settle(touching, 1e-30)
    for length in (0, -1, float("nan"), float("inf")):
        with pytest.raises(dupin.errors.InvalidArgument, match="positive and finite"):
            settle(touching, length)


class Own(dupin.Solid):
    def __init__(self):  # and not that of the solid
        pass


@pytest.mark.parametrize("kind", [dupin.Solid, dupin.Mesh, dupin.Certificate, Own])
def test_what_no_init_has_made_is_refused_wherever_it_is_used(kind, box, tmp_path):
    unmade = kind.__new__(kind)
    for name in dir(kind):
        if isinstance(getattr(kind, name), property):
            with pytest.raises(TypeError, match="__init__ was not called"):
                getattr(unmade, name)
    assert copy.copy(unmade) is unmade and copy.deepcopy(unmade) is unmade
    solid = dupin.as_solid(*box())
    uses = [lambda: repr(unmade)] if kind is not dupin.Certificate else [unmade.to_json, unmade.verify]
    if kind is dupin.Mesh:
        uses += [lambda: dupin.check(unmade), lambda: dupin.repair(unmade), lambda: dupin.mesh_gaps(solid, unmade),
                 lambda: list(unmade), lambda: dupin.as_solid(unmade), lambda: pickle.dumps(unmade),
                 lambda: dupin.write_mesh(tmp_path / "a.stl", unmade)]
    elif kind is not dupin.Certificate:
        uses += [lambda: solid + unmade, lambda: unmade + solid, lambda: dupin.union(solid, unmade), unmade.mesh,
                 lambda: dupin.boolean("a-b", a=solid, b=unmade), lambda: unmade.translate([1, 0, 0]),
                 lambda: unmade.exact_point(0), lambda: unmade.write(tmp_path / "a.stl"), lambda: unmade.simplify(1)]
    for use in uses:
        with pytest.raises(TypeError, match="__init__ was not called"):
            use()


def test_objects_come_from_no_other_door_unmade(box):
    with pytest.raises(TypeError, match="__init__"):
        Own()
    with pytest.raises(TypeError):
        dupin.Certificate()
    for one in (dupin.Solid(), Own.__new__(Own)):
        with pytest.raises(TypeError):
            pickle.dumps(one)
    foreign = pickle.dumps(dupin.Mesh(*box())).replace(b"Mesh", b"Solid")
    with pytest.raises((TypeError, pickle.UnpicklingError)):
        pickle.loads(foreign)
    mesh = dupin.Mesh(*box())
    with pytest.raises(TypeError):
        dupin.Solid.__init__(mesh)
    mesh.__init__([[0, 0, 0]], np.zeros((0, 3), np.uint32))  # a second time: it stays what it is
    assert len(mesh.points) == 8


def test_points_that_are_not_there_are_refused(box):
    with pytest.raises(IndexError, match="there are 8 points, from 0; not 8"):
        dupin.as_solid(*box()).exact_point(8)


def test_volumes_of_more_digits_than_python_reads_are_fractions(box):
    solid = part = dupin.as_solid(*box())
    for i in range(1, 4):
        part = part + solid.rotate([1, 2, i], 7 * i)
    usual = sys.get_int_max_str_digits()
    sys.set_int_max_str_digits(640)  # of decimal ones; 4300 if nobody says otherwise
    try:
        volume = part.exact_volume
    finally:
        sys.set_int_max_str_digits(usual)
    assert volume.denominator > 10 ** 640 and float(volume) == part.volume
