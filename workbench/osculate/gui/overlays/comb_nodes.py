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
        self._points = coin.SoCoordinate3()  # those of the curve, then the tips of the teeth
        self._teeth = nodes.IndexedLines(color, _TOOTH_WIDTH, _TOOTH_TRANSPARENCY)
        self._envelope = nodes.IndexedLines(color, _ENVELOPE_WIDTH, has_rim=True)
        self._jumps = nodes.IndexedLines(JUMP_COLOR, _JUMP_WIDTH)
        self._marks = Marks(MARK_LOOKS)
        self.node.removeAllChildren()
        for part in (self._points, self._teeth.node, self._envelope.node, self._jumps.node,
                     self._marks.node):
            self.node.addChild(part)

    def _show_lines(self, drawing, comb, tips, look):
        nodes.set_points(self._points, numpy.concatenate(
            (comb.point, numpy.where(numpy.isfinite(tips), tips, comb.point))))
        first_tip = len(comb.point)
        teeth = drawing.teeth if look.teeth else drawing.teeth[:0]
        self._teeth.show(_ended(numpy.column_stack((teeth, first_tip + teeth))))
        members, counts = drawing.lines()
        breaks = numpy.insert(first_tip + members, numpy.cumsum(counts), -1)
        self._envelope.show(breaks if look.envelope else breaks[:0])
        jumps = drawing.jumps()
        self.jumps = len(jumps)
        self._jumps.show(_ended(first_tip + jumps if look.envelope else jumps[:0]))


def _ended(lines):
    """(n, m) numbers of points, m to a line, as Coin has them: -1 after each line."""
    return numpy.insert(lines, lines.shape[1], -1, axis=1).ravel()


class Marks:
    """Symbols at points; `node` goes into the scene. Nodes are kept, for to make them costs most.

    looks: kind of a mark -> what sprites.symbol takes
    """

    def __init__(self, looks):
        self._looks = looks
        self._parts = {kind: nodes.separator() for kind in looks}
        self._moves = {kind: [] for kind in looks}  # the fields of the translations
        self.node = nodes.separator(*self._parts.values())

    def show(self, points):
        """points: kind -> (n, 3) array."""
        for kind, moves in self._moves.items():
            steps = numpy.diff(points.get(kind, numpy.empty((0, 3))), axis=0, prepend=0.0)
            self._set_count(kind, len(steps))
            for field, step in zip(moves, steps.tolist()):
                field.setValue(*step)

    def _set_count(self, kind, count):
        part, moves = self._parts[kind], self._moves[kind]
        for number in reversed(range(2 * count, part.getNumChildren())):
            part.removeChild(number)
        del moves[count:]
        while len(moves) < count:
            node = coin.SoTranslation()
            moves.append(node.translation)
            part.addChild(node)
            part.addChild(_symbol(*self._looks[kind]))


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
