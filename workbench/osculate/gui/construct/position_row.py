"""A place inside an edge, as a share of its length."""

from osculate.gui.panel.number_spin_box import NumberSpinBox
from osculate.gui.panel.quiet import Slider
from osculate.gui.qt import QtWidgets, Signal, translate

_STEPS = 1000  # of the slider
_WIDEST = "00.0000 %"  # what has room in the spin box


class PositionRow(QtWidgets.QWidget):
    """A slider and a spin box in percent."""

    given = Signal(float, bool)  #: the share, 0 to 1, and whether it is settled
    settled = Signal()           #: the slider was let go

    def __init__(self, name=None):
        """name: None for that of a place on an edge; empty for none."""
        super().__init__()
        self.slider = Slider(0, _STEPS)
        self.box = NumberSpinBox(" %", 0.0, 100.0)
        self.box.setMinimumWidth(self.box.fontMetrics().horizontalAdvance(_WIDEST) + 28)
        self.slider.valueChanged.connect(
            lambda value: self.given.emit(value / _STEPS, not self.slider.isSliderDown()))
        self.slider.sliderReleased.connect(self.settled)
        self.box.valueChanged.connect(lambda value: self.given.emit(value / 100.0, True))
        layout = QtWidgets.QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        if name is None:
            name = translate("Osculate", "Place on the edge")
        if name:
            layout.addWidget(QtWidgets.QLabel(name))
        layout.addWidget(self.slider, 1)
        layout.addWidget(self.box)

    def show_share(self, share):
        """Shows a share without telling anyone."""
        self.box.show_value(100.0 * share)
        self.slider.show_value(round(share * _STEPS))
