"""Bézier solids: exact primitives, and what takes several solids.

All primitives are oriented right (`jacobian` > 0 inside); the apex of cones, octants and wedges is
the point (0, 0, 0, n) of the net. Where the corners given turn the other way two of them are
exchanged. Lengths are in mm, angles in degrees. All raise ValueError that names the argument and
the rule for what is flat, empty or not finite, TypeError for what is no number.

    from osculate import solids
    cone = solids.cone(radius=10, height=30)
    print(cone.volume(), cone.validity())
    solid = cone.to_solid()              # in FreeCAD
"""

import math
import os

from osculate import _core

__all__ = [
    "ball_octant", "chain", "cone", "cylinder_wedge", "elliptic_cone", "frustum_wedge", "random",
    "sphere_wedge", "sphere_wedge_by_circles", "tetrahedron", "write_vtu",
]


def tetrahedron(a, b, c, d):
    """The tetrahedron with these corners, degree 1; of the orientation that they have."""
    return _core.solid_tetrahedron(a, b, c, d)


def cone(radius, height):
    """The circular cone with its base in the plane z = 0 about the origin, apex (0, 0, height).

    Degree 2, all weights > 0. The Jacobian vanishes only on the three rulings through the corners
    of the base, where it must: two edges of the base meet there at 180 degrees.
    """
    return _core.solid_cone(radius, height)


def elliptic_cone(radius_x, radius_y, apex):
    """The cone from any apex off the plane z = 0 to the ellipse there, half axes along x and y."""
    return _core.solid_elliptic_cone(radius_x, radius_y, apex)


def ball_octant(radius):
    """The eighth of the ball around the origin with x, y, z >= 0; degree 4."""
    return _core.solid_ball_octant(radius)


def sphere_wedge(centre, a, b, c):
    """The part of the ball over the spherical triangle a, b, c between planes through the centre.

    a, b, c: points at the same distance from the centre, not on one great circle, none opposite to
    another. A list of solids of degree 4: one, or more where the triangle is too large for one.
    """
    return _core.solid_sphere_wedge(centre, a, b, c)


def sphere_wedge_by_circles(centre, a, b, c):
    """The part of the ball over a triangle whose edges are circles through the point of the sphere
    opposite to its middle: one solid of degree 2, with cones as sides instead of planes."""
    return _core.solid_sphere_wedge_by_circles(centre, a, b, c)


def frustum_wedge(lower_radius, upper_radius, height, angle=360.0):
    """The sector of a truncated cone around the z axis from z = 0 to z = height, from the x axis
    through `angle` degrees (above 0, at most 360).

    A list of solids of degree 3 with a Jacobian > 0 everywhere: three for each 90 degrees begun,
    which meet in whole faces.
    """
    return _core.solid_frustum_wedge(lower_radius, upper_radius, height, math.radians(angle))


def cylinder_wedge(radius, height, angle=360.0):
    """The sector of a cylinder: `frustum_wedge` with equal radii."""
    return frustum_wedge(radius, radius, height, angle)


def random(degree, seed, dimension=3):
    """A rational solid to learn from, the same on every machine: the net of a regular tetrahedron
    of 100 mm edges with shaken points and random weights; in E4 with random fourth coordinates."""
    return _core.solid_random(degree, seed, dimension)


def chain(solid, links):
    """The solid, its neighbour, the neighbour's neighbour and so on, as a list.

    links: a tuple (apex, order) or a dict of the arguments of `BezierTetrahedron.join` for each.
    """
    solids = [solid]
    for link in links:
        if not isinstance(link, dict):
            apex, order = link
            link = {"apex": apex, "order": order}
        solids.append(solids[-1].join(**link))
    return solids


def write_vtu(solids, path):
    """Writes solids into one file for ParaView, as Bézier tetrahedra of VTK 9 with weights."""
    _core.write_solids_vtu(_checked(solids), os.fspath(path))


def _checked(solids):
    """The solids of an iterable as a list."""
    if isinstance(solids, _core.BezierTetrahedron) or not hasattr(solids, "__iter__"):
        raise TypeError("solids: a list of osculate.BezierTetrahedron is needed, got "
                        f"{type(solids).__name__}")
    solids = list(solids)
    for i, solid in enumerate(solids):
        if not isinstance(solid, _core.BezierTetrahedron):
            raise TypeError(f"solids[{i}]: an osculate.BezierTetrahedron is needed, got "
                            f"{type(solid).__name__}")
    return solids
