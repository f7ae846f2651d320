"""Exact, robust solid modelling of smoothly blended pipe assemblies.

    import dupin

    assembly = (dupin.Assembly(units="mm", tolerance=0.05)
                .pipe("inlet", from_=[-10, 0, 0], to=[0, 0, 0], radius=1)
                .pipe("outlet", from_=[10, 4, 0], direction=[1, 2, 10], length=10, radius=2)
                .cyclic_blend("blend", from_="inlet.end", to="outlet.start", k=10, l=20))
    built = dupin.build(assembly)
    built.write("reducer.stl")
    points, triangles = built.mesh()

Documents are `Assembly` objects, dicts, or names of files. Meshes are `Mesh` objects, pairs of
arrays, names of files, or what trimesh, meshio and PyVista have. Reports are dicts with the keys
that `dupin --json` prints (docs/cli.md). Whatever is impossible raises an `Error` that names code,
part and place. Long operations let other threads run, and Ctrl-C ends them.
"""

from . import errors
from ._core import (Certificate, Mesh, Solid, __version__, error_codes, has_mesh_generator, mesh_formats, part_keys)
from .assembly import Assembly
from .documents import (Built, Document, bill_of_materials, build, certify, gaps, nurbs, read_document, schema, verify)
from .errors import Error
from .meshes import (MeshLike, SolidLike, as_mesh, as_solid, boolean, check, intersection, mesh_gaps, read_mesh, remesh,
                     repair, subtract, to_meshio, to_pyvista, to_trimesh, union, write_mesh)

__all__ = [
    "Assembly", "Built", "Certificate", "Document", "Error", "Mesh", "MeshLike", "Solid", "SolidLike", "__version__",
    "as_mesh", "as_solid", "bill_of_materials", "boolean", "build", "certify", "check", "error_codes", "errors", "gaps",
    "has_mesh_generator", "intersection", "mesh_formats", "mesh_gaps", "nurbs", "part_keys", "read_document",
    "read_mesh", "remesh", "repair", "schema", "subtract", "to_meshio", "to_pyvista", "to_trimesh", "union", "verify",
    "write_mesh",
]
