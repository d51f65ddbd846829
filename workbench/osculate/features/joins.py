"""The joins of edges in a document: where they are, and their analysis."""

from dataclasses import dataclass, field
from typing import Optional, Tuple

import FreeCAD

import osculate
from osculate.chains import NEARNESS
from osculate.features.edge_link import EdgeLink, LinkError, resolve_all
from osculate.near_points import near_pairs

translate = FreeCAD.Qt.translate

END_NAMES = ("start", "end")

#: Ends as the document stores them; None lets the analysis take the nearest.
ENDS = {
    "nearest": None,
    "end-start": ("end", "start"),
    "end-end": ("end", "end"),
    "start-start": ("start", "start"),
    "start-end": ("start", "end"),
}


@dataclass(frozen=True)
class JoinPlace:
    """Where a join is: two edges at given ends (None: the nearest), or inner knot `knot` of one.

    `knot` counts from 1; 0 says that the join lies at ends. One closed edge as both, without a
    knot, is its closing join.
    """

    first: EdgeLink
    second: EdgeLink
    ends: Optional[Tuple[str, str]] = None
    knot: int = 0

    def analyze(self, order, tolerances):
        """The JoinReport. Raises LinkError, or what osculate.analyze raises."""
        first = self.first.resolve()
        if self.knot:
            return self._analyze_knot(first, order, tolerances)
        second = first if self.second == self.first else self.second.resolve()
        return osculate.analyze(first, second, order=order, ends=self.ends, tolerances=tolerances)

    def _analyze_knot(self, edge, order, tolerances):
        inner = [report for report in
                 osculate.analyze_edge(edge, order=order, tolerances=tolerances)
                 if report.parameter is not None]
        if self.knot > len(inner):
            raise LinkError(translate("Osculate", "{} has no inner knot {} (it has {}).")
                            .format(self.first.label(), self.knot, len(inner)))
        return inner[self.knot - 1]

    def label(self):
        """What the user calls the join, e.g. "Sketch.Edge1 – Edge2"."""
        if self.knot:
            return translate("Osculate", "{}, knot {}").format(self.first.label(), self.knot)
        if self.first == self.second:
            return translate("Osculate", "{}, closing").format(self.first.label())
        first, second = self.first.label(), self.second.label()
        owner, _, edge = second.rpartition(".")
        return f"{first} – {edge if first.startswith(owner + '.') else second}"


def analyze_links(links, order, tolerances):
    """The joins of some edges as (JoinPlace, JoinReport): of two edges their join, of one its own
    joins, of more all joins between and within them.

    Raises LinkError, or what osculate.analyze raises.
    """
    if len(links) == 2:
        place = JoinPlace(*links)
        return [(place, place.analyze(order, tolerances))]
    edges = resolve_all(links)
    curves = {link: osculate.Curve.from_edge(edge) for link, edge in edges.items()}
    joins = []
    for link, curve in curves.items():
        joins += _inner_joins(link, curve, order, tolerances)
    for place in touching_ends(edges, tolerances.gap_mm):
        report = osculate.analyze(curves[place.first], curves[place.second], order=order,
                                  ends=place.ends, tolerances=tolerances)
        joins.append((place, report))
    return joins


def _inner_joins(link, curve, order, tolerances):
    reports = osculate.analyze_edge(curve, order=order, tolerances=tolerances)
    return [(JoinPlace(link, link, knot=0 if report.parameter is None else number), report)
            for number, report in enumerate(reports, start=1)]


def touching_ends(edges, gap_mm):
    """A JoinPlace for each pair of ends of different edges that meet or seem meant to.

    `edges` maps EdgeLink to Part.Edge. Ends within `gap_mm` meet; an end that meets none is joined
    with those within NEARNESS times as much.
    """
    pairs = _near_pairs([_End(link, name, point) for link, edge in edges.items()
                         for name, point in _end_points(edge)], NEARNESS * gap_mm)
    met = {end for *ends, distance in pairs if distance <= gap_mm for end in ends}
    return [_travel(first, second) for first, second, distance in pairs
            if distance <= gap_mm or first not in met or second not in met]


@dataclass(frozen=True)
class _End:
    """One end of an edge."""

    link: EdgeLink
    name: str  #: "start" or "end", in the direction of the edge
    point: FreeCAD.Vector = field(compare=False)


def _near_pairs(ends, reach):
    """(end, end, distance) of ends of different edges within `reach` mm."""
    found = near_pairs([tuple(end.point) for end in ends], [end.link for end in ends], reach)
    return [(ends[first], ends[second], distance) for first, second, distance in found]


def _end_points(edge):
    """(name, point) of both ends, named in the direction of the edge."""
    points = [edge.valueAt(parameter) for parameter in edge.ParameterRange]
    if edge.Orientation == "Reversed":
        points.reverse()
    return zip(("start", "end"), points)


def _travel(first, second):
    """The join of two ends, travelled from an edge's end to the other's start where possible."""
    if (first.name, second.name) == ("start", "end"):
        first, second = second, first
    return JoinPlace(first.link, second.link, (first.name, second.name))
