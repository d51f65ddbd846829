"""A comb in the 3D view: teeth, envelope, jumps, marks. Nodes stay while the comb changes."""

import functools
from dataclasses import dataclass

import numpy
from pivy import coin

from osculate.comb_drawing import LIMIT, CombDrawing
from osculate.gui import colors
from osculate.gui.overlays import nodes, sprites

_TOOTH_WIDTH, _ENVELOPE_WIDTH, _JUMP_WIDTH = 1.0, 2.0, 3.0
_TOOTH_TRANSPARENCY = 0.25
_MOST_MARKS = 300  # more would be a carpet, not marks

#: How a mark is drawn: symbol, colour, filled or hollow.
MARK_LOOKS = {
    "inflection": ("diamond", "#d55e00", True),
    "vertex": ("circle", "#16202b", False),
    "cusp": ("cross", "#d6293e", True),
    "peak": ("triangle", "#16202b", True),
}
JUMP_COLOR = colors.GAP


@dataclass(frozen=True)
class CombLook:
    """What of a comb is drawn."""

    teeth: bool = True
    envelope: bool = True
    marks: bool = True


class CombNodes:
    """What is drawn of one Comb; `node` goes into the scene."""

    cut = 0    #: teeth that are not drawn to their full length
    jumps = 0  #: places where the quantity jumps

    def __init__(self):
        self.node = nodes.separator()
        self._color = None
        self._shown = None  # (comb, quantity): what the drawing is of
        self._drawing = None

    def show(self, comb, quantity, scale, size, color, look):
        """Draws a Comb at a scale in mm per unit (None: no tooth has a length), none longer than
        the LIMIT of `size`.
        """
        self._take_color(color)
        if self._shown is None or self._shown[0] is not comb or self._shown[1] != quantity:
            self._shown = comb, quantity
            self._drawing = CombDrawing(comb, quantity)
        drawing = self._drawing
        tips, is_cut = drawing.tips(scale or 0.0, LIMIT * size)
        if scale is None:
            tips = comb.point
        self._show_lines(drawing, comb, tips, look)
        self._marks.show(_marked_points(comb, quantity, tips) if look.marks else {})
        self.cut = int(is_cut[drawing.teeth].sum())

    def clear(self):
        """Draws nothing."""
        self._color = self._shown = self._drawing = None
        self.cut = self.jumps = 0
        self.node.removeAllChildren()

    def _take_color(self, color):
        if color == self._color:
            return
        self._color = color
        self._teeth = nodes.Polylines(color, _TOOTH_WIDTH, _TOOTH_TRANSPARENCY)
        self._envelope = nodes.Polylines(color, _ENVELOPE_WIDTH, has_rim=True)
        self._jumps = nodes.Polylines(JUMP_COLOR, _JUMP_WIDTH)
        self._marks = _Marks()
        self.node.removeAllChildren()
        for part in (self._teeth.node, self._envelope.node, self._jumps.node,
                     self._marks.node):
            self.node.addChild(part)

    def _show_lines(self, drawing, comb, tips, look):
        teeth = drawing.teeth if look.teeth else drawing.teeth[:0]
        self._teeth.show(_pairs(comb.point[teeth], tips[teeth]), (2,) * len(teeth))
        members, counts = drawing.lines()
        if not look.envelope:
            members, counts = members[:0], counts[:0]
        self._envelope.show(tips[members], counts)
        jumps = drawing.jumps()
        self.jumps = len(jumps)
        if not look.envelope:
            jumps = jumps[:0]
        self._jumps.show(tips[jumps].reshape(-1, 3), (2,) * len(jumps))


def _pairs(first, second):
    """Alternating rows of two (n, 3) arrays."""
    return numpy.stack((first, second), axis=1).reshape(-1, 3)


class _Marks:
    """Symbols at points; `node` goes into the scene. Moves are kept, for they cost most."""

    def __init__(self):
        self._parts = {kind: nodes.separator() for kind in MARK_LOOKS}
        self._moves = []  # (node, its field)
        self.node = nodes.separator(*self._parts.values())

    def show(self, points):
        """points: kind -> (n, 3) array."""
        used = 0
        for kind, part in self._parts.items():
            part.removeAllChildren()
            if kind not in points:
                continue
            symbol = _symbol(*MARK_LOOKS[kind])
            for step in numpy.diff(points[kind], axis=0, prepend=0.0).tolist():
                node, field = self._move(used)
                used += 1
                field.setValue(*step)
                part.addChild(node)
                part.addChild(symbol)

    def _move(self, number):
        if number == len(self._moves):
            node = coin.SoTranslation()
            self._moves.append((node, node.translation))
        return self._moves[number]


def _marked_points(comb, quantity, tips):
    """Points on the curve for each kind of mark, those of peaks at the ends of their teeth."""
    samples = {}
    for mark in shown_marks(comb, quantity):
        samples.setdefault(mark.kind, []).append(mark.sample)
    points = {kind: (tips if kind == "peak" else comb.point)[members]
              for kind, members in samples.items()}
    return {kind: rows[numpy.isfinite(rows).all(axis=1)] for kind, rows in points.items()}


def shown_marks(comb, quantity):
    """The marks of a comb that belong to a quantity; of too many those of the largest values."""
    marks = [mark for mark in comb.marks if mark.kind != "peak" or mark.quantity == quantity]
    if len(marks) <= _MOST_MARKS:
        return marks
    values = numpy.nan_to_num(numpy.abs(getattr(comb, quantity)[[mark.sample for mark in marks]]))
    return [marks[number] for number in numpy.argsort(-values, kind="stable")[:_MOST_MARKS]]


@functools.lru_cache(maxsize=None)
def _symbol(*look):
    node = sprites.symbol(*look)
    node.ref()  # Python's reference alone would not keep it
    return node
