"""A degree, or the least that can."""

from osculate.features.blend_curve import MOST_DEGREE
from osculate.gui.panel.quiet import SpinBox
from osculate.gui.qt import translate


class DegreeBox(SpinBox):
    """0 stands for the least degree, which is shown."""

    def __init__(self):
        super().__init__()
        self.setRange(0, MOST_DEGREE)
        self.show_degree(0, MOST_DEGREE)
        self.setFixedWidth(self.fontMetrics().horizontalAdvance(self.text()) + 44)

    def show_degree(self, wanted, made):
        """Shows the degree wanted, 0 for the least, and that of the curve."""
        self.setSpecialValueText(translate("Osculate", "least ({})").format(made))
        blocked = self.blockSignals(True)
        self.setValue(wanted)
        self.blockSignals(blocked)
