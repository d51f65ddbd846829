"""A point that travels along curves: what there is of them on either side."""

from dataclasses import dataclass
from typing import NamedTuple, Optional

import numpy

from osculate import _core
from osculate.comb_drawing import DIMENSIONS, size_of
from osculate.polygons import de_casteljau
from osculate.travels import CurveTravel

#: Where a probe can be told to stop: the ends of chains, joins of curves, inner knots, and the
#: marks of a comb of curvature.
SPECIAL_KINDS = ("end", "join", "closing", "knot", "cusp", "inflection", "vertex")

_TWO_SIDED = ("join", "closing", "knot", "cusp")

_DENSITY = 8         # of the samples, which only serve to find special points and the mouse
_SAME_PLACE = 1e-9   # share of the length within which an arc length means a special point
_AGREEMENT = 1e-6    # relative, within which both sides have the same value


class SpecialPoint(NamedTuple):
    """A place that one wants to look at."""

    s: float          #: arc length from the start of the travel, mm
    kind: str         #: one of SPECIAL_KINDS
    place: int        #: of the curve in the order of travel; of a join that which leaves it
    parameter: float  #: in the direction of travel


@dataclass(frozen=True)
class ProbeSide:
    """What a curve is at a point, from one side, in the direction of travel."""

    curve: int           #: its number
    parameter: float     #: of the curve as it was given
    geometry: object     #: PointGeometry
    segment: Optional[object]  #: the Bézier segment there over [0, 1]; None: it is a single point
    t: float             #: where on the segment the point is

    def polygons(self):
        """The construction of de Casteljau at the point, see osculate.polygons.de_casteljau; no
        polygon where there is no segment.
        """
        return [] if self.segment is None else de_casteljau(self.segment, self.t)


@dataclass(frozen=True)
class ProbeReading:
    """What there is at an arc length."""

    s: float        #: from the start of the travel, mm
    share: float    #: of the length, 0 to 1
    point: numpy.ndarray  #: (3,): mm
    kinds: tuple    #: of the special points here
    sides: tuple    #: a ProbeSide, or two that differ: before and after the point

    @property
    def geometry(self):
        """The PointGeometry after the point, at the end of all that before it."""
        return self.sides[-1].geometry


class CurveProbe(CurveTravel):
    """Reads curves point by point; see osculate.chains.chains_of for how they are chained.

    curves: osculate.Curves in any order and direction, one at least.
    tolerances: Tolerances for where ends meet; None: the preset `osculate`.
    """

    def __init__(self, curves, tolerances=None):
        super().__init__(curves, ("curvature",), tolerances or _core.Tolerances(), _DENSITY)
        self.size = size_of([self.comb])
        self.specials = sorted(self._specials(), key=lambda special: special.s)
        self.special_points = numpy.array(  # (n, 3): where they are, mm
            [self.curves[special.place].evaluate(special.parameter)[0]
             for special in self.specials]).reshape(-1, 3)

    def at(self, s):
        """The ProbeReading at an arc length in mm; beyond the ends the end. Very near to a special
        point it is that.
        """
        s = min(max(float(s), 0.0), self.length)
        here = [special for special in self.specials
                if abs(special.s - s) <= _SAME_PLACE * self.length]
        s = here[-1].s if here else s
        sides = [self._side(*approach) for approach in self._approaches(s, here)]
        if len(sides) == 2 and self._agree(sides[0].geometry, sides[1].geometry):
            sides = sides[1:]
        return ProbeReading(s, s / self.length if self.length else 0.0, sides[-1].geometry.point,
                            tuple(dict.fromkeys(special.kind for special in here)), tuple(sides))

    def arc_length_of(self, curve, parameter):
        """The arc length from the start of the travel, of a parameter of a curve as it was given;
        beyond its range that of its end.
        """
        place = self.order.index(curve)
        first, last = self._ranges[place]
        travelled = self.own_parameter(place, min(max(parameter, first), last))
        return self.arc_length_at(place, travelled)

    def next_special(self, s, is_forward):
        """The SpecialPoint after an arc length, or before it; None if there is none."""
        apart = _SAME_PLACE * self.length
        if is_forward:
            return next((special for special in self.specials if special.s > s + apart), None)
        return next((special for special in self.specials[::-1] if special.s < s - apart), None)

    # Special points

    def _specials(self):
        place = 0
        for chain in self.chains:
            last = place + len(chain.links) - 1
            kind = "closing" if chain.is_closed else "end"
            yield self._special(kind, place, self._ranges[place][0])
            for inner in range(place + 1, last + 1):
                yield self._special("join", inner, self._ranges[inner][0])
            yield self._special(kind, last, self._ranges[last][1])
            place = last + 1
        for place, curve in enumerate(self.curves):
            first, last = self._ranges[place]
            for knot in numpy.unique(curve.knots):
                if first < knot < last:
                    yield self._special("knot", place, float(knot))
        for mark in self.comb.marks:
            if mark.kind in SPECIAL_KINDS:
                yield SpecialPoint(float(self.s[mark.sample]), mark.kind, mark.curve,
                                   float(self.comb.parameter[mark.sample]))

    def _special(self, kind, place, parameter):
        """At a parameter where there is a sample."""
        members = numpy.flatnonzero(self.places == place)
        at = members[numpy.abs(self.comb.parameter[members] - parameter).argmin()]
        return SpecialPoint(float(self.s[at]), kind, place, parameter)

    # Both sides

    def _approaches(self, s, here):
        """(place, parameter, side) from where a point is looked at."""
        two_sided = [special for special in here if special.kind in _TWO_SIDED]
        if not here:
            return [(*self.place_at(s), "right")]
        if not two_sided:
            _, _, place, parameter = here[-1]
            return [(place, parameter, self._inner_side(place, parameter))]
        kind, place, parameter = two_sided[-1][1:]
        if kind in ("knot", "cusp"):
            return [(place, parameter, "left"), (place, parameter, "right")]
        before, after = (place - 1, place) if kind == "join" else self._ends_of_chain(place)
        return [(before, self._ranges[before][1], "left"), (after, self._ranges[after][0], "right")]

    def _inner_side(self, place, parameter):
        return "left" if parameter >= self._ranges[place][1] else "right"

    def _ends_of_chain(self, place):
        """(last, first) place of the chain that a place belongs to."""
        first = 0
        for chain in self.chains:
            if place < first + len(chain.links):
                return first + len(chain.links) - 1, first
            first += len(chain.links)
        raise IndexError(place)

    def _side(self, place, parameter, side):
        curve = self.curves[place]
        segment, t = _segment_at(curve, parameter, side)
        return ProbeSide(self.order[place], self.own_parameter(place, parameter),
                         curve.geometry(parameter, side), segment, t)

    def _agree(self, before, after):
        """Whether two PointGeometries are one, but for rounding."""
        unit = 1.0 / self.size if self.size else 1.0
        values = [("point", self.size), *((axis, 1.0) for axis in ("tangent", "normal"))]
        values += [(name, unit ** dimension) for name, dimension in DIMENSIONS.items()]
        return all(_is_same(getattr(before, name), getattr(after, name), least)
                   for name, least in values)


def _is_same(first, second, least):
    """Whether two values or vectors agree, relative to them and to a least magnitude."""
    if first is None or second is None:
        return first is second
    size = max(numpy.linalg.norm(first), numpy.linalg.norm(second), least)
    return bool(numpy.linalg.norm(numpy.subtract(first, second)) <= _AGREEMENT * size)


def _segment_at(curve, parameter, side):
    """(Bézier segment over [0, 1], t) at a parameter, at a knot on a side."""
    knots = numpy.unique(numpy.clip(curve.knots, *curve.parameter_range))
    after = int(numpy.searchsorted(knots, parameter, "left" if side == "left" else "right"))
    after = min(max(after, 1), len(knots) - 1)
    first, last = float(knots[after - 1]), float(knots[after])
    segments = curve.trimmed(first, last).segments()
    return (segments[0] if segments else None), (parameter - first) / (last - first)
