"""A spin box for tolerances: any size of number, steps of 1, 2, 5."""

import math

from osculate.gui.qt import Qt, QtGui, QtWidgets

_LEAST, _MOST = 1e-12, 1e6


class ToleranceSpinBox(QtWidgets.QDoubleSpinBox):
    """A positive number of up to 6 significant digits."""

    def __init__(self, suffix):
        super().__init__()
        self.setSuffix(suffix)
        self.setDecimals(15)  # of what is kept; what is shown is up to textFromValue
        self.setRange(_LEAST, _MOST)
        self.setKeyboardTracking(False)

    def textFromValue(self, value):
        return f"{value:.6g}"

    def valueFromText(self, text):
        return float(self._number(text))

    def validate(self, text, position):
        number = self._number(text)
        try:
            good = math.isfinite(float(number)) and float(number) > 0.0
        except ValueError:
            unfinished = all(character in "0123456789.eE+-" for character in number)
            state = QtGui.QValidator.State
            return state.Intermediate if unfinished else state.Invalid, text, position
        state = QtGui.QValidator.State
        return state.Acceptable if good else state.Intermediate, text, position

    def stepBy(self, steps):
        for _ in range(abs(steps)):
            self.setValue(_next_step(self.value(), steps > 0))

    def keyPressEvent(self, event):
        super().keyPressEvent(event)
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            event.accept()  # takes the number; FreeCAD would press OK as well

    def sizeHint(self):
        hint = super().sizeHint()
        hint.setWidth(self.fontMetrics().horizontalAdvance("0.000000001 mm") + 30)
        return hint

    def minimumSizeHint(self):
        return self.sizeHint()

    def _number(self, text):
        return text.replace(self.suffix(), "").strip().replace(",", ".")


def _next_step(value, up):
    """The next number of the series ..., 1, 2, 5, 10, ... above or below."""
    series = [step * 10.0 ** power for power in range(math.floor(math.log10(value)) - 1,
                                                      math.floor(math.log10(value)) + 3)
              for step in (1, 2, 5)]
    if up:
        return min(step for step in series if step > value * (1 + 1e-9))
    return max(step for step in series if step < value * (1 - 1e-9))
