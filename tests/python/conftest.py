import pathlib

import numpy as np
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "examples"


def box_arrays(low=(0, 0, 0), high=(1, 1, 1)):
    """The points and triangles of a box."""
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]
    low, high = np.asarray(low, float), np.asarray(high, float)
    return low + corners * (high - low), np.array(triangles, np.uint32)


@pytest.fixture
def box():
    return box_arrays
