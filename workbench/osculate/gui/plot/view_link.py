"""Links a plot to the 3D views: finds the curve under the mouse, and marks a point of it."""

import numpy

from osculate.comb_drawing import size_of
from osculate.gui import colors, preferences
from osculate.gui.overlays.point_marker import PointMarker
from osculate.gui.overlays.scene import SceneOverlay
from osculate.gui.overlays.screen import Screen
from osculate.gui.plot.plot_words import short_reading
from osculate.gui.qt import Qt, QtCore, Signal
from osculate.gui.view_watcher import ViewWatcher, pixel_of

_REACH = 14.0  # pixels at the usual density, within which the mouse is at a curve


class ViewLink(ViewWatcher):
    """Links one document; nothing of it is left after `stop`."""

    pointed = Signal(object)  #: the arc length at the mouse, None where it left the curves

    def __init__(self, document_name):
        super().__init__(document_name)
        self._overlay = SceneOverlay()
        self._marker = PointMarker(colors.CURSOR, preferences.load().label_points)
        self._segments = None  # of the plot: points and arc lengths of both their ends
        self._size = 0.0
        self._was_near = False
        self._overlay.show(document_name, self._marker.node)

    def follow(self, plot):
        """Looks for the mouse along a CurvePlot; None: along nothing."""
        self.watch_new_views()
        self._overlay.show(self.document_name, self._marker.node)
        self._segments = None if plot is None else _segments(plot)
        self._size = 0.0 if plot is None else size_of([plot.comb])
        self._marker.hide()

    def mark(self, at):
        """Marks a PlotPoint; None: none."""
        if at is None:
            self._marker.hide()
            return
        name, text = short_reading(at, self._size)
        geometry = at.geometry
        avoided = [axis for axis in (geometry.tangent, geometry.normal) if axis is not None]
        avoided += [-axis for axis in avoided[:1]]
        self._marker.show(geometry.point, name, text, avoided)

    def stop(self):
        super().stop()
        self._overlay.remove()

    def forget(self):
        """The document is closing: its views are gone or going."""
        self._watched = {}
        self._overlay.forget()

    def eventFilter(self, widget, event):
        kinds = QtCore.QEvent.Type
        if self._segments is None or event.type() not in (kinds.MouseMove, kinds.Leave):
            return False
        view = self.canvas_view(widget)
        if view is not None:
            self._moved(view, widget, event)
        return False

    def _moved(self, view, widget, event):
        s = None
        if event.type() == QtCore.QEvent.Type.MouseMove:
            if event.buttons() != Qt.MouseButton.NoButton:
                return  # the view is turned, or something is dragged
            s = self._arc_length_at(view, pixel_of(event, widget), widget.devicePixelRatioF())
        if s is not None or self._was_near:
            self._was_near = s is not None
            self.pointed.emit(s)

    def _arc_length_at(self, view, pixel, density):
        starts, ends, s_starts, s_ends = self._segments
        screen = Screen(view)
        first, last = screen.pixels_of(starts), screen.pixels_of(ends)
        along = last - first
        square = (along ** 2).sum(axis=1)
        with numpy.errstate(invalid="ignore", divide="ignore"):
            share = numpy.nan_to_num(((pixel - first) * along).sum(axis=1) / square)
        share = numpy.clip(share, 0.0, 1.0)
        apart = numpy.linalg.norm(first + share[:, None] * along - pixel, axis=1)
        if not len(apart) or numpy.isnan(apart).all():
            return None
        nearest = int(numpy.nanargmin(apart))
        if apart[nearest] > _REACH * density:
            return None
        return float(s_starts[nearest] + share[nearest] * (s_ends[nearest] - s_starts[nearest]))


def _segments(plot):
    """Points and arc lengths of both ends of the lines between the samples of each run."""
    inside = numpy.ones(max(len(plot.s) - 1, 0), bool)
    inside[plot.comb.runs[:-1, 1]] = False
    first = numpy.flatnonzero(inside)
    points, s = plot.comb.point, plot.s
    return points[first], points[first + 1], s[first], s[first + 1]
