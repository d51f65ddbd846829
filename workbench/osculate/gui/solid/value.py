"""The Bézier solid that a document object's properties describe, as the 3D view draws it."""

import functools

import numpy

import osculate


def value_of(obj):
    """The osculate.BezierTetrahedron of a BezierSolid, None if its properties make none.

    It is made from the properties and not taken from the last recompute, so that the drawing is
    right after undo, after loading and in the middle of a drag.
    """
    fourth = list(getattr(obj, "FourthCoordinates", ()))
    points = [tuple(point) for point in getattr(obj, "Points", ())]
    weights = list(getattr(obj, "Weights", ()))
    if fourth and len(fourth) == len(points):
        points = [(*point, last) for point, last in zip(points, fourth)]
    try:
        return osculate.BezierTetrahedron(_degree_of(len(points)), points, weights or None)
    except (ValueError, TypeError):
        return None  # some properties are set and others not yet, or the recompute says why


def in_space(solid):
    """A solid in E3: itself, or the projection along the fourth axis."""
    return solid.project() if solid.dimension == 4 else solid


def size_of(solid):
    """The diagonal of the box of its control points, in mm."""
    low, high = solid.box
    return float(numpy.linalg.norm(numpy.subtract(high, low)))


@functools.lru_cache(maxsize=None)
def indices_of(degree):
    """The indices (i, j, k, l) of a net in the core's order."""
    return tuple((i, j, k, degree - i - j - k) for i in range(degree, -1, -1)
                 for j in range(degree - i, -1, -1) for k in range(degree - i - j, -1, -1))


def _degree_of(count):
    """The degree of a net of so many points, 0 if there is none."""
    degree = 0
    while (degree + 1) * (degree + 2) * (degree + 3) // 6 < count:
        degree += 1
    return degree
