"""The combs of a curve that is being made and of its neighbours, in one scale."""

import osculate
from osculate.comb_drawing import automatic_scale, size_of
from osculate.features.feature import FAILURES
from osculate.gui import colors
from osculate.gui.overlays.comb_nodes import CombLook, CombNodes

_QUANTITY = "curvature"
_LOOK = CombLook(marks=False)


class Porcupine:
    """Draws the curvature of several curves; `node` goes into the scene."""

    def __init__(self):
        self._nodes = CombNodes()

    @property
    def node(self):
        return self._nodes.node

    def show(self, links, curve):
        """Draws a Curve and the edges that EdgeLinks lead to; one that has no comb is left out."""
        comb = osculate.comb([*_curves(links), curve], quantities=[_QUANTITY])
        self._nodes.show(comb, _QUANTITY, automatic_scale([comb], _QUANTITY), size_of([comb]),
                         colors.QUANTITIES[_QUANTITY], _LOOK)


def _curves(links):
    for link in dict.fromkeys(links):
        try:
            yield osculate.Curve.from_edge(link.resolve())
        except FAILURES:
            continue
