"""Triangles and lines of a Bézier solid for drawing, as arrays."""

import functools
import math
from dataclasses import dataclass

import numpy

from osculate.features.control_net import indices_of
from osculate.gui.solid.value import size_of

#: The chordal bound that is chosen, and the least that is drawn, as shares of the solid's size.
_CHOSEN, _LEAST = 1e-3, 2e-5
_ROUGH = 0.02  # where only the extent is asked for

#: Divisions of a face: the most that are drawn, and those where weights differ so much that bounds
#: of the second derivatives say nothing.
_MOST_DIVISIONS, _WILD_DIVISIONS = 200, 96
_WILD = 1e-6  # least weight as a share of the largest
_COARSEST = 4.0 ** 8  # bound of the first mesh that is tried

#: Divisions of the lattice on which Jacobians are computed.
_JACOBIAN_DIVISIONS = 32


@dataclass(frozen=True)
class Triangles:
    """A surface: points (N, 3), unit normals (N, 3), triangles (F, 3), values (N,) or None."""

    points: numpy.ndarray
    normals: numpy.ndarray
    triangles: numpy.ndarray
    values: numpy.ndarray = None


@dataclass(frozen=True)
class FaceTriangles:
    """The four faces of a solid as Triangles, with the divisions of their sides."""

    surfaces: tuple
    divisions: int


def bound_for(solid, deviation):
    """The chordal bound in mm for what a user asks: 0 for one by the size of the solid."""
    size = size_of(solid)
    return max(deviation, _LEAST * size) if deviation > 0.0 else _CHOSEN * size


def faces_of(solid, chordal_mm, with_jacobian=False):
    """The FaceTriangles of a solid in E3; nothing for a net that is a single point."""
    if not 0.0 < chordal_mm < math.inf:
        return FaceTriangles((), 0)
    if _is_wild(solid):
        return FaceTriangles(tuple(corner_slice(solid, corner, 0.0, _WILD_DIVISIONS, with_jacobian)
                                   for corner in range(4)), _WILD_DIVISIONS)
    meshes = _tessellated(solid, chordal_mm)
    divisions = _divisions(meshes)
    values = _face_jacobians(solid, divisions) if with_jacobian else (None,) * 4
    return FaceTriangles(tuple(
        _finite(mesh.points, mesh.normals, mesh.triangles, of_mesh)
        for mesh, of_mesh in zip(meshes, values)), divisions)


def edges_of(solid, divisions):
    """The six edges as rows of points, which are points of the faces' meshes, too."""
    share = numpy.linspace(0.0, 1.0, divisions + 1)
    lines = []
    for a in range(4):
        for b in range(a + 1, 4):
            u = numpy.zeros((divisions + 1, 4))
            u[:, a], u[:, b] = 1.0 - share, share
            lines.append(_known(solid.evaluate(u)))
    return lines


def parameter_lines(solid, divisions, count=4):
    """Lines of constant barycentric coordinates on the faces, `count` steps apart."""
    lines = []
    for face in range(4):
        corners = [corner for corner in range(4) if corner != face]
        for fixed, start, end in (corners, corners[1:] + corners[:1], corners[2:] + corners[:2]):
            for step in range(1, count):
                share = numpy.linspace(0.0, 1.0 - step / count, divisions + 1)
                u = numpy.zeros((divisions + 1, 4))
                u[:, fixed] = step / count
                u[:, start], u[:, end] = 1.0 - step / count - share, share
                lines.append(_known(solid.evaluate(u)))
    return lines


def corner_slice(solid, corner, value, divisions, with_jacobian=False):
    """The surface on which the barycentric coordinate of a corner has a value, as Triangles."""
    u = numpy.zeros((len(lattice(divisions)), 4))
    others = [other for other in range(4) if other != corner]
    u[:, others] = (1.0 - value) * lattice(divisions)
    u[:, corner] = value
    return _surface(solid, solid.evaluate(u), lattice_triangles(divisions), u, with_jacobian)


def plane_slice(solid, axis, place, divisions, with_jacobian=False):
    """The section with the plane on which coordinate `axis` has the value `place`, in mm."""
    section = solid.slice(place * numpy.eye(3)[axis], numpy.eye(3)[axis], divisions)
    return _surface(solid, section.points, section.triangles, section.coordinates, with_jacobian)


def extent(solid, axis):
    """(lowest, highest) coordinate of the points of the solid's faces along an axis, in mm."""
    surfaces = faces_of(solid, _ROUGH * size_of(solid)).surfaces
    places = [surface.points[numpy.unique(surface.triangles), axis] for surface in surfaces]
    places = numpy.concatenate(places) if places else numpy.empty(0)
    return (float(places.min()), float(places.max())) if len(places) else (0.0, 0.0)


def rim_of(triangles):
    """The sides that only one triangle has, as pairs of points."""
    sides = {}
    for triangle in triangles.tolist():
        for start, end in zip(triangle, triangle[1:] + triangle[:1]):
            key = min(start, end), max(start, end)
            sides[key] = sides.get(key, 0) + 1
    return [side for side, count in sides.items() if count == 1]


@functools.lru_cache(maxsize=16)
def lattice(divisions):
    """The barycentric coordinates (N, 3) of a triangle's points at (i, j, k)/divisions, in the
    order of the core's meshes.
    """
    return numpy.array([(divisions - r2, r2 - r3, r3) for r2 in range(divisions + 1)
                        for r3 in range(r2 + 1)]) / divisions


@functools.lru_cache(maxsize=4)
def solid_lattice(divisions):
    """The barycentric coordinates (N, 4) of a tetrahedron's points at (i, j, k, l)/divisions."""
    return numpy.array(indices_of(divisions)) / divisions


@functools.lru_cache(maxsize=16)
def lattice_triangles(divisions):
    """The triangles (F, 3) between the points of a lattice."""
    triangles = []
    for r2 in range(divisions):
        for r3 in range(r2 + 1):
            here, below = _position(r2, r3), _position(r2 + 1, r3)
            triangles.append((here, below, below + 1))
            if r3 < r2:
                triangles.append((here, below + 1, here + 1))
    return numpy.array(triangles)


def interpolated(values, coarse, fine):
    """Values at the points of a lattice of `coarse` divisions, carried to one of `fine`."""
    rows = numpy.rint(lattice(fine) * fine)
    along = (fine - rows[:, 0]) * coarse / fine  # the places r2, r3 in the coarse lattice
    across = rows[:, 2] * coarse / fine
    row = numpy.minimum(along.astype(int), coarse - 1)
    column = numpy.minimum(across.astype(int), row)
    down, right = along - row, across - column
    here, below = _position(row, column), _position(row + 1, column)
    is_lower = right <= down
    beside = numpy.where(is_lower, below, numpy.minimum(here + 1, len(values) - 1))
    first, second = numpy.where(is_lower, down, right), numpy.where(is_lower, right, down)
    return ((1.0 - first) * values[here] + (first - second) * values[beside]
            + second * values[below + 1])


def _position(r2, r3):
    return r2 * (r2 + 1) // 2 + r3


def _is_wild(solid):
    weights = solid.weights
    return weights is not None and weights.min() <= _WILD * weights.max()


def _tessellated(solid, chordal_mm):
    """The core's meshes, coarser than asked where a face would have too many divisions.

    They go with the root of the bound: tried from coarse ones on, as long as they do not say that
    the next is too fine.
    """
    bound = chordal_mm * _COARSEST
    meshes = solid.tessellate(bound)
    while bound > chordal_mm and 2 * _divisions(meshes) <= _MOST_DIVISIONS:
        bound /= 4.0
        meshes = solid.tessellate(bound)
    return meshes


def _divisions(meshes):
    """The divisions m of faces with (m + 1)(m + 2)/2 points."""
    return (math.isqrt(8 * len(meshes[0].points) + 1) - 3) // 2


def _face_jacobians(solid, divisions):
    """The Jacobian determinant at the points of each face's mesh.

    On a fine mesh it is interpolated: its evaluation takes longer than that of the points.
    """
    coarse = min(divisions, _JACOBIAN_DIVISIONS)
    for face in range(4):
        u = numpy.zeros((len(lattice(coarse)), 4))
        u[:, [corner for corner in range(4) if corner != face]] = lattice(coarse)
        values = solid.jacobian(u)
        yield values if coarse == divisions else interpolated(values, coarse, divisions)


def _surface(solid, points, triangles, coordinates, with_jacobian):
    values = solid.jacobian(coordinates) if with_jacobian and len(coordinates) else None
    return _finite(points, _vertex_normals(points, triangles), triangles, values)


def _vertex_normals(points, triangles):
    """Unit normals at the points, from the triangles around each, weighed by area."""
    corners = points[triangles]
    across = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals = numpy.zeros_like(points)
    for corner in range(3):
        numpy.add.at(normals, triangles[:, corner], across)
    lengths = numpy.linalg.norm(normals, axis=1, keepdims=True)
    return numpy.divide(normals, lengths, out=numpy.zeros_like(normals), where=lengths > 0.0)


def _finite(points, normals, triangles, values):
    """Triangles without those at a corner of weight 0, where there is no point."""
    is_known = numpy.isfinite(points).all(axis=1)
    if values is not None:
        values = numpy.nan_to_num(values)
    return Triangles(numpy.where(is_known[:, None], points, 0.0), numpy.nan_to_num(normals),
                     triangles[is_known[triangles].all(axis=1)], values)


def _known(points):
    return points[numpy.isfinite(points).all(axis=1)]
