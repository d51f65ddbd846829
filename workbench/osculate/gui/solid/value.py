"""The Bézier solid that a document object's properties describe, as the 3D view draws it."""

import numpy

from osculate.features import control_net


def value_of(obj):
    """The osculate.BezierTetrahedron of a BezierSolid, None if its properties make none.

    It is made from the properties and not taken from the last recompute, so that the drawing is
    right after undo, after loading and in the middle of a drag.
    """
    try:
        return control_net.value_of(*(getattr(obj, name, ()) for name in
                                      ("Points", "Weights", "FourthCoordinates")))
    except ValueError:
        return None  # some properties are set and others not yet, or the recompute says why


def in_space(solid):
    """A solid in E3: itself, or the projection along the fourth axis."""
    return solid.project() if solid.dimension == 4 else solid


def size_of(solid):
    """The diagonal of the box of its control points, in mm."""
    low, high = solid.box
    return float(numpy.linalg.norm(numpy.subtract(high, low)))
