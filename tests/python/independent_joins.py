"""The joins of a shape by a second, slow route: topology by comparing FreeCAD's vertices, curves by
knot insertion in 80-bit arithmetic, derivatives by arc length by substitution of series.

Nothing of osculate is used. Conics are taken from their definitions.
"""
import itertools
import math
from collections import defaultdict

import numpy as np

LONG = np.longdouble
ORDER = 4
DEFAULT_TOLERANCES = (1e-3, 0.1, 0.01, 0.02, 0.05)


class Spline:
    """A curve of homogeneous points over flat knots, from its first to its last parameter."""

    def __init__(self, points, knots, degree, first, last):
        self.points = np.array(points, dtype=LONG)
        self.knots = [LONG(knot) for knot in knots]
        self.degree, self.first, self.last = degree, LONG(first), LONG(last)

    def inner_knots(self):
        """Not those that the edge's range misses by rounding: they are its ends."""
        margin = 1e-12 * (self.last - self.first)
        return sorted({knot for knot in self.knots
                       if self.first + margin < knot < self.last - margin})

    def taylor(self, t, side, count=ORDER):
        """Taylor coefficients 0..count of the curve's points in space at t, from the side."""
        span = self._span(t, side)
        homogeneous = self._bezier_taylor(t, span, count)
        return quotient(homogeneous[:, :3], homogeneous[:, 3])

    def point(self, t):
        return self.taylor(t, "right", 0)[0]

    def _span(self, t, side):
        """The span of positive length that holds t, at a knot the one on the side."""
        spans = [i for i in range(self.degree, len(self.knots) - self.degree - 1)
                 if self.knots[i] < self.knots[i + 1]]
        inside = [i for i in spans if (self.knots[i] <= t < self.knots[i + 1] if side == "right"
                                       else self.knots[i] < t <= self.knots[i + 1])]
        if inside:
            return inside[0]
        return spans[0] if t <= self.knots[spans[0]] else spans[-1]

    def _bezier_taylor(self, t, span, count):
        """By repeated differences of the control points of derivatives, each by de Boor at t."""
        p = self.degree
        points = self.points[span - p:span + 1]
        knots = self.knots[span - p + 1:span + p + 1]
        result, factorial = [], LONG(1)
        for order in range(count + 1):
            if order > p:
                result.append(np.zeros(4, dtype=LONG))
                continue
            result.append(de_boor(points, knots, p - order, t) / factorial)
            factorial *= order + 1
            if order < p:
                points, knots = derivative(points, knots, p - order)
        return np.array(result)


def de_boor(points, knots, degree, t):
    points = points.copy()
    for level in range(1, degree + 1):
        for i in range(degree, level - 1, -1):
            low, high = knots[i - 1], knots[i + degree - level]
            share = (t - low) / (high - low)
            points[i] = (1 - share) * points[i - 1] + share * points[i]
    return points[degree]


def derivative(points, knots, degree):
    """Control points of the derivative over the same span, and their knots."""
    steps = [degree * (points[i + 1] - points[i]) / (knots[i + degree] - knots[i])
             for i in range(degree)]
    return np.array(steps), knots[1:-1]


def quotient(numerator, weight):
    result = []
    for k in range(len(weight)):
        rest = numerator[k] - sum((weight[j] * result[k - j] for j in range(1, k + 1)),
                                  np.zeros(3, dtype=LONG))
        result.append(rest / weight[0])
    return np.array(result)


def spline_of_edge(edge):
    """The edge's part of its curve, in the edge's direction."""
    curve, (first, last) = edge.Curve, edge.ParameterRange
    if hasattr(curve, "getPoles"):
        spline = spline_of_poles(curve, first, last)
    else:
        spline = conic(curve, first, last)
    return reversed_spline(spline) if edge.Orientation == "Reversed" else spline


def spline_of_poles(curve, first, last):
    weights = curve.getWeights()
    points = [(w * p.x, w * p.y, w * p.z, w) for p, w in zip(curve.getPoles(), weights)]
    if curve.TypeId == "Part::GeomBezierCurve":
        return Spline(points, [0] * len(points) + [1] * len(points), curve.Degree, first, last)
    if curve.isPeriodic():
        raise NotImplementedError("no periodic spline in the models")
    return Spline(points, curve.KnotSequence, curve.Degree, first, last)


def conic(curve, first, last):
    if curve.TypeId == "Part::GeomLine":
        ends = [(*curve.value(t), 1) for t in (first, last)]
        return Spline(ends, [first, first, last, last], 1, first, last)
    if curve.TypeId != "Part::GeomCircle":
        raise NotImplementedError(curve.TypeId)
    pieces = max(1, math.ceil((last - first) / (math.pi / 2) - 1e-9))
    breaks = [first + (last - first) * i / pieces for i in range(pieces)] + [last]
    centre = np.array(curve.Center, dtype=LONG)
    axes = [np.array(curve.value(t), dtype=LONG) - centre for t in (0, math.pi / 2)]

    def at(angle, factor=LONG(1)):
        return centre + factor * (np.cos(LONG(angle)) * axes[0] + np.sin(LONG(angle)) * axes[1])

    half = LONG(last - first) / pieces / 2
    weight = np.cos(half)
    points = [(*at(breaks[0]), 1)]
    for low, high in itertools.pairwise(breaks):
        middle = at((LONG(low) + LONG(high)) / 2, 1 / weight)
        points += [(*(weight * middle), weight), (*at(high), 1)]
    knots = [breaks[0]] + [b for b in breaks for _ in range(2)] + [breaks[-1]]
    return Spline(points, knots, 2, first, last)


def reversed_spline(spline):
    total = spline.first + spline.last
    return Spline(spline.points[::-1], [total - knot for knot in reversed(spline.knots)],
                  spline.degree, spline.first, spline.last)


def arc_derivatives(taylor):
    """r_1 .. r_4 by arc length: the series of s(t), its inverse, put into the curve."""
    speed_squared = series_product_sum(taylor)
    speed = series_root(speed_squared)
    length = [LONG(0)] + [speed[k] / (k + 1) for k in range(ORDER)]
    t_of_s = series_inverse(length)
    result = [np.zeros(3, dtype=LONG) for _ in range(ORDER + 1)]
    power = [LONG(1)] + [LONG(0)] * ORDER
    for k in range(1, ORDER + 1):
        power = series_product(power, t_of_s)
        for i in range(ORDER + 1):
            result[i] = result[i] + taylor[k] * power[i]
    return [math.factorial(k) * result[k] for k in range(1, ORDER + 1)]


def series_product(a, b):
    return [sum(a[j] * b[k - j] for j in range(k + 1)) for k in range(len(a))]


def series_product_sum(taylor):
    """|P'|^2 as a series of ORDER terms."""
    rate = [(k + 1) * taylor[k + 1] for k in range(ORDER)]
    return [sum(rate[j] @ rate[k - j] for j in range(k + 1)) for k in range(ORDER)]


def series_root(a):
    root = [np.sqrt(a[0])]
    for k in range(1, len(a)):
        root.append((a[k] - sum(root[j] * root[k - j] for j in range(1, k))) / (2 * root[0]))
    return root


def series_inverse(a):
    """b with a(b(s)) = s, a(0) = 0, by matching one coefficient after the other."""
    b = [LONG(0), 1 / a[1]] + [LONG(0)] * (ORDER - 1)
    for k in range(2, ORDER + 1):
        total, power = LONG(0), [LONG(1)] + [LONG(0)] * ORDER
        for j in range(1, k + 1):
            power = series_product(power, b)
            total += a[j] * power[k]
        b[k] = -total / a[1]
    return b


def residuals(arriving, leaving, reach):
    """Of the orders 0..4, from Taylor coefficients in the direction of travel."""
    gap = norm(arriving[0] - leaving[0])
    before, after = arc_derivatives(arriving), arc_derivatives(leaving)
    half = norm(before[0] - after[0]) / 2
    result = [gap, math.degrees(2 * math.asin(min(1.0, half)))]
    for k in range(2, ORDER + 1):
        a, b = before[k - 1], after[k - 1]
        result.append(norm(a - b) / max(norm(a), norm(b), reach ** (1 - k)))
    return [float(value) for value in result]


def norm(vector):
    return np.sqrt(vector @ vector)


def outward(spline, end):
    """Taylor coefficients at an end, outward from it."""
    if end == "start":
        return spline.taylor(spline.first, "right")
    coefficients = spline.taylor(spline.last, "left")
    return np.array([(-1) ** k * c for k, c in enumerate(coefficients)])


def backward(coefficients):
    return np.array([(-1) ** k * c for k, c in enumerate(coefficients)])


def reach_at_end(spline, end):
    here = spline.point(spline.first) if end == "start" else spline.taylor(spline.last, "left")[0]
    there = spline.taylor(spline.last, "left")[0] if end == "start" else spline.point(spline.first)
    middle = spline.point((spline.first + spline.last) / 2)
    return max(norm(there - here), norm(middle - here))


def reach_at_knot(spline, point):
    others = (spline.point(spline.first), spline.taylor(spline.last, "left")[0],
              spline.point((spline.first + spline.last) / 2))
    return max(norm(other - point) for other in others)


class Model:
    """The edges of a shape by number, their splines and their places."""

    def __init__(self, shape):
        self.edges = dict(enumerate(shape.Edges, start=1))
        self.splines = {number: spline_of_edge(edge) for number, edge in self.edges.items()
                        if not edge.Degenerated}

    def vertex_joins(self):
        """((a, b), (end of a, end of b)) of every two edge ends that are one vertex."""
        at_vertex = defaultdict(list)
        for number in self.splines:
            edge = self.edges[number]
            for end, vertex in (("start", edge.firstVertex(True)), ("end", edge.lastVertex(True))):
                groups = at_vertex[vertex.hashCode()]
                group = next((g for g in groups if g[0].isSame(vertex)), None)
                if group is None:
                    group = (vertex, [])
                    groups.append(group)
                group[1].append((number, end))
        for groups in at_vertex.values():
            for _, ends in groups:
                for (a, first), (b, second) in itertools.combinations(ends, 2):
                    if a != b:
                        yield ((a, b), (first, second)) if a < b else ((b, a), (second, first))

    def vertex_residuals(self, edges, ends):
        sides = [(self.splines[number], end) for number, end in zip(edges, ends)]
        reach = min(reach_at_end(*side) for side in sides)
        arriving, leaving = (outward(*side) for side in sides)
        return residuals(backward(arriving), leaving, reach)

    def knot_residuals(self, number, knot):
        spline = self.splines[number]
        left, right = spline.taylor(knot, "left"), spline.taylor(knot, "right")
        return residuals(left, right, reach_at_knot(spline, right[0]))


def order_of(found, tolerances=DEFAULT_TOLERANCES):
    """The highest order with all up to it within their tolerances."""
    passed = itertools.takewhile(lambda pair: pair[0] <= pair[1], zip(found, tolerances))
    return sum(1 for _ in passed) - 1


def is_clear(found, tolerances=DEFAULT_TOLERANCES, margin=1e-6):
    """Whether no residual is so near its tolerance that rounding may decide."""
    return all(abs(value - limit) > margin * limit for value, limit in zip(found, tolerances))
