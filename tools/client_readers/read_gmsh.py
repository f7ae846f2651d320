"""Reads files by gmsh (tools/clients.py)."""
import gmsh
from measure import answer, measure


def triangles(repeated):
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    names = {int(tag): index for index, tag in enumerate(tags)}
    kinds, _, nodes = gmsh.model.mesh.getElements(2)
    assert set(kinds) <= {2}, "not only triangles"
    corners = [[names[tag] for tag in triangle] for block in nodes for triangle in block.reshape(-1, 3).tolist()]
    return measure(coordinates.reshape(-1, 3).tolist(), corners, repeated)


def read(path, form, repeated):
    gmsh.clear()
    gmsh.logger.start()
    try:
        gmsh.merge(path)
    finally:
        said = [line for line in gmsh.logger.get() if not line.startswith("Info")]
        gmsh.logger.stop()
    found = {"solids": len(gmsh.model.occ.getEntities(3))} if form == "step" else triangles(repeated)
    return {**found, "complaint": "; ".join(said)}


gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
answer(read)
