"""Buttons G0 to G4, and a menu for the orders above, of which one is pressed."""

from osculate import MAX_ORDER
from osculate.gui.panel.toggle_button import ToggleButton
from osculate.gui.qt import QtGui, QtWidgets, Signal, translate

_PLAIN = 4  # the highest order with a button of its own


class OrderButtons(QtWidgets.QWidget):
    """Chooses an order of contact."""

    chosen = Signal(int)

    def __init__(self):
        super().__init__()
        self._letter = "G"
        self.buttons = [self._button(order) for order in range(_PLAIN + 1)]
        self.more = ToggleButton()
        self.more.setPopupMode(QtWidgets.QToolButton.ToolButtonPopupMode.InstantPopup)
        self.more.setToolTip(translate("Osculate", "Higher orders"))
        self.more.setMenu(self._menu())
        layout = QtWidgets.QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(2)
        for button in (*self.buttons, self.more):
            layout.addWidget(button)
        layout.addStretch(1)
        self.show_order(0)

    def show_letter(self, letter):
        """Names the orders of geometric continuity, "G", or of parametric one, "C"."""
        self._letter = letter
        for order, button in enumerate(self.buttons):
            button.setText(f"{letter}{order}")
        for order, action in enumerate(self.more.menu().actions(), start=_PLAIN + 1):
            action.setText(f"{letter}{order}")

    def show_order(self, order):
        for number, button in enumerate(self.buttons):
            button.setChecked(number == order)
        self.more.setChecked(order > _PLAIN)
        self.more.setText(f"{self._letter}{order}" if order > _PLAIN else "…")

    def _button(self, order):
        button = ToggleButton()
        button.setText(f"G{order}")
        button.setMinimumWidth(34)
        button.setToolTip(_meaning(order))
        button.clicked.connect(lambda: self._choose(order))
        return button

    def _menu(self):
        menu = QtWidgets.QMenu(self)
        for order in range(_PLAIN + 1, MAX_ORDER + 1):
            action = QtGui.QAction(f"G{order}", menu)
            action.triggered.connect(lambda _checked=False, order=order: self._choose(order))
            menu.addAction(action)
        return menu

    def _choose(self, order):
        self.show_order(order)
        self.chosen.emit(order)


def _meaning(order):
    return (translate("Osculate", "Meets the edge"),
            translate("Osculate", "Has its tangent"),
            translate("Osculate", "Has its curvature"),
            translate("Osculate", "Has its rate of curvature and torsion"),
            translate("Osculate", "Has its second rate of curvature and rate of torsion"))[order]
