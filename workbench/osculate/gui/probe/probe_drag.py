"""The mouse moves a probe: by its point, along the curves wherever it is, by a double-click."""

import math

import numpy

from osculate.gui.construct.drag_target import DragTarget
from osculate.gui.overlays.curve_picker import CurvePicker
from osculate.gui.overlays.screen import Screen
from osculate.gui.qt import Qt, QtWidgets, Signal

_REACH = 14.0         # pixels around the point in which the mouse takes it
_FOLLOW_REACH = 60.0  # from a curve, in which the point follows the mouse
_SNAP_REACH = 12.0    # from a special point, in which the probe jumps to it


class ProbeDrag(DragTarget):
    """Tells where the user moves the point of a CurveProbe.

    Held is the offset from the mouse to the point, in pixels of the device.
    """

    moved = Signal(float)  #: arc length, while the mouse moves
    fixed = Signal()       #: a click ended that the point follows the mouse

    def __init__(self, document_name):
        super().__init__(document_name)
        self.follows = False  #: the mouse without a button moves the point
        self.snaps = True     #: it jumps to special points; Shift does the opposite
        self._probe = self._reading = self._picker = None

    def show(self, probe, reading):
        """Follows the model; None, None where there is no point."""
        self._watch_new_views()
        self._reading = reading
        if probe is not self._probe:
            self._probe = probe
            self._picker = None if probe is None else CurvePicker(probe)

    def stop(self):
        """Leaves no trace in any view."""
        self._leave_views()
        self._probe = self._reading = self._picker = None

    # What HandleMouse tells

    def hover(self, view, pixel, density):
        """The mouse is at a pixel; True if it is at the point, or moves it."""
        if self._reading is None:
            return False
        if self.follows:
            s = self._arc_length_at(view, pixel, density, _FOLLOW_REACH * density)
            if s is not None:
                self.moved.emit(s)
            self.hot = s
            return s is not None
        self.hot = True if self._offset(view, pixel, density) else None
        return self.hot is not None

    def take(self, view, pixel, density):
        """The mouse was pressed; True if the point was taken, or stays where it followed to."""
        if self._reading is None:
            return False
        if self.follows:
            self.fixed.emit()
            return True
        self._held = self._offset(view, pixel, density)
        self._density = density
        return self._held is not None

    def drag(self, view, pixel):
        place = [x + offset for x, offset in zip(pixel, self._held)]
        s = self._arc_length_at(view, place, self._density, math.inf)
        if s is not None:
            self.moved.emit(s)

    def double_click(self, view, pixel, density):
        """Brings the point to a place of the curves; True if there is one."""
        if self._reading is None:
            return False
        s = self._arc_length_at(view, pixel, density, _REACH * density)
        if s is not None:
            self.moved.emit(s)
            self.let_loose.emit()
        return s is not None

    def break_off(self):
        if self.follows:
            self.taken_back.emit()
            return True
        return super().break_off()

    # Within

    def _offset(self, view, pixel, density):
        """(x, y) from a pixel to the point, None if it is out of reach."""
        x, y = Screen(view).pixel_of(self._reading.point)
        offset = x - pixel[0], y - pixel[1]
        return offset if math.hypot(*offset) <= _REACH * density else None

    def _arc_length_at(self, view, pixel, density, reach):
        if self._picker is None:
            return None
        screen = Screen(view)
        s = self._picker.arc_length_at(screen, pixel, reach)
        return s if s is None or not self._is_snapping() else self._snapped(screen, s, density)

    def _is_snapping(self):
        is_shifted = bool(QtWidgets.QApplication.keyboardModifiers()
                          & Qt.KeyboardModifier.ShiftModifier)
        return self.snaps != is_shifted

    def _snapped(self, screen, s, density):
        """The arc length of the special point that is seen nearest to that of another, or this."""
        here = screen.pixel_of(self._probe.at(s).point)
        apart = numpy.linalg.norm(screen.pixels_of(self._probe.special_points) - here, axis=1)
        if not len(apart) or numpy.isnan(apart).all():
            return s
        nearest = int(numpy.nanargmin(apart))
        return self._probe.specials[nearest].s if apart[nearest] < _SNAP_REACH * density else s
