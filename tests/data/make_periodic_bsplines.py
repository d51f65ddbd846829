"""Writes periodic_bsplines.json: points of periodic B-splines as OpenCASCADE evaluates them.

Run with FreeCAD's interpreter:  freecadcmd make_periodic_bsplines.py
"""

import json
import pathlib
import random

import FreeCAD
import Part

CASES = [
    (1, [0, 1, 2, 4], [1, 1, 1, 1], False),
    (2, [0, 1, 2.5, 3], [1, 1, 1, 1], False),
    (2, [0, 1, 2.5, 3], [2, 1, 1, 2], True),
    (3, [0, 1, 2, 2.5, 4, 7], [1, 1, 1, 1, 1, 1], True),
    (3, [0, 1, 2, 3, 5], [2, 1, 3, 1, 2], False),
    (3, [-2, -1, 1, 4], [3, 1, 2, 3], True),
    (5, [0, 0.25, 0.5, 1], [1, 2, 5, 1], False),
    (5, [0, 0.25, 0.5, 1], [4, 1, 1, 4], False),
    (3, [0, 1, 3], [1, 1, 1], False),
    (4, [0, 1, 3, 4], [1, 1, 1, 1], True),
]


def case(number, degree, knots, multiplicities, rational):
    numbers = random.Random(number)
    count = sum(multiplicities[:-1])
    poles = [[round(numbers.uniform(-8, 8), 3) for _ in range(3)] for _ in range(count)]
    weights = [round(numbers.uniform(1, 3), 3) if rational else 1.0 for _ in range(count)]
    curve = Part.BSplineCurve()
    curve.buildFromPolesMultsKnots(
        [FreeCAD.Vector(*p) for p in poles], multiplicities, knots, True, degree, weights)
    first, last = knots[0], knots[-1]
    parameters = [first + (last - first) * i / 16 for i in range(16)]
    points = [[t, list(curve.value(t))] for t in parameters]
    return {"degree": degree, "knots": knots, "multiplicities": multiplicities, "poles": poles,
            "weights": weights if rational else None, "points": points}


def main():
    version = Part.OCC_VERSION
    data = {"source": f"Geom_BSplineCurve::D0 of OpenCASCADE {version}, "
                      "written by make_periodic_bsplines.py",
            "cases": [case(i, *arguments) for i, arguments in enumerate(CASES)]}
    lines = [json.dumps(entry) for entry in data["cases"]]
    text = ('{"source": ' + json.dumps(data["source"]) + ',\n "cases": [\n  '
            + ",\n  ".join(lines) + "\n]}\n")
    pathlib.Path(__file__).with_name("periodic_bsplines.json").write_text(text)


main()
