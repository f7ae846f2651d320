"""Meshes, solids, and the operations on them."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from typing import Any, Union

import numpy as np

from . import _core
from ._core import Mesh, Solid
from .errors import InvalidArgument

#: A Mesh, a Solid, (points, triangles), the name of a file, or a mesh of trimesh, meshio or PyVista.
MeshLike = Any
#: What MeshLike is; it has to be a solid.
SolidLike = Any
#: Called with a stage's name and the fraction done in [0, 1]; returning False cancels.
Progress = Union[Callable[[str, float], Any], None]


def _polygons_of(faces: np.ndarray) -> np.ndarray:
    """The triangles of PyVista's faces: [3, i, j, k, 3, ...]."""
    faces = np.asarray(faces).reshape(-1)
    if faces.size % 4 or (faces.size and (faces[::4] != 3).any()):
        raise InvalidArgument("the faces must be triangles; see triangulate() of the mesh", where="faces")
    return faces.reshape(-1, 4)[:, 1:]


def _meshio_triangles(mesh: Any) -> np.ndarray:
    blocks = [block.data for block in mesh.cells if block.type == "triangle"]
    others = sorted({block.type for block in mesh.cells} - {"triangle", "vertex", "line"})
    if others:
        raise InvalidArgument(f"the mesh has cells that are no triangles: {', '.join(others)}", where="cells")
    return np.concatenate(blocks) if blocks else np.zeros((0, 3), np.uint32)


def _is_whole(item: Any) -> bool:
    """Whether it is a mesh of its own, and no array of points or triangles."""
    return isinstance(item, (Mesh, Solid, str, bytes, os.PathLike)) or hasattr(item, "solid") or hasattr(item, "faces")


def as_mesh(mesh: MeshLike, triangles: Any = None) -> Mesh:
    """A Mesh of whatever is one: arrays that lie in memory as the library's do are copied, not converted.

    Accepts a Mesh, (points, triangles) or both as arguments, a file's name, a Solid or what was built (rounded once, so
    that it stays a solid), and meshes of trimesh, meshio and PyVista. Raises InvalidArgument naming what does not fit.
    """
    if triangles is not None:
        return Mesh(mesh, triangles)
    if isinstance(mesh, Mesh):
        return mesh
    if isinstance(mesh, Solid):
        return mesh.mesh()
    if hasattr(mesh, "solid") and isinstance(mesh.solid, Solid):  # Built
        return mesh.solid.mesh()
    if isinstance(mesh, (str, bytes, os.PathLike)):
        return read_mesh(mesh)
    if isinstance(mesh, (tuple, list)) and any(_is_whole(item) for item in mesh):
        raise InvalidArgument(f"a {type(mesh).__name__} of solids, meshes or files is no mesh; they are separate "
                              "arguments, as in union(a, b) or union(*solids)")
    if isinstance(mesh, (tuple, list)) and len(mesh) == 2:
        return Mesh(*mesh)
    if hasattr(mesh, "vertices") and hasattr(mesh, "faces"):  # trimesh
        return Mesh(mesh.vertices, mesh.faces)
    if hasattr(mesh, "points") and hasattr(mesh, "cells"):  # meshio
        points = np.asarray(mesh.points)
        if points.ndim == 2 and points.shape[1] == 2:
            raise InvalidArgument("the points lie in a plane: a solid needs three coordinates", where="points")
        return Mesh(points, _meshio_triangles(mesh))
    if hasattr(mesh, "points") and hasattr(mesh, "faces"):  # PyVista
        return Mesh(mesh.points, _polygons_of(mesh.faces))
    raise InvalidArgument(f"a {type(mesh).__name__} is no mesh; give points and triangles, a file's name, or a mesh "
                          "of trimesh, meshio or PyVista")


def as_solid(mesh: SolidLike, triangles: Any = None) -> Solid:
    """A Solid of whatever is a mesh of one. Raises NotClosed, NotManifold, NotOriented, SelfIntersecting or
    InvalidArgument with the faces at fault; `repair` mends what needs no guess."""
    if triangles is None:
        if isinstance(mesh, Solid):
            return mesh
        if hasattr(mesh, "solid") and isinstance(mesh.solid, Solid):
            return mesh.solid
    return Solid._from(as_mesh(mesh, triangles))


def read_mesh(file: str | os.PathLike[str]) -> Mesh:
    """The mesh in a file, whose format is told by its content."""
    return _core.read_mesh(os.fsencode(file))


def write_mesh(file: str | os.PathLike[str], mesh: MeshLike, *, format: str = "", unit: str = "") -> dict[str, Any]:
    """Writes any mesh, each coordinate rounded to what the format holds, and returns what `check` says of the file.
    The format is the one that the extension names, if it is not given. For solids see Solid.write."""
    return json.loads(_core.write_mesh(as_mesh(mesh), os.fsencode(file), format, unit))


def check(mesh: MeshLike, triangles: Any = None, *, limit: int = 100,
          self_intersections: bool = True) -> dict[str, Any]:
    """Every fault of a mesh, by exact predicates on its very numbers: `report["solid"]` tells whether it is one,
    `report["counts"]` how many faults there are of each kind, `report["findings"]` the first `limit` of each with the
    faces, points and a place. `volume` and `genus` are None unless it is `watertight`. Never raises for bad meshes."""
    return json.loads(_core.check(as_mesh(mesh, triangles), limit, self_intersections))


def repair(mesh: MeshLike, triangles: Any = None, *, progress: Progress = None) -> tuple[Solid, dict[str, Any]]:
    """A Solid of a mesh that is none, where nothing has to be guessed, and what was done. Holes are never filled:
    NotClosed names the first open edge."""
    return _core.repair(as_mesh(mesh, triangles), progress)


def mesh_gaps(a: MeshLike, b: MeshLike | None = None, *, connect: float | None = None) -> dict[str, Any]:
    """How two meshes miss each other, or one by itself: boundary loops, and regions where faces look at each other
    from at most `connect` away; by default 1/1000 of the diagonal of the box around both."""
    first = as_mesh(a)
    second = as_mesh(b) if b is not None else Mesh(np.zeros((0, 3)), np.zeros((0, 3), np.uint32))
    if connect is None:
        points = np.concatenate([first.points, second.points])
        connect = float(np.linalg.norm(points.max(0) - points.min(0))) * 1e-3 if len(points) else 0.0
    return json.loads(_core.mesh_gaps(first, second, connect))


def boolean(expression: str, operands: dict[str, SolidLike] | None = None, *, contacts: str = "report",
            progress: Progress = None, **named: SolidLike) -> Solid:
    """The set of an expression in one exact arrangement: `boolean("(a + b) - c", a=..., b=..., c=...)`.

    `+` unites, `-` subtracts, `&` intersects and binds tighter. Operands are whatever is a solid: see as_solid.
    `contacts="refuse"` raises ContactRefused where the result touches itself.
    """
    given = {**(operands or {}), **named}
    used = {name: _operand(name, given[name]) for name in _core.expression_names(expression) if name in given}
    return _core.evaluate(expression, used, contacts, progress)


def _operand(name: str, mesh: SolidLike) -> Solid:
    from .errors import Error, error_of

    try:
        return as_solid(mesh)
    except Error as error:  # which of the operands it is
        if error.part:
            raise
        raise error_of(error.code, error.message, name, error.where) from None


def _combine(operation: str, solids: tuple[SolidLike, ...], contacts: str, progress: Progress) -> Solid:
    return _core.combine(operation, [_operand(str(place), solid) for place, solid in enumerate(solids)], contacts,
                         progress)


def union(*solids: SolidLike, contacts: str = "report", progress: Progress = None) -> Solid:
    """All that is in one of the solids, exactly; of none the empty set."""
    return _combine("union", solids, contacts, progress)


def intersection(*solids: SolidLike, contacts: str = "report", progress: Progress = None) -> Solid:
    """What is in all of the solids, exactly."""
    if not solids:
        raise InvalidArgument("an intersection needs at least one solid")
    return _combine("intersection", solids, contacts, progress)


def subtract(solid: SolidLike, *others: SolidLike, contacts: str = "report", progress: Progress = None) -> Solid:
    """The first solid without all others, exactly."""
    return _combine("difference", (solid, *others), contacts, progress)


def remesh(solid: SolidLike, distance: float, *, size: float = 0.0, angle: float = 25.0, sharp: float = 40.0,
           most_points: int = 4_000_000, progress: Progress = None) -> tuple[Solid, dict[str, Any]]:
    """The same solid with well-shaped triangles, as meshes for solvers begin with, and a report on them.

    distance        largest from any point of either surface to the other, proved; in the solid's unit
    size            of the longest edge; a tenth of the diagonal of the box around the solid if not given
    angle           smallest of a triangle in degrees, 30 at most, as far as sharp edges allow
    sharp           edges where the surface turns by more, in degrees, are kept, as borders between labels are
    most_points     of the mesh
    progress        progress(stage, fraction); returning False raises Cancelled

    The report is `solver_mesh` of `dupin remesh --json`, with angles in radians: deviation, smallest_angle,
    poor_triangles and where the worst are, ... Raises ContactRefused for a solid that touches itself, LimitExceeded
    where lengths ask for too many points, Unroundable where the distance cannot be kept, and InvalidArgument for
    values out of range and where `dupin.has_mesh_generator` is false.
    """
    made, report = _core.remesh(as_solid(solid), distance, size, angle, sharp, most_points, progress)
    return made, json.loads(report)["solver_mesh"]


def _module(name: str) -> Any:
    import importlib

    try:
        return importlib.import_module(name)
    except ImportError:
        raise ImportError(f"{name} is not installed") from None


def to_trimesh(mesh: MeshLike) -> Any:
    """A trimesh.Trimesh; face_attributes["label"] holds the labels, metadata["names"] what they stand for."""
    source = as_mesh(mesh)
    attributes = {} if source.labels is None else {"label": np.array(source.labels)}
    return _module("trimesh").Trimesh(np.array(source.points), np.array(source.triangles), process=False,
                                      face_attributes=attributes, metadata={"names": source.names})


def to_meshio(mesh: MeshLike) -> Any:
    """A meshio.Mesh; cell_data["label"] holds the labels, field_data what they stand for."""
    source = as_mesh(mesh)
    labels = {} if source.labels is None else {"label": [np.array(source.labels)]}
    names = {name: np.array([number, 2]) for number, name in enumerate(source.names)}
    return _module("meshio").Mesh(np.array(source.points), [("triangle", np.array(source.triangles, np.int64))],
                                  cell_data=labels, field_data=names)


def to_pyvista(mesh: MeshLike) -> Any:
    """A pyvista.PolyData; cell_data["label"] holds the labels, field_data["names"] what they stand for."""
    source = as_mesh(mesh)
    threes = np.full((len(source.triangles), 1), 3, np.int64)
    data = _module("pyvista").PolyData(np.array(source.points), np.hstack([threes, source.triangles]).ravel())
    if source.labels is not None:
        data.cell_data["label"] = np.array(source.labels)
        data.field_data["names"] = np.array(source.names)
    return data


def _write(self: Solid, file: str | os.PathLike[str], *, format: str = "", unit: str = "",
           rounding_tolerance: float = 0.0, grid: float = 0.0, origin: Any = None,
           progress: Progress = None) -> dict[str, Any]:
    """Rounds once, writes, reads back and verifies; only then does the file take its place. Returns the report.

    The format is the one that the extension names, if it is not given. In STL, whose readers weld what is in one place,
    the solid is apart where it touches itself, by as little as its numbers allow; `report["settled"]` says where. Raises
    Unroundable, naming the place, ContactRefused where that cannot be, and IoFailed; then no file is left behind, and one
    that was there stays as it was.
    """
    return json.loads(self._write(os.fsencode(file), format, unit, rounding_tolerance, grid, origin, progress))


def _read(file: str | os.PathLike[str]) -> Solid:
    """The solid in a mesh file."""
    return as_solid(read_mesh(file))


def same(self: Any, memo: Any = None) -> Any:
    """What cannot change is its own copy."""
    return self


def _reduce(self: Mesh) -> tuple[Any, ...]:
    labels = None if self.labels is None else np.array(self.labels)
    return Mesh, (np.array(self.points), np.array(self.triangles), labels, list(self.names))


Mesh.__reduce__ = _reduce
Solid.write = _write
Solid.read = staticmethod(_read)
for _kind in (Solid, Mesh):
    _kind.to_trimesh, _kind.to_meshio, _kind.to_pyvista = to_trimesh, to_meshio, to_pyvista
    _kind.__copy__ = _kind.__deepcopy__ = same
