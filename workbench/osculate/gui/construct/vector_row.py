"""Three numbers of a point or a vector."""

import FreeCAD

from osculate.gui.panel.number_spin_box import NumberSpinBox
from osculate.gui.qt import QtWidgets, Signal

_LEAST_WIDTH = 60
_DIGITS = 4  # of a number without a suffix: so many have room


class VectorRow(QtWidgets.QWidget):
    """A spin box for each coordinate, with a suffix or, where it is narrow, a unit in its tip."""

    given = Signal(object)  #: a FreeCAD.Vector

    def __init__(self, suffix="", unit=""):
        super().__init__()
        self.boxes = [NumberSpinBox(suffix) if suffix else _ShortSpinBox() for _ in range(3)]
        layout = QtWidgets.QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(4)
        for box, axis in zip(self.boxes, "xyz"):
            box.setToolTip(f"{axis} {suffix or unit}")
            box.setMinimumWidth(_LEAST_WIDTH)
            box.setSizePolicy(QtWidgets.QSizePolicy.Policy.Ignored,
                              QtWidgets.QSizePolicy.Policy.Fixed)
            box.valueChanged.connect(self._changed)
            layout.addWidget(box, 1)

    def show_vector(self, vector):
        """Shows a vector without telling anyone."""
        for box, value in zip(self.boxes, vector):
            box.show_value(value)

    def _changed(self, _value):
        self.given.emit(FreeCAD.Vector(*(box.value() for box in self.boxes)))


class _ShortSpinBox(NumberSpinBox):
    def textFromValue(self, value):
        return f"{value:.{_DIGITS}g}"
