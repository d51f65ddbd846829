"""How long a whole report takes from Python on two Part edges, and where the time goes."""

import statistics
import timeit

import FreeCAD
import Part

import osculate
from osculate import shapes


def spline_edge(points):
    curve = Part.BSplineCurve()
    curve.interpolate([FreeCAD.Vector(*point) for point in points])
    return curve.toShape()


def microseconds(call, number=2000, repeat=9):
    """The median time of one call."""
    return 1e6 * statistics.median(timeit.repeat(call, number=number, repeat=repeat)) / number


def main():
    first = spline_edge([(0, 0, 0), (10, 4, 1), (20, -3, 2), (30, 5, 0), (40, 0, 3)])
    second = spline_edge([(40, 0, 3), (50, -4, 1), (60, 3, 2), (70, -5, 0), (80, 0, 3)])
    a, b = shapes.curve_from_edge(first), shapes.curve_from_edge(second)
    report = osculate.analyze(first, second)
    rows = [
        ("analyze(edge, edge)", lambda: osculate.analyze(first, second)),
        ("  edge to curve, twice",
         lambda: (shapes.curve_from_edge(first), shapes.curve_from_edge(second))),
        ("  analyze(curve, curve)", lambda: osculate.analyze(a, b)),
        ("report.order", lambda: report.order),
        ("report.to_dict()", report.to_dict),
        ("str(report)", lambda: str(report)),
    ]
    print("\nFrom Python on two Part edges (cubic B-splines), median:")
    for name, call in rows:
        print(f"  {name:28s}{microseconds(call):9.2f} us")


main()
