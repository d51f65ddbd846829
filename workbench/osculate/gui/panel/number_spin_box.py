"""A spin box for numbers of any size, with steps that suit their size."""

import math

from osculate.gui.panel.quiet import QuietWheel
from osculate.gui.qt import Qt, QtGui, QtWidgets

_DIGITS = 15  # behind the point, of what is kept; what is shown is up to textFromValue


class NumberSpinBox(QuietWheel, QtWidgets.QDoubleSpinBox):
    """A number of up to 6 significant digits; a step is a twentieth to a half of a tenth power."""

    def __init__(self, suffix="", least=-1e9, most=1e9):
        super().__init__()
        self.setSuffix(suffix)
        self.setDecimals(_DIGITS)
        self.setRange(least, most)
        self.setKeyboardTracking(False)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

    def is_allowed(self, value):
        """Whether a finite number is within the range."""
        return self.minimum() <= value <= self.maximum()

    def next_step(self, value, up):
        """The number above or below."""
        size = 10.0 ** math.floor(math.log10(max(abs(value), 0.1) * 1.0001))
        step = size / 20.0
        place = value / step
        return step * (math.floor(place + 1e-9) + 1 if up else math.ceil(place - 1e-9) - 1)

    def textFromValue(self, value):
        return f"{value:.6g}"

    def valueFromText(self, text):
        return float(self._number(text))

    def validate(self, text, position):
        number = self._number(text)
        state = QtGui.QValidator.State
        try:
            value = float(number)
        except ValueError:
            unfinished = all(character in "0123456789.eE+-" for character in number)
            return state.Intermediate if unfinished else state.Invalid, text, position
        good = math.isfinite(value) and self.is_allowed(value)
        return state.Acceptable if good else state.Intermediate, text, position

    def stepBy(self, steps):
        for _ in range(abs(steps)):
            self.setValue(self.next_step(self.value(), steps > 0))

    def keyPressEvent(self, event):
        super().keyPressEvent(event)
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            event.accept()  # takes the number; FreeCAD would press OK as well

    def show_value(self, value):
        """Sets the number without telling anyone."""
        blocked = self.blockSignals(True)
        self.setValue(value)
        self.blockSignals(blocked)

    def _number(self, text):
        return text.replace(self.suffix(), "").strip().replace(",", ".").replace("−", "-")
