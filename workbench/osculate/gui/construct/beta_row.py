"""One free number: its name, whether it is fixed, a slider, a spin box."""

import math

from osculate.gui import resources
from osculate.gui.panel.number_spin_box import NumberSpinBox
from osculate.gui.panel.quiet import Slider
from osculate.gui.qt import QtCore, QtWidgets, Signal, translate

_SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
_STEPS = 1000                      # of a slider, from its middle
_LEAST, _MOST = 1e-6, 1e6          # of beta_1, which is positive
_DECADES = 1.0                     # a slider of beta_1 goes from 0.1 to 10
_REACH = {2: 4.0, 3: 5.5, 4: 7.5}  # of the others: to ±sinh of it, about 27, 120, 900


class BetaRow(QtCore.QObject):
    """The widgets of β of order k at one end."""

    given = Signal(int, float, bool)  #: k, the number, and whether it is settled
    freed = Signal(int)               #: k
    settled = Signal()                #: a slider was let go

    def __init__(self, k):
        super().__init__()
        self._k = k
        self._is_fixed = None  #: as it is shown
        self.name = QtWidgets.QLabel("β" + str(k).translate(_SUBSCRIPTS))
        self.name.setToolTip(_meaning(k))
        self.lock = QtWidgets.QToolButton()
        self.lock.setCheckable(True)
        self.lock.setAutoRaise(True)
        self.lock.setIconSize(QtCore.QSize(16, 16))
        self.slider = Slider(-_STEPS, _STEPS)
        self.slider.setMinimumWidth(60)
        self.box = NumberSpinBox("", *((_LEAST, _MOST) if k == 1 else (-1e9, 1e9)))
        self.box.setFixedWidth(self.box.fontMetrics().horizontalAdvance("-0000.000") + 28)
        self.lock.clicked.connect(self._lock_clicked)
        self.slider.valueChanged.connect(self._slid)
        self.slider.sliderReleased.connect(self.settled)
        self.box.valueChanged.connect(lambda value: self.given.emit(k, value, True))

    def widgets(self):
        return self.name, self.lock, self.slider, self.box

    def show_number(self, value, is_fixed):
        """Shows a number without telling anyone."""
        self.box.show_value(value)
        self.slider.show_value(round(_STEPS * _place(self._k, value)))
        if is_fixed is not self._is_fixed:
            self._show_lock(is_fixed)

    def _show_lock(self, is_fixed):
        self._is_fixed = is_fixed
        self.lock.setChecked(is_fixed)
        self.lock.setIcon(resources.icon("locked" if is_fixed else "free"))
        self.lock.setToolTip(
            translate("Osculate", "Fixed: click to let it be chosen") if is_fixed else
            translate("Osculate", "Chosen by fairness: click to fix it as it is"))

    def set_visible(self, is_visible):
        for widget in self.widgets():
            widget.setVisible(is_visible)

    def _lock_clicked(self, is_fixed):
        self._is_fixed = None  # the click changed the button; what is shown next may not
        if is_fixed:
            self.given.emit(self._k, self.box.value(), True)
        else:
            self.freed.emit(self._k)

    def _slid(self, place):
        self.given.emit(self._k, _number(self._k, place / _STEPS), not self.slider.isSliderDown())


def _number(k, place):
    """The number at a place of the slider, -1 to 1: even in its logarithm, or nearly so."""
    if k == 1:
        return 10.0 ** (_DECADES * place)
    return math.sinh(_reach(k) * place)


def _place(k, value):
    """The place of a number, within the slider."""
    place = math.log10(value) / _DECADES if k == 1 else math.asinh(value) / _reach(k)
    return min(max(place, -1.0), 1.0)


def _reach(k):
    return _REACH.get(k, 2.0 * k)


def _meaning(k):
    if k == 1:
        return translate("Osculate", "The speed at this end, as a share of the chord; it has a "
                                     "handle in the 3D view")
    if k == 2:
        return translate("Osculate", "The change of speed at this end, as a share of the chord; it "
                                     "has a handle in the 3D view")
    return translate("Osculate", "The derivative of order {} of arc length at this end, as a share "
                                 "of the chord").format(k)
