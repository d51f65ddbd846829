"""How long a comb of 100 edges takes from the edges to the nodes that Coin draws, as while a curve
is dragged; beside it OpenCASCADE's curvature at as many points, by Part.
"""

import os
import statistics
import time

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

import FreeCAD  # noqa: E402
import FreeCADGui  # noqa: E402
import Part  # noqa: E402
from PySide import QtGui  # noqa: E402

import osculate  # noqa: E402
from osculate import comb_drawing  # noqa: E402

_EDGES, _SAMPLES = 100, 100
_QUANTITY = "curvature"


def edges(bend):
    """Cubic Bézier edges side by side."""
    result = []
    for number in range(_EDGES):
        curve = Part.BezierCurve()
        curve.setPoles([FreeCAD.Vector(number + x, y, z) for x, y, z in (
            (0, 0, 0), (3, 5, 0.1 * number), (6, -5, 1), (9, 2 + bend + 0.05 * number, 0))])
        result.append(curve.toShape())
    return result


def milliseconds(call, repeat=25):
    """The median CPU time of one call; each gets the number of its turn."""
    times = []
    for turn in range(repeat):
        start = time.process_time()
        call(turn)
        times.append(time.process_time() - start)
    return 1e3 * statistics.median(times)


class Drag:
    """The steps from edges to the screen."""

    def __init__(self):
        from osculate.gui.overlays.comb_nodes import CombLook, CombNodes
        self.edges = [edges(0.01 * turn) for turn in range(25)]
        self.nodes, self.look = CombNodes(), CombLook()

    def curves(self, turn):
        return [osculate.Curve.from_edge(edge) for edge in self.edges[turn]]

    def comb(self, curves):
        return osculate.comb(curves, density=_SAMPLES - 1, tolerance=0.0)

    def show(self, comb):
        scale = comb_drawing.automatic_scale([comb], _QUANTITY)
        self.nodes.show(comb, _QUANTITY, scale, comb_drawing.size_of([comb]), "#0072b2", self.look)

    def whole(self, turn):
        self.show(self.comb(self.curves(turn)))

    def peer(self, turn):
        for edge in self.edges[turn]:
            first, last = edge.ParameterRange
            for sample in range(_SAMPLES):
                edge.curvatureAt(first + (last - first) * sample / (_SAMPLES - 1))


def main():
    app = QtGui.QApplication.instance() or QtGui.QApplication([])  # pictures need one
    FreeCADGui.setupWithoutGUI()  # registers FreeCAD's own nodes
    drag = Drag()
    curves = [drag.curves(turn) for turn in range(25)]
    combs = [drag.comb(each) for each in curves]
    whole = milliseconds(drag.whole)
    rows = [
        ("edges to the nodes of Coin", whole),
        ("  edges to curves", milliseconds(drag.curves)),
        ("  all quantities and marks", milliseconds(lambda turn: drag.comb(curves[turn]))),
        ("  scale, teeth, envelope, marks", milliseconds(lambda turn: drag.show(combs[turn]))),
    ]
    print(f"\nComb of {_EDGES} edges x {_SAMPLES} samples, median CPU time:")
    for name, took in rows:
        print(f"  {name:34s}{took:8.2f} ms")
    peer = milliseconds(drag.peer)
    print(f"  curvature alone, by Part          {peer:8.2f} ms: {peer / whole:.1f} times the whole")
    del app


main()
