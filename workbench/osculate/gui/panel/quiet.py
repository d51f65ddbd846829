"""Widgets of a panel that scrolls: the wheel scrolls it and changes only what has the focus."""

from osculate.gui.qt import Qt, QtWidgets

_LEAST_LETTERS = 8  # of a choice, that are seen where the panel is narrow


class QuietWheel:
    """Mixed into a widget class, in front of it."""

    def wheelEvent(self, event):
        if self.hasFocus():
            super().wheelEvent(event)
        else:
            event.ignore()


class Slider(QuietWheel, QtWidgets.QSlider):
    """A horizontal slider."""

    def __init__(self, least, most):
        super().__init__(Qt.Orientation.Horizontal)
        self.setRange(least, most)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

    def show_value(self, value):
        """Moves the slider without telling anyone, unless the user holds it."""
        if not self.isSliderDown():
            blocked = self.blockSignals(True)
            self.setValue(value)
            self.blockSignals(blocked)


class SpinBox(QuietWheel, QtWidgets.QSpinBox):
    """An integer, told when it is complete."""

    def __init__(self):
        super().__init__()
        self.setKeyboardTracking(False)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)


class ComboBox(QuietWheel, QtWidgets.QComboBox):
    """A choice; where the panel is narrow its texts are cut, not the panel."""

    def __init__(self):
        super().__init__()
        self.setSizeAdjustPolicy(self.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.setMinimumContentsLength(10)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
