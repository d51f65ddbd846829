"""Curve plots: curvature, torsion and their rates over the arc length of chains of curves."""

from typing import NamedTuple, Optional

import numpy

from osculate import _core, analysis, shapes
from osculate.combs import names_of
from osculate.travels import CurveTravel

#: What a plot shows if nothing else is asked for.
PLOT_QUANTITIES = ("curvature", "torsion", "curvature_rate", "curvature_rate2")


class PlotJoin(NamedTuple):
    """A place of a plot where curves, or segments of one, meet."""

    s: float                  #: arc length from the start of the plot, mm
    kind: str                 #: "join" of two curves, "knot" inside one, "closing", or "gap"
    order: int                #: of continuity, -1 for a gap
    label: str                #: "G2", "G2?" where the next order is undecided, or "gap"
    gap_mm: float             #: how far apart both sides are
    curves: tuple             #: the numbers of both curves
    report: Optional[object]  #: the JoinReport; None for a gap between chains


class PlotPoint(NamedTuple):
    """A point of the curves of a plot."""

    s: float          #: arc length from the start of the plot, mm
    curve: int        #: number of the curve
    parameter: float  #: of that curve as it was given
    geometry: object  #: PointGeometry there, in the direction of the plot


class CurvePlot(CurveTravel):
    """Curves put one behind the other, sampled by arc length; see curve_plot.

    Arrays have a row for each sample. Numbers of curves are those of the list that was given.
    """

    def __init__(self, curves, quantities, order, tolerances, density, tolerance):
        super().__init__(curves, quantities, tolerances, density, tolerance)
        self.joins = tuple(_Joins(self, order, tolerances).find())

    def series(self, quantity):
        """(s, values) as arrays to be drawn as one line: NaN wherever it must break, which is where
        a value does not exist, and between the two sides of every knot.
        """
        breaks = self.comb.runs[1:, 0]
        return (numpy.insert(self.s, breaks, self.s[breaks]),
                numpy.insert(getattr(self.comb, quantity), breaks, numpy.nan))

    def at(self, s):
        """The PlotPoint at an arc length from the start of the plot; beyond the ends the end. At a
        join the side that leaves it.
        """
        s = min(max(float(s), 0.0), self.length)
        place, parameter = self.place_at(s)
        return PlotPoint(s, self.order[place], self.own_parameter(place, parameter),
                         self.curves[place].geometry(parameter))

    def draw(self, figure, **options):
        """Draws on a matplotlib.figure.Figure, which is cleared; see PlotDrawing.show. Returns the
        PlotDrawing. Raises ImportError where there is no matplotlib.
        """
        from osculate.plot_drawing import PlotDrawing
        drawing = PlotDrawing(figure)
        drawing.show(self, **options)
        return drawing

    def save(self, path, *, labels=None, **options):
        """Writes .svg, .pdf, .png or .csv, as the ending says; see osculate.plot_files.save_plot.
        """
        from osculate.plot_files import save_plot
        save_plot(self, path, labels=labels, **options)


def curve_plot(curves, *, quantities=PLOT_QUANTITIES, order=4, tolerances=None, density=24,
               tolerance=0.001):
    """Curvature, torsion and their rates over arc length along curves, as a CurvePlot.

    curves: a Part.Edge or Curve, a sequence of them in any order and direction, or a Part.Shape,
        whose edges count. Curves whose ends meet are put one behind the other, as many chains as
        there are; see osculate.chains.chains_of.
    quantities: some of COMB_QUANTITIES, which are drawn.
    order: up to which joins and inner knots are analysed, 0 to 8.
    tolerances: Tolerances, the name of a preset, or None for the preset `osculate`.
    density, tolerance: of the samples, as for comb.

    Values are one-sided at every knot, as those of comb. Raises TypeError for what is no curve,
    ValueError that names the argument and the rule, also where there is no curve at all.
    """
    found = _curves_from(curves)
    if not found:
        raise ValueError("curves: at least one is needed")
    return CurvePlot(found, names_of(quantities), order, _tolerances(tolerances), density,
                     tolerance)


def _curves_from(curves):
    if isinstance(curves, _core.Curve) or shapes.is_edge(curves):
        return [shapes.curve_from(curves, "curves")]
    if shapes.is_shape(curves):
        curves = [edge for edge in curves.Edges if not edge.Degenerated]
    return shapes.curves_from(curves, "curves")


def _tolerances(value):
    if value is None or isinstance(value, _core.Tolerances):
        return value or _core.Tolerances()
    if not isinstance(value, str):
        raise TypeError("tolerances: must be None, a Tolerances or the name of a preset, "
                        f"got {type(value).__name__}")
    return _core.Tolerances.preset(value)


class _Joins:
    """Finds the PlotJoins of a CurvePlot."""

    def __init__(self, plot, order, tolerances):
        self._plot = plot
        self._order = order
        self._tolerances = tolerances

    def find(self):
        """All of them, in the order of s."""
        joins, place = [], 0
        for chain in self._plot.chains:
            if place:
                joins.append(self._between_chains(place))
            for number in range(len(chain.links)):
                if number:
                    joins.append(self._of(place - 1, place, "join"))
                joins += self._within(place)
                place += 1
            if chain.is_closed and len(chain.links) > 1:
                joins.append(self._of(place - 1, place - len(chain.links), "closing"))
        return joins

    def _of(self, arriving, leaving, kind):
        curves = self._plot.curves
        report = analysis.analyze(curves[arriving], curves[leaving], order=self._order,
                                  ends=("end", "start"), tolerances=self._tolerances)
        return self._described(report, kind, self._plot.starts[arriving + 1], arriving, leaving)

    def _within(self, place):
        """Inner knots and the closing join of one curve."""
        members = self._plot.places == place
        parameters, s = self._plot.comb.parameter[members], self._plot.s[members]
        for report in analysis.analyze_edge(self._plot.curves[place], order=self._order,
                                            tolerances=self._tolerances):
            if report.parameter is None:
                yield self._described(report, "closing", self._plot.starts[place + 1], place, place)
            else:
                at = s[numpy.searchsorted(parameters, report.parameter)]
                yield self._described(report, "knot", at, place, place)

    def _described(self, report, kind, s, arriving, leaving):
        order = self._plot.order
        undecided = report.verdicts[report.order + 1:report.order + 2] in (("undecided",),
                                                                           ["undecided"])
        name = "gap" if report.order < 0 else f"G{report.order}"
        return PlotJoin(float(s), kind, report.order, name + "?" * undecided,
                        float(report.residuals[0]), (order[arriving], order[leaving]), report)

    def _between_chains(self, place):
        curves, order = self._plot.curves, self._plot.order
        before, after = curves[place - 1], curves[place]
        gap = (after.evaluate(after.parameter_range[0])[0]
               - before.evaluate(before.parameter_range[1])[0])
        return PlotJoin(float(self._plot.starts[place]), "gap", -1, "gap",
                        float(numpy.linalg.norm(gap)), (order[place - 1], order[place]), None)
