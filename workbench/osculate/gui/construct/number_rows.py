"""The numbers of one end: a row for each order, of the properties that hold them."""

from osculate.gui.qt import QtCore, QtWidgets, Signal


class NumberRows(QtCore.QObject):
    """NumberRows of orders 1, 2, ..., and the NumberProperties that they show and change."""

    edited = Signal(object, bool)  #: as ConstructForm.edited
    settled = Signal()

    def __init__(self, properties, rows):
        super().__init__()
        self._properties = properties
        self.rows = rows
        for row in rows:
            row.given.connect(self._given)
            row.freed.connect(self._freed)
            row.settled.connect(self.settled)

    def show_object(self, obj, order):
        """Shows the numbers up to an order; 0 for none."""
        for k, row in enumerate(self.rows, start=1):
            row.set_visible(k <= order)
            row.show_number(self._properties.number(obj, k), self._properties.is_fixed(obj, k))

    def hide(self):
        for row in self.rows:
            row.set_visible(False)

    def _given(self, k, number, is_settled):
        self.edited.emit({self._properties.number_name(k): number,
                          self._properties.fixed_name(k): True}, is_settled)

    def _freed(self, k):
        self.edited.emit({self._properties.fixed_name(k): False}, True)


def grid_of(rows):
    """A layout with the widgets of some NumberRows under each other."""
    grid = QtWidgets.QGridLayout()
    grid.setHorizontalSpacing(4)
    grid.setVerticalSpacing(2)
    for number, row in enumerate(rows):
        for column, widget in enumerate(row.widgets()):
            grid.addWidget(widget, number, column)
    grid.setColumnStretch(2, 1)
    return grid
