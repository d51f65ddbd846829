"""The control net of a Bézier solid as lists: its indices, its checks, the value that it makes."""

import functools
import math

import FreeCAD

import osculate

translate = FreeCAD.Qt.translate

MOST_DEGREE = 12  #: that the core takes

#: What the columns of a net are called, in sentences and in tables that are pasted.
X, Y, Z, FOURTH, WEIGHT = COLUMNS = ("x", "y", "z", "fourth", "weight")


class NetError(ValueError):
    """A net that is none; `row` (from 0) and `column` say where, None where it is no single number.
    """

    def __init__(self, sentence, row=None, column=None):
        super().__init__(sentence)
        self.row, self.column = row, column


def count_of(degree):
    """How many points a net has."""
    return (degree + 1) * (degree + 2) * (degree + 3) // 6


def degree_of(count):
    """The degree of a net with so many points. Raises NetError."""
    counts = {count_of(degree): degree for degree in range(1, MOST_DEGREE + 1)}
    if count not in counts:
        raise NetError(translate(
            "Osculate", "{} points are no net: degree 1 has 4, degree 2 has 10, degree 3 has 20, "
                        "… degree 12 has 455.").format(count))
    return counts[count]


@functools.cache
def indices_of(degree):
    """The indices (i, j, k, l) of the points of a net, in its order."""
    return tuple((i, j, k, degree - i - j - k)
                 for i in range(degree, -1, -1)
                 for j in range(degree - i, -1, -1)
                 for k in range(degree - i - j, -1, -1))


def name_of(degree, row):
    """An index as it is written: "1 0 2 0"."""
    return " ".join(map(str, indices_of(degree)[row]))


def value_of(points, weights=(), fourth=()):
    """The osculate.BezierTetrahedron of a net. Raises NetError, which says where it is wrong.

    points: rows of three coordinates in mm; fourth: the fourth coordinate of each, or none;
    weights: of each, or none where all are 1.
    """
    points = [tuple(point) for point in points]
    degree = degree_of(len(points))
    for name, numbers in ((WEIGHT, weights), (FOURTH, fourth)):
        if numbers and len(numbers) != len(points):
            raise NetError(translate("Osculate", "{}: {} numbers for {} points.").format(
                name, len(numbers), len(points)))
    if fourth:
        points = [(*point, last) for point, last in zip(points, fourth)]
    _check_numbers(degree, points, weights)
    return osculate.BezierTetrahedron(degree, points, list(weights) or None)


def _check_numbers(degree, points, weights):
    for row, point in enumerate(points):
        for column, number in zip(COLUMNS, point):
            if not math.isfinite(number):
                raise NetError(translate("Osculate", "{} of point {} must be a finite number, not "
                                                     "{}.").format(column, name_of(degree, row),
                                                                   number), row, column)
    for row, weight in enumerate(weights):
        if not (math.isfinite(weight) and weight >= 0.0):
            raise NetError(translate("Osculate", "The weight of point {} must be 0 or more, not "
                                                 "{:g}.").format(name_of(degree, row), weight),
                           row, WEIGHT)
    if weights and not any(weights):
        raise NetError(translate("Osculate", "All weights are 0: at least one must be more."))


def lists_of(value):
    """(points, weights, fourth) of a BezierTetrahedron, as `value_of` takes them."""
    rows = value.points.tolist()
    weights = value.weights
    return ([tuple(row[:3]) for row in rows], [] if weights is None else weights.tolist(),
            [row[3] for row in rows] if value.dimension == 4 else [])
