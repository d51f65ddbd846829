"""One end of a blend: its edge, where it is left, the order of contact, the free numbers."""

from osculate import MAX_ORDER
from osculate.features import beta_properties
from osculate.features.departure import INSIDE
from osculate.gui.construct.beta_row import BetaRow
from osculate.gui.construct.departure_button import DepartureButton
from osculate.gui.construct.edge_row import EdgeRow
from osculate.gui.construct.number_rows import NumberRows, grid_of
from osculate.gui.construct.order_buttons import OrderButtons
from osculate.gui.construct.position_row import PositionRow
from osculate.gui.qt import QtWidgets, Signal


class EndBox(QtWidgets.QWidget):
    """The widgets of one end; `side` is "First" or "Second", as the properties are named."""

    edited = Signal(object, bool)  #: as ConstructForm.edited
    settled = Signal()

    def __init__(self, side, number, color):
        super().__init__()
        self._side = side
        self.edge = EdgeRow(number, color)
        self.end = DepartureButton(leaves=number == 1)
        self.edge.extras.addWidget(self.end)
        self.position = PositionRow()
        self.order = OrderButtons()
        self.numbers = [BetaRow(k) for k in range(1, MAX_ORDER + 1)]
        self._rows = NumberRows(beta_properties.of_side(side), self.numbers)
        self._lay_out()
        self._connect()

    def show_edge(self, link, is_awaited):
        self.edge.show_edge(link, is_awaited)

    def show_parts(self, has_object):
        """Without an object there is only the edge to pick."""
        self.end.setVisible(has_object)
        self.order.setVisible(has_object)
        if not has_object:
            self.position.hide()
            self._rows.hide()

    def show_object(self, obj, made):
        """Shows the end of a BlendCurve; `made` is the end that it takes."""
        side = self._side
        choice, order = getattr(obj, f"{side}End"), getattr(obj, f"{side}Order")
        self.end.show_choice(choice, made)
        self.position.setVisible(choice in INSIDE)
        self.position.show_share(getattr(obj, f"{side}Position"))
        self.order.show_order(order)
        self._rows.show_object(obj, order)

    def _lay_out(self):
        layout = QtWidgets.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(4)
        for widget in (self.edge, self.position, self.order):
            layout.addWidget(widget)
        layout.addLayout(grid_of(self.numbers))

    def _connect(self):
        side = self._side
        self.end.chosen.connect(lambda end: self.edited.emit({f"{side}End": end}, True))
        self.position.given.connect(
            lambda share, ends: self.edited.emit({f"{side}Position": share}, ends))
        self.position.settled.connect(self.settled)
        self.order.chosen.connect(lambda order: self.edited.emit({f"{side}Order": order}, True))
        self._rows.edited.connect(self.edited)
        self._rows.settled.connect(self.settled)
