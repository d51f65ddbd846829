"""What chooses the numbers that are free."""

from osculate.features.blend_curve import FAIRNESS
from osculate.gui.panel.quiet import ComboBox
from osculate.gui.qt import Signal, translate


class FairnessBox(ComboBox):
    """A choice of blend_curve.FAIRNESS."""

    chosen = Signal(str)

    def __init__(self):
        super().__init__()
        for name in FAIRNESS:
            self.addItem(_name(name), name)
        self.activated.connect(lambda index: self.chosen.emit(self.itemData(index)))

    def show_choice(self, name):
        self.setCurrentIndex(self.findData(name))


def _name(name):
    return {"mvc": translate("Osculate", "Even curvature"),
            "bending": translate("Osculate", "Least bending"),
            "none": translate("Osculate", "Nothing chosen")}[name]
