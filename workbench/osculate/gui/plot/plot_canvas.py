"""The plot on the screen: matplotlib's canvas with a cursor; the wheel zooms, dragging moves.

Imports matplotlib.
"""

from matplotlib.figure import Figure

from osculate.gui import colors
from osculate.gui.matplotlib_qt import FigureCanvasQTAgg
from osculate.gui.qt import Qt, QtCore, QtGui, QtWidgets, Signal, mouse_position
from osculate.plot_drawing import PlotDrawing

_NOTCH = 1.25        # how much more of the curve a notch of the wheel shows
_LEAST_SHARE = 1e-5  # of the length that is shown at least
_CLICK = 4           # pixels that the mouse may move during a click


class PlotCanvas(FigureCanvasQTAgg):
    """Shows a CurvePlot; tells where the mouse is."""

    pointed = Signal(object)  #: the arc length under the mouse, None where it left
    clicked = Signal(object)  #: the arc length where it was
    locked = Signal()         #: the user chose the scale of the values

    def __init__(self):
        screen = QtGui.QGuiApplication.primaryScreen()
        super().__init__(Figure(dpi=screen.logicalDotsPerInch()))
        self.drawing = PlotDrawing(self.figure)
        self.plot, self.limits = None, {}
        self._cursor = None  # (s, {quantity: value})
        self._grip = None    # where the mouse was pressed, and what was seen then
        self.setMinimumHeight(120)
        self.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self.setSizePolicy(QtWidgets.QSizePolicy.Policy.Expanding,
                           QtWidgets.QSizePolicy.Policy.Expanding)

    # What is shown

    def show_plot(self, plot, quantities, look, keeps_window):
        """Shows a CurvePlot; the same part of its length, if that is wanted and it is there."""
        first, last = self.seen if keeps_window and self.plot is not None else (0.0, plot.length)
        if last > plot.length or self._is_whole():
            first, last = 0.0, plot.length
        self.plot, self._look = plot, look
        self._cursor = None
        self.drawing.show(plot, quantities=quantities, look=look, window=(first, last),
                          limits=self.limits)
        self.draw_idle()

    def _is_whole(self):
        return self.plot is not None and self.seen == (0.0, self.plot.length)

    @property
    def seen(self):
        """(first, last) arc length that is seen."""
        return self.drawing.window

    def see(self, first, last):
        """Shows a part of the length, as much of it as there is."""
        length = self.plot.length
        span = min(max(last - first, _LEAST_SHARE * length), length)
        first = min(max(first, 0.0), length - span)
        self.drawing.see((first, first + span), self.limits)
        self.draw_idle()

    def see_all(self):
        self.see(0.0, self.plot.length)

    def lock(self, is_locked):
        """Keeps the scale of the values as it is, or lets it follow what is seen."""
        self.limits = {quantity: axes.get_ylim()
                       for quantity, axes in self.drawing.axes.items()} if is_locked else {}
        if self.plot is not None:
            self.see(*self.seen)

    def set_cursor_at(self, s, values):
        """Shows a line at an arc length and a dot at each value; None for s: neither."""
        self._cursor = None if s is None else (s, values)
        self.update()

    # What Qt calls

    def resizeEvent(self, event):
        super().resizeEvent(event)
        if self.plot is not None:
            self.drawing.arrange()

    def paintEvent(self, event):
        super().paintEvent(event)
        if self._cursor is not None and self.drawing.axes:
            painter = QtGui.QPainter(self)
            painter.setRenderHint(QtGui.QPainter.RenderHint.Antialiasing)
            self._paint_cursor(painter, *self._cursor)
            painter.end()

    def _paint_cursor(self, painter, s, values):
        if not self.seen[0] <= s <= self.seen[1]:
            return
        for quantity, axes in self.drawing.axes.items():
            box = self._box_of(axes)
            value = values.get(quantity)
            place = self._place_of(axes, s, 0.0 if value is None else value)
            painter.setPen(QtGui.QPen(QtGui.QColor(colors.CURSOR), 1.4))
            painter.drawLine(QtCore.QPointF(place.x(), box.top()),
                             QtCore.QPointF(place.x(), box.bottom()))
            if value is not None and box.top() <= place.y() <= box.bottom():
                painter.setPen(QtGui.QPen(QtGui.QColor(self._look.ground), 1.5))
                painter.setBrush(QtGui.QColor(colors.CURSOR))
                painter.drawEllipse(place, 4.5, 4.5)

    def _place_of(self, axes, s, value):
        """Where a point of axes is in the widget."""
        x, y = axes.transData.transform((s, value))
        return QtCore.QPointF(x / self.device_pixel_ratio,
                              self.height() - y / self.device_pixel_ratio)

    def _box_of(self, axes):
        (left, bottom), (right, top) = axes.bbox.get_points() / self.device_pixel_ratio
        return QtCore.QRectF(QtCore.QPointF(left, self.height() - top),
                             QtCore.QPointF(right, self.height() - bottom))

    # The mouse; matplotlib's own answers to it are not wanted

    def enterEvent(self, event):
        event.accept()

    def leaveEvent(self, _event):
        self.pointed.emit(None)

    def mousePressEvent(self, event):
        if event.button() in (Qt.MouseButton.LeftButton, Qt.MouseButton.MiddleButton) and self.plot:
            self._grip = mouse_position(event)[0], self.seen, False

    def mouseMoveEvent(self, event):
        x = mouse_position(event)[0]
        if self.plot is None:
            return
        if self._grip is None:
            self.pointed.emit(self._arc_length_at(x))
            return
        start, (first, last), was_moved = self._grip
        if was_moved or abs(x - start) > _CLICK:
            self._grip = start, (first, last), True
            shift = (start - x) / self._box_of(self._top()).width() * (last - first)
            self.see(first + shift, last + shift)

    def mouseReleaseEvent(self, event):
        grip, self._grip = self._grip, None
        if grip is not None and not grip[2] and event.button() == Qt.MouseButton.LeftButton:
            self.clicked.emit(self._arc_length_at(grip[0]))

    def mouseDoubleClickEvent(self, _event):
        if self.plot is not None:
            self.see_all()

    def wheelEvent(self, event):
        event.accept()
        notches = event.angleDelta().y() / 120.0
        if self.plot is None or not notches:
            return
        if event.modifiers() & Qt.KeyboardModifier.ControlModifier:
            self._scale_values(event, _NOTCH ** -notches)
            return
        centre = self._arc_length_at(event.position().x())
        first, last = (centre + (end - centre) * _NOTCH ** -notches for end in self.seen)
        self.see(first, last)

    def _scale_values(self, event, factor):
        """Shows more or less of the values under the mouse."""
        place = event.position()
        for quantity, axes in self.drawing.axes.items():
            if self._box_of(axes).contains(place):
                _, value = axes.transData.inverted().transform(
                    (0.0, (self.height() - place.y()) * self.device_pixel_ratio))
                self.lock(True)
                self.limits[quantity] = tuple(value + (end - value) * factor
                                              for end in axes.get_ylim())
                self.see(*self.seen)
                self.locked.emit()

    def _top(self):
        return next(iter(self.drawing.axes.values()))

    def _arc_length_at(self, x):
        """The arc length at a place from left to right, within what is seen."""
        box = self._box_of(self._top())
        share = min(max((x - box.left()) / box.width(), 0.0), 1.0)
        first, last = self.seen
        return first + share * (last - first)
