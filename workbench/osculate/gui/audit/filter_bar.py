"""Which joins of an audit the table shows."""

from osculate.audit_rows import RowFilter
from osculate.gui.audit import audit_words
from osculate.gui.panel.number_spin_box import NumberSpinBox
from osculate.gui.panel.quiet import ComboBox
from osculate.gui.qt import QtWidgets, Signal, translate

_ALL, _OUT = "all", "out"
_UNITS = {0: " mm", 1: " °"}


class FilterBar(QtWidgets.QWidget):
    """By order, and by the deviation of one order."""

    changed = Signal()

    def __init__(self):
        super().__init__()
        self.orders = ComboBox()
        self.deviations = ComboBox()
        self.least = NumberSpinBox("", 0.0, 1e9)
        self.count = QtWidgets.QLabel()
        self._shown = None  # (required, highest): what the choices are made for
        layout = QtWidgets.QGridLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(4)
        layout.addWidget(self.orders, 0, 0)
        layout.addWidget(self.count, 0, 1)
        layout.addWidget(self.deviations, 1, 0)
        layout.addWidget(self.least, 1, 1)
        layout.setColumnStretch(0, 3)
        layout.setColumnStretch(1, 2)
        self.orders.activated.connect(lambda _index: self.changed.emit())
        self.deviations.activated.connect(lambda _index: self._deviation_chosen())
        self.least.valueChanged.connect(lambda _value: self.changed.emit())

    def show_choices(self, required, highest):
        """Offers the orders up to `highest`; what was chosen stays where it can."""
        if (required, highest) == self._shown:
            return
        self._shown = required, highest
        below = translate("Osculate", "below {}")
        _fill(self.orders, [
            (translate("Osculate", "all joins"), _ALL),
            (translate("Osculate", "out of tolerance (below {})").format(
                audit_words.order_name(required)), _OUT),
            (translate("Osculate", "gaps"), 0),
            *((below.format(audit_words.order_name(order)), order)
              for order in range(1, highest + 1))])
        _fill(self.deviations, [
            (translate("Osculate", "any deviation"), None),
            *((translate("Osculate", "{} at least").format(audit_words.residual_name(order)),
               order) for order in range(highest + 1))])
        self._dress_number()

    def show_count(self, shown, total):
        self.count.setText(translate("Osculate", "{} of {}").format(f"{shown:,}", f"{total:,}"))

    def wanted(self):
        """The RowFilter that is chosen."""
        below = self.orders.currentData()
        if below == _ALL:
            below = None
        elif below == _OUT:
            below = self._shown[0]
        deviates_in = self.deviations.currentData()
        share = 1.0 if deviates_in in (None, *_UNITS) else 100.0
        return RowFilter(below, deviates_in, self.least.value() / share)

    def _deviation_chosen(self):
        self._dress_number()
        self.changed.emit()

    def _dress_number(self):
        order = self.deviations.currentData()
        self.least.setEnabled(order is not None)
        self.least.setSuffix("" if order is None else _UNITS.get(order, " %"))


def _fill(box, entries):
    """Gives a box (text, data) entries; the choice stays where it is among them."""
    data = box.currentData() if box.count() else entries[0][1]
    box.clear()
    for text, value in entries:
        box.addItem(text, value)
    values = [value for _, value in entries]
    box.setCurrentIndex(values.index(data) if data in values else 0)
