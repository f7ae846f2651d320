"""Reads files by meshio (tools/clients.py)."""
import meshio
from measure import answer, measure

FORMATS = {"msh-surface": "gmsh", "stl-ascii": "stl", "ply-ascii": "ply"}


def read(path, form, repeated):
    mesh = meshio.read(path, file_format=FORMATS.get(form, form))
    assert all(block.type == "triangle" for block in mesh.cells), "not only triangles"
    triangles = [triangle for block in mesh.cells for triangle in block.data.tolist()]
    return measure(mesh.points.tolist(), triangles, repeated)


answer(read)
