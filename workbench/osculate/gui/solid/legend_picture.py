"""The picture of a legend: a bar with the colours of the Jacobian, numbers, a title."""

import math
from dataclasses import dataclass

import numpy
from pivy import coin

from osculate.gui import numbers
from osculate.gui.overlays.pictures import (
    TEXT_COLOR, canvas, image_node, label_fonts, painter_on)
from osculate.gui.qt import QtCore, QtGui, translate
from osculate.gui.solid.jacobian_colors import NEGATIVE, ROUNDING, colors_of

_BAR_WIDTH, _BAR_HEIGHT = 16.0, 160.0
_MARGIN, _PADDING, _GAP, _TICK = 9.5, 10.0, 6.0, 4.0
_RIM = "#7c8794"
_DIGITS = 3
_APART = 0.08  # of the bar's height, nearer to an end no tick is drawn at 0


@dataclass(frozen=True)
class Scale:
    """What a legend shows: the range of a Jacobian in mm³."""

    title: str
    least: float
    largest: float

    @property
    def size(self):
        """The largest magnitude."""
        return max(abs(self.least), abs(self.largest))

    @property
    def folds(self):
        """Whether it is negative somewhere, beyond rounding."""
        return self.least < -ROUNDING * self.size

    def ticks(self):
        """(share of the bar from below, text) of the numbers beside it."""
        ends = [0.0 if abs(end) <= ROUNDING * self.size else end
                for end in (self.least, self.largest)]
        span = ends[1] - ends[0]
        yield 1.0, numbers.number(ends[1], _DIGITS)
        if span > 0.0:
            yield 0.0, numbers.number(ends[0], _DIGITS)
            if _APART < -ends[0] / span < 1.0 - _APART:
                yield -ends[0] / span, "0"


def legend_picture(scale, text_points, left):
    """(node, right): the picture, hanging from its upper left corner, `left` points to the right of
    it; where it ends.
    """
    fonts = label_fonts(text_points)
    lines, ticks = list(_lines(scale, *fonts)), list(scale.ticks())
    width = max([_width(font, text) for text, font, _ in lines]
                + [_BAR_WIDTH + _TICK + _GAP + _width(fonts[0], text) for _, text in ticks])
    line_height = QtGui.QFontMetricsF(fonts[1]).height()
    height = (len(lines) + 1) * line_height + _GAP + _BAR_HEIGHT
    box = QtCore.QRectF(left + _MARGIN, _MARGIN, math.ceil(width) + 2.0 * _PADDING,
                        math.ceil(height) + 2.0 * _PADDING)
    picture = canvas(box.right() + 1.0, box.bottom() + 1.0)
    painter = painter_on(picture)
    painter.setPen(QtGui.QPen(QtGui.QColor(_RIM), 1.0))
    painter.setBrush(QtGui.QColor(255, 255, 255, 235))
    painter.drawRoundedRect(box, 5.0, 5.0)
    x, y = box.left() + _PADDING, box.top() + _PADDING
    for text, font, color in lines:
        _write(painter, QtCore.QPointF(x, y), text, font, color)
        y += line_height
    _draw_bar(painter, QtCore.QRectF(x, y + _GAP + line_height / 2.0, _BAR_WIDTH, _BAR_HEIGHT),
              scale, ticks, fonts[0])
    painter.end()
    return image_node(picture, coin.SoImage.LEFT, coin.SoImage.TOP), box.right() + 0.5


def _lines(scale, plain, bold):
    """(text, font, colour) of the lines above the bar."""
    yield scale.title, bold, TEXT_COLOR
    yield translate("Osculate", "Jacobian, mm³"), plain, TEXT_COLOR
    if scale.folds:
        yield translate("Osculate", "folds where it is < 0"), bold, NEGATIVE[-1][1]


def _draw_bar(painter, box, scale, ticks, font):
    gradient = QtGui.QLinearGradient(box.bottomLeft(), box.topLeft())
    values = numpy.linspace(scale.least, scale.largest, 101)
    for share, color in zip(numpy.linspace(0.0, 1.0, 101), colors_of(values, scale.size)):
        gradient.setColorAt(float(share), QtGui.QColor.fromRgbF(*map(float, color)))
    painter.setPen(QtGui.QPen(QtGui.QColor(_RIM), 1.0))
    painter.setBrush(QtGui.QBrush(gradient))
    painter.drawRect(box)
    half = QtGui.QFontMetricsF(font).height() / 2.0
    for share, text in ticks:
        y = box.bottom() - share * box.height()
        painter.setPen(QtGui.QPen(QtGui.QColor(TEXT_COLOR), 1.0))
        painter.drawLine(QtCore.QPointF(box.right(), y), QtCore.QPointF(box.right() + _TICK, y))
        _write(painter, QtCore.QPointF(box.right() + _TICK + _GAP, y - half), text, font,
               TEXT_COLOR)


def _width(font, text):
    return QtGui.QFontMetricsF(font).horizontalAdvance(text)


def _write(painter, corner, text, font, color):
    """A line of text from its upper left corner."""
    painter.setFont(font)
    painter.setPen(QtGui.QColor(color))
    painter.drawText(corner + QtCore.QPointF(0.0, QtGui.QFontMetricsF(font).ascent()), text)
