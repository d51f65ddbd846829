"""Parameters that the user sets: each a row of a form with a value and a signal."""

from osculate.gui.construct.rows import row_of
from osculate.gui.construct.vector_row import VectorRow
from osculate.gui.panel.number_spin_box import NumberSpinBox
from osculate.gui.panel.quiet import ComboBox, SpinBox
from osculate.gui.qt import QtCore, QtWidgets, Signal


class NumberField(QtCore.QObject):
    """One number with a unit."""

    changed = Signal()

    def __init__(self, start, suffix="", least=-1e9, most=1e9):
        super().__init__()
        self.widget = self.box = NumberSpinBox(suffix, least, most)
        self.box.show_value(start)
        self.box.valueChanged.connect(lambda _value: self.changed.emit())

    def value(self):
        return self.box.value()


def length_field(start):
    return NumberField(start, " mm")


class PointField(QtCore.QObject):
    """Three coordinates: of a point with a unit, of a direction without."""

    changed = Signal()

    def __init__(self, start, suffix=" mm"):
        super().__init__()
        self.widget = self.row = VectorRow(suffix)
        self.show_value(start)
        self.row.given.connect(lambda _vector: self.changed.emit())

    def value(self):
        return tuple(box.value() for box in self.row.boxes)

    def show_value(self, point):
        self.row.show_vector(point)


class NumbersField(QtCore.QObject):
    """Several numbers beside each other, each with a name in its tip."""

    changed = Signal()

    def __init__(self, start, names, suffix=""):
        super().__init__()
        self.boxes = []
        for number, name in zip(start, names):
            box = NumberSpinBox(suffix)
            box.setToolTip(name)
            box.setMinimumWidth(50)
            box.setSizePolicy(QtWidgets.QSizePolicy.Policy.Ignored,
                              QtWidgets.QSizePolicy.Policy.Fixed)
            box.show_value(number)
            box.valueChanged.connect(lambda _value: self.changed.emit())
            self.boxes.append(box)
        self.widget = row_of(*((box, 1) for box in self.boxes))

    def value(self):
        return tuple(box.value() for box in self.boxes)

    def show_value(self, numbers):
        for box, number in zip(self.boxes, numbers):
            box.show_value(number)


class CountField(QtCore.QObject):
    """A whole number."""

    changed = Signal()

    def __init__(self, start, least, most):
        super().__init__()
        self.widget = self.box = SpinBox()
        self.box.setRange(least, most)
        self.box.setValue(start)
        self.box.valueChanged.connect(lambda _value: self.changed.emit())

    def value(self):
        return self.box.value()


class ChoiceField(QtCore.QObject):
    """One of some values; choices are (value, text) pairs."""

    changed = Signal()

    def __init__(self, choices):
        super().__init__()
        self.widget = self.box = ComboBox()
        for value, text in choices:
            self.box.addItem(text, value)
        self.box.activated.connect(lambda _index: self.changed.emit())

    def value(self):
        return self.box.currentData()

    def show_value(self, value):
        self.box.setCurrentIndex(self.box.findData(value))


class Fields(QtWidgets.QWidget):
    """Named fields under each other; `values()` is a dict of them."""

    changed = Signal()

    def __init__(self, fields):
        """fields: {key: (label, field)}"""
        super().__init__()
        self.fields = {key: field for key, (_label, field) in fields.items()}
        self._labels = {}
        grid = QtWidgets.QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setColumnStretch(1, 1)
        for row, (key, (label, field)) in enumerate(fields.items()):
            self._labels[key] = QtWidgets.QLabel(label)
            grid.addWidget(self._labels[key], row, 0)
            grid.addWidget(field.widget, row, 1)
            field.changed.connect(self.changed)

    def __getitem__(self, key):
        return self.fields[key]

    def values(self):
        return {key: field.value() for key, field in self.fields.items()}

    def show_row(self, key, is_shown):
        """Shows or hides one of the fields."""
        self._labels[key].setVisible(is_shown)
        self.fields[key].widget.setVisible(is_shown)
