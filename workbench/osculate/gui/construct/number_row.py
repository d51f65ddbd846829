"""One number that may be fixed: its name, whether it is fixed, a slider, a spin box."""

from osculate.gui import resources
from osculate.gui.panel.number_spin_box import NumberSpinBox
from osculate.gui.panel.quiet import Slider
from osculate.gui.qt import QtCore, QtWidgets, Signal, translate

_STEPS = 1000             # of a slider, from its middle
_WIDEST = "-0000.000 mm"  # what has room in the spin box


class NumberRow(QtCore.QObject):
    """Base of the rows of one number; a subclass says which place of the slider is which number."""

    given = Signal(int, float, bool)  #: k, the number, and whether it is settled
    freed = Signal(int)               #: k
    settled = Signal()                #: a slider was let go

    def __init__(self, k, name, meaning, box_range, suffix=""):
        super().__init__()
        self._k = k
        self._is_fixed = None  #: as it is shown
        self.name = QtWidgets.QLabel(name)
        self.name.setToolTip(meaning)
        self.lock = QtWidgets.QToolButton()
        self.lock.setCheckable(True)
        self.lock.setAutoRaise(True)
        self.lock.setIconSize(QtCore.QSize(16, 16))
        self.slider = Slider(-_STEPS, _STEPS)
        self.slider.setMinimumWidth(60)
        self.box = NumberSpinBox(suffix, *box_range)
        self.box.setFixedWidth(self.box.fontMetrics().horizontalAdvance(_WIDEST) + 28)
        self.lock.clicked.connect(self._lock_clicked)
        self.slider.valueChanged.connect(self._slid)
        self.slider.sliderReleased.connect(self.settled)
        self.box.valueChanged.connect(lambda value: self.given.emit(k, value, True))

    # What a subclass does

    def number_at(self, place):
        """The number at a place of the slider, -1 to 1."""
        raise NotImplementedError

    def place_of(self, value):
        """The place of a number; it may lie beyond the slider."""
        raise NotImplementedError

    def free_tip(self):
        """What the lock says of a number that is not fixed."""
        return translate("Osculate", "Chosen by fairness: click to fix it as it is")

    # What all do

    def widgets(self):
        return self.name, self.lock, self.slider, self.box

    def show_number(self, value, is_fixed):
        """Shows a number without telling anyone."""
        self.box.show_value(value)
        self.slider.show_value(round(_STEPS * min(max(self.place_of(value), -1.0), 1.0)))
        if is_fixed is not self._is_fixed:
            self._show_lock(is_fixed)

    def _show_lock(self, is_fixed):
        self._is_fixed = is_fixed
        self.lock.setChecked(is_fixed)
        self.lock.setIcon(resources.icon("locked" if is_fixed else "free"))
        self.lock.setToolTip(
            translate("Osculate", "Fixed: click to let it be chosen") if is_fixed else
            self.free_tip())

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
        self.given.emit(self._k, self.number_at(place / _STEPS), not self.slider.isSliderDown())
