"""Makes the small models of this folder, for the tests of the program: python3 make_models.py, with
FreeCAD's modules on the path.

wire: a line, an arc that leaves it with G1, a line that leaves the arc with G1, a line at a corner.
smooth: one cubic B-spline with a knot of multiplicity 1, cut into two edges; a part of a circle.
point: a vertex, no edge.
infinite: the wire and a line without ends.
"""
from pathlib import Path

import FreeCAD
import Part

V = FreeCAD.Vector


def wire():
    arc = Part.Arc(V(10, 0, 0), V(10 + 5 * 0.5 ** 0.5, 5 - 5 * 0.5 ** 0.5, 0), V(15, 5, 0))
    return Part.Wire([Part.makeLine(V(0, 0, 0), V(10, 0, 0)), arc.toShape(),
                      Part.makeLine(V(15, 5, 0), V(15, 20, 0)),
                      Part.makeLine(V(15, 20, 0), V(30, 20, 0))])


def smooth():
    spline = Part.BSplineCurve()
    poles = [V(0, 0, 0), V(5, 8, 1), V(12, 9, 3), V(20, 2, 2), V(30, 4, 0)]
    spline.buildFromPolesMultsKnots(poles, [4, 1, 4], [0, 1, 2], False, 3)
    halves = [spline.copy(), spline.copy()]
    halves[0].segment(0, 1.4)
    halves[1].segment(1.4, 2)
    circle = Part.makeCircle(7, V(0, 50, 0), V(0, 0, 1), 0, 250)
    return Part.makeCompound([Part.Wire([half.toShape() for half in halves]), circle])


MODELS = {"wire": wire(), "smooth": smooth(), "point": Part.Vertex(1, 2, 3),
          "infinite": Part.makeCompound([wire(), Part.Line(V(0, 0, 9), V(1, 0, 9)).toShape()])}


def main():
    folder = Path(__file__).parent
    for name, shape in MODELS.items():
        shape.exportBrep(str(folder / f"{name}.brep"))
        if name in ("wire", "smooth"):
            shape.exportStep(str(folder / f"{name}.step"))
            shape.exportIges(str(folder / f"{name}.igs"))


main()
