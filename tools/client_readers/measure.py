"""What the readers beside this share: what they are asked, what they answer, and measures of triangles."""
import collections
import json
import sys


def measure(points, triangles, repeated):
    """The triangles' number, the volume inside, and how many edges are not shared by two in opposite directions."""
    if repeated:
        first = {}
        names = [first.setdefault(tuple(point), index) for index, point in enumerate(points)]
        triangles = [[names[corner] for corner in triangle] for triangle in triangles]
    volume, edges = 0.0, collections.Counter()
    for a, b, c in triangles:
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = points[a], points[b], points[c]
        volume += (ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)) / 6
        edges.update([(a, b), (b, c), (c, a)])
    wrong = sum(count != 1 or edges[b, a] != 1 for (a, b), count in edges.items())
    return {"triangles": len(triangles), "volume": volume, "open_edges": wrong}


def answer(read):
    """Prints what read(path, format, repeated) says of each file of the list that the last argument is."""
    for path, form, repeated in json.loads(sys.argv[-1]):
        try:
            said = read(path, form, repeated)
        except Exception as error:  # a client's own, whatever it is
            said = {"complaint": f"{type(error).__name__}: {error}"}
        print("SAID " + json.dumps({"path": path, **said}), flush=True)
