"""A place inside an edge, as a share of its length."""

from osculate.gui.qt import Qt, QtWidgets, Signal, translate

_STEPS = 1000  # of the slider


class PositionRow(QtWidgets.QWidget):
    """A slider and a spin box in percent."""

    given = Signal(float, bool)  #: the share, 0 to 1, and whether it is settled
    settled = Signal()           #: the slider was let go

    def __init__(self):
        super().__init__()
        self.slider = QtWidgets.QSlider(Qt.Orientation.Horizontal)
        self.slider.setRange(0, _STEPS)
        self.box = QtWidgets.QDoubleSpinBox()
        self.box.setRange(0.0, 100.0)
        self.box.setDecimals(3)
        self.box.setSingleStep(1.0)
        self.box.setSuffix(" %")
        self.box.setKeyboardTracking(False)
        self.slider.valueChanged.connect(
            lambda value: self.given.emit(value / _STEPS, not self.slider.isSliderDown()))
        self.slider.sliderReleased.connect(self.settled)
        self.box.valueChanged.connect(lambda value: self.given.emit(value / 100.0, True))
        layout = QtWidgets.QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(QtWidgets.QLabel(translate("Osculate", "Place on the edge")))
        layout.addWidget(self.slider, 1)
        layout.addWidget(self.box)

    def show_share(self, share):
        """Shows a share without telling anyone."""
        for widget, value in ((self.slider, round(share * _STEPS)), (self.box, 100.0 * share)):
            if widget is self.slider and widget.isSliderDown():
                continue
            blocked = widget.blockSignals(True)
            widget.setValue(value)
            widget.blockSignals(blocked)
