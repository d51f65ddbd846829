"""Links a plot to the 3D views: finds the curve under the mouse, and marks a point of it."""

from osculate.comb_drawing import size_of
from osculate.gui import colors, preferences
from osculate.gui.overlays.curve_picker import CurvePicker
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
        self._picker = None  # of the plot
        self._size = 0.0
        self._was_near = False
        self._overlay.show(document_name, self._marker.node)

    def follow(self, plot):
        """Looks for the mouse along a CurvePlot; None: along nothing."""
        self.watch_new_views()
        self._overlay.show(self.document_name, self._marker.node)
        self._picker = None if plot is None else CurvePicker(plot)
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
        if self._picker is None or event.type() not in (kinds.MouseMove, kinds.Leave):
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
            s = self._picker.arc_length_at(Screen(view), pixel_of(event, widget),
                                           _REACH * widget.devicePixelRatioF())
        if s is not None or self._was_near:
            self._was_near = s is not None
            self.pointed.emit(s)
