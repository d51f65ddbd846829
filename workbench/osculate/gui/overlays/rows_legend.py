"""The picture of a legend: a title, and rows of lines or symbols with words."""

import math
from dataclasses import dataclass

from pivy import coin

from osculate.gui.overlays import sprites
from osculate.gui.overlays.pictures import (
    TEXT_COLOR, canvas, image_node, label_fonts, painter_on)
from osculate.gui.qt import QtCore, QtGui

#: The key of a row with a line is (LINE, colour); others are what sprites.symbol takes, or None.
LINE = "line"

_MARGIN, _PADDING, _KEY_WIDTH, _ROW_GAP = 9.5, 10.0, 26.0, 3.0
_RIM = "#7c8794"


@dataclass(frozen=True)
class RowsLegend:
    """What a legend shows; rows are (key, text) pairs."""

    title: str
    rows: tuple


def legend_picture(legend, text_points, left):
    """(node, right): the picture, hanging from its upper left corner, `left` points to the right of
    it; where it ends.
    """
    plain, bold = label_fonts(text_points)
    metrics, bold_metrics = QtGui.QFontMetricsF(plain), QtGui.QFontMetricsF(bold)
    step = metrics.height() + _ROW_GAP
    width = max([bold_metrics.horizontalAdvance(legend.title)]
                + [(_KEY_WIDTH if key else 0.0) + metrics.horizontalAdvance(text)
                   for key, text in legend.rows])
    box = QtCore.QRectF(left + _MARGIN, _MARGIN, math.ceil(width) + 2.0 * _PADDING,
                        math.ceil((1 + len(legend.rows)) * step) + 2.0 * _PADDING)
    picture = canvas(box.right() + 1.0, box.bottom() + 1.0)
    painter = painter_on(picture)
    painter.setPen(QtGui.QPen(QtGui.QColor(_RIM), 1.0))
    painter.setBrush(QtGui.QColor(255, 255, 255, 235))
    painter.drawRoundedRect(box, 5.0, 5.0)
    corner = box.topLeft() + QtCore.QPointF(_PADDING, _PADDING)
    _write(painter, corner, legend.title, bold)
    for number, (key, text) in enumerate(legend.rows, 1):
        place = corner + QtCore.QPointF(0.0, number * step)
        if key:
            _draw_key(painter, place + QtCore.QPointF(9.0, 0.5 * metrics.height()), key)
            place += QtCore.QPointF(_KEY_WIDTH, 0.0)
        _write(painter, place, text, plain)
    painter.end()
    return image_node(picture, coin.SoImage.LEFT, coin.SoImage.TOP), box.right() + 0.5


def _draw_key(painter, centre, key):
    if key[0] == LINE:
        painter.setPen(QtGui.QPen(QtGui.QColor(key[1]), 3.0))
        half = QtCore.QPointF(9.0, 0.0)
        painter.drawLine(centre - half, centre + half)
    else:
        sprites.draw_symbol(painter, centre, *key)


def _write(painter, corner, text, font):
    """A line of text from its upper left corner."""
    painter.setFont(font)
    painter.setPen(QtGui.QColor(TEXT_COLOR))
    painter.drawText(corner + QtCore.QPointF(0.0, QtGui.QFontMetricsF(font).ascent()), text)
