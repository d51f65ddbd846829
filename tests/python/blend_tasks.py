"""Pairs of curves with a gap between the end of the first and the start of the second."""
from osculate import Curve
from support import cubic


def planar_task():
    """A bend of about 90 degrees between two bent arms, 64 mm apart."""
    return (Curve.bezier([(-40, 6, 0), (-25, 1, 0), (-12, 0, 0), (0, 0, 0)]),
            Curve.bezier([(50, 40, 0), (50, 52, 0), (48, 66, 0), (44, 80, 0)]))


def spatial_task():
    """Two twisted arms, the second rational."""
    return (Curve.bezier([(-40, 8, 5), (-28, 2, 3), (-14, -1, 1), (0, 0, 0)]),
            Curve.bezier([(60, 20, 10), (72, 24, 16), (84, 22, 20), (100, 30, 22)], [1, 1.5, 1, 2]))


def pieces_task():
    """Two pieces of a twisted cubic, without the one between them."""
    return cubic().trimmed(0, 0.3), cubic().trimmed(0.7, 1)


def mirrored_task():
    """Two arms that mirror each other in the plane x = 30."""
    arm = planar_task()[0]
    return arm, Curve.bezier(arm.reversed().poles * (-1, 1, 1) + (60, 0, 0))
