"""Small pictures for the 3D view: they keep their size and carry their own background.

Each function gives a node that is centred on, or hangs from, the point at which it is placed.
"""

from pivy import coin

from osculate.gui.overlays.pictures import (
    TEXT_COLOR, canvas, draw_text, image_node, label_fonts, painter_on)
from osculate.gui.qt import Qt, QtCore, QtGui

_RING_RADIUS = 7.0

#: The size of a knob, and how far above its point a caption is.
_KNOB, _CAPTION_UP = 20.0, 22.0

#: A note's distance from its point, to the right and up.
_NOTE_AWAY = 5.0

#: A label's distance from its point, its rim, and where the line to the point begins.
_REACH_RIGHT, _REACH_UP, _MARGIN, _LEAD = 30.0, 58.0, 2.0, 5.0


def _centred(picture):
    return image_node(picture, coin.SoImage.CENTER, coin.SoImage.HALF)


def ring(color):
    """A ring that marks a point."""
    size = 2.0 * _RING_RADIUS + 8.0
    picture = canvas(size, size)
    painter = painter_on(picture)
    centre = QtCore.QPointF(size / 2.0, size / 2.0)
    for pen, width in (("#ffffff", 6.0), (color, 3.0)):
        painter.setPen(QtGui.QPen(QtGui.QColor(pen), width))
        painter.drawEllipse(centre, _RING_RADIUS, _RING_RADIUS)
    painter.end()
    return _centred(picture)


def dot(color):
    """A small filled dot."""
    picture = canvas(11, 11)
    painter = painter_on(picture)
    painter.setPen(QtGui.QPen(QtGui.QColor("#ffffff"), 1.4))
    painter.setBrush(QtGui.QColor(color))
    painter.drawEllipse(QtCore.QPointF(5.5, 5.5), 3.6, 3.6)
    painter.end()
    return _centred(picture)


#: Outlines of symbols in a square of -1 to 1, y down: polygons, or None for a circle.
_SYMBOLS = {
    "circle": None,
    "diamond": ((0.0, -1.2), (1.2, 0.0), (0.0, 1.2), (-1.2, 0.0)),
    "square": ((-0.95, -0.95), (0.95, -0.95), (0.95, 0.95), (-0.95, 0.95)),
    "triangle": ((0.0, -1.1), (1.1, 0.9), (-1.1, 0.9)),
    "bar": ((-0.15, -1.3), (0.15, -1.3), (0.15, 1.3), (-0.15, 1.3)),
    "cross": ((-1.0, -1.0), (0.0, -0.35), (1.0, -1.0), (0.35, 0.0), (1.0, 1.0), (0.0, 0.35),
              (-1.0, 1.0), (-0.35, 0.0)),
}
_SYMBOL_RADIUS = 5.0


def symbol(kind, color, is_filled=True):
    """A small symbol of _SYMBOLS, "circle" for one, filled or hollow, with a rim."""
    size = 2.0 * _SYMBOL_RADIUS + 8.0
    picture = canvas(size, size)
    painter = painter_on(picture)
    draw_symbol(painter, QtCore.QPointF(size / 2.0, size / 2.0), kind, color, is_filled)
    painter.end()
    return _centred(picture)


def draw_symbol(painter, centre, kind, color, is_filled):
    """The same on any picture."""
    outline = QtGui.QPainterPath()
    if _SYMBOLS[kind] is None:
        outline.addEllipse(centre, _SYMBOL_RADIUS, _SYMBOL_RADIUS)
    else:
        outline.addPolygon(QtGui.QPolygonF([centre + _SYMBOL_RADIUS * QtCore.QPointF(x, y)
                                            for x, y in _SYMBOLS[kind]]))
        outline.closeSubpath()
    painter.strokePath(outline, QtGui.QPen(QtGui.QColor("#ffffff"), 4.4))
    painter.fillPath(outline, QtGui.QColor(color if is_filled else "#ffffff"))
    painter.strokePath(outline, QtGui.QPen(QtGui.QColor(color), 1.8))


def letter(text, color, points):
    """A letter in a colour with a white outline."""
    font = QtGui.QFont("serif", points)
    font.setItalic(True)
    font.setBold(True)
    path = QtGui.QPainterPath()
    path.addText(QtCore.QPointF(0, 0), font, text)
    box = path.boundingRect().adjusted(-4, -4, 4, 4)
    picture = canvas(box.width(), box.height())
    painter = painter_on(picture)
    painter.translate(-box.topLeft())
    painter.strokePath(path, QtGui.QPen(QtGui.QColor("#ffffff"), 4.0, Qt.PenStyle.SolidLine,
                                        Qt.PenCapStyle.RoundCap, Qt.PenJoinStyle.RoundJoin))
    painter.fillPath(path, QtGui.QColor(color))
    painter.end()
    return _centred(picture)


def tag(text, color):
    """A round tag with a character."""
    size = 22.0
    picture = canvas(size, size)
    painter = painter_on(picture)
    box = QtCore.QRectF(2, 2, size - 4, size - 4)
    painter.setPen(QtGui.QPen(QtGui.QColor("#ffffff"), 2.0))
    painter.setBrush(QtGui.QColor(color))
    painter.drawEllipse(box)
    font = painter.font()
    font.setPixelSize(12)
    font.setBold(True)
    painter.setFont(font)
    painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)
    painter.end()
    return _centred(picture)


def knob(text, color, is_filled, is_hot, is_round):
    """What can be dragged: a disk or a rounded square with a short text, filled or hollow, and
    larger while it is hot.
    """
    size = _KNOB + (6.0 if is_hot else 0.0)
    picture = canvas(size + 6.0, size + 6.0)
    painter = painter_on(picture)
    box = QtCore.QRectF(3.0, 3.0, size, size)
    radius = size / 2.0 if is_round else size / 5.0
    for pen, width, brush in (("#ffffff", 5.0, "#ffffff"),
                              (color, 2.4, color if is_filled else "#ffffff")):
        painter.setPen(QtGui.QPen(QtGui.QColor(pen), width))
        painter.setBrush(QtGui.QColor(brush))
        painter.drawRoundedRect(box, radius, radius)
    font = painter.font()
    font.setPixelSize(13)
    font.setBold(True)
    draw_text(painter, box, text, font, "#ffffff" if is_filled else color)
    painter.end()
    return _centred(picture)


def caption(text, color, points):
    """A line of text in a white field with a rim, above its point."""
    font, _ = label_fonts(points)
    metrics = QtGui.QFontMetricsF(font)
    width, height = metrics.horizontalAdvance(text) + 14.0, metrics.height() + 6.0
    picture = canvas(width + 4.0, height + _CAPTION_UP)
    painter = painter_on(picture)
    box = QtCore.QRectF(2.0, 2.0, width, height)
    painter.setPen(QtGui.QPen(QtGui.QColor(color), 1.6))
    painter.setBrush(QtGui.QColor("#ffffff"))
    painter.drawRoundedRect(box, 5.0, 5.0)
    draw_text(painter, box, text, font, TEXT_COLOR)
    painter.end()
    return image_node(picture, coin.SoImage.CENTER, coin.SoImage.BOTTOM)


def note(text, points, color=TEXT_COLOR):
    """A few characters in a pale field, up to the right of their point."""
    font, _ = label_fonts(points)
    metrics = QtGui.QFontMetricsF(font)
    width, height = metrics.horizontalAdvance(text) + 8.0, metrics.height()
    picture = canvas(width + _NOTE_AWAY, height + _NOTE_AWAY)
    painter = painter_on(picture)
    box = QtCore.QRectF(_NOTE_AWAY, 0.0, width, height)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(QtGui.QColor(255, 255, 255, 205))
    painter.drawRoundedRect(box, 3.0, 3.0)
    draw_text(painter, box, text, font, color)
    painter.end()
    return image_node(picture, coin.SoImage.LEFT, coin.SoImage.BOTTOM)


def callout(name, text, color, points, corner):
    """A label away from its point, with a line that leads to it.

    `name` stands in a field of the colour, `text` (may be empty, or of several lines) beside it on
    white. `corner` is (1, 1) for a label up to the right of its point, (-1, -1) for down to the
    left, and so on.
    """
    font, bold = label_fonts(points)
    lines, metrics = text.split("\n"), QtGui.QFontMetricsF(font)
    height = QtGui.QFontMetricsF(bold).height() + (len(lines) - 1) * metrics.lineSpacing() + 8.0
    name_width = QtGui.QFontMetricsF(bold).horizontalAdvance(name) + 16.0
    text_width = max(map(metrics.horizontalAdvance, lines)) + 18.0 if text else 0.0
    width = _REACH_RIGHT + name_width + text_width + _MARGIN
    picture = canvas(width, _REACH_UP + height + _MARGIN)
    right, up = corner[0] > 0, corner[1] > 0
    box = QtCore.QRectF(_REACH_RIGHT if right else _MARGIN, _MARGIN if up else _REACH_UP,
                        name_width + text_width, height)
    name_box = QtCore.QRectF(box.left(), box.top(), name_width, height)
    text_box = QtCore.QRectF(name_box.right(), box.top(), text_width, height)
    painter = painter_on(picture)
    _draw_leader(painter, QtCore.QPointF(_LEAD if right else width - _LEAD,
                                         _REACH_UP + height + _MARGIN - _LEAD if up else _LEAD),
                 QtCore.QPointF(box.left() + 8.0 if right else box.right() - 8.0,
                                box.bottom() if up else box.top()), color)
    _draw_fields(painter, box, name_box, color)
    draw_text(painter, name_box, name, bold, "#ffffff")
    draw_text(painter, text_box, text, font, TEXT_COLOR)
    painter.end()
    return image_node(picture, coin.SoImage.LEFT if right else coin.SoImage.RIGHT,
                      coin.SoImage.BOTTOM if up else coin.SoImage.TOP)


def _draw_leader(painter, start, end, color):
    for pen, width in (("#ffffff", 4.5), (color, 2.0)):
        painter.setPen(QtGui.QPen(QtGui.QColor(pen), width))
        painter.drawLine(start, end)


def _draw_fields(painter, box, name_box, color):
    """The white label with a coloured left field and rim, all with round corners."""
    outline = QtGui.QPainterPath()
    outline.addRoundedRect(box, 5.0, 5.0)
    painter.fillPath(outline, QtGui.QColor("#ffffff"))
    painter.save()
    painter.setClipRect(name_box)
    painter.fillPath(outline, QtGui.QColor(color))
    painter.restore()
    painter.strokePath(outline, QtGui.QPen(QtGui.QColor(color), 1.6))
