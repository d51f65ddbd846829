"""A button that says at which end a construction meets an edge, and takes the other one."""

from osculate.features.departure import CHOICES, FLIPPED, INSIDE, NEAREST
from osculate.gui.qt import QtGui, QtWidgets, Signal, translate

_LEAVING = {"end": "→|", "start": "|←", "inside-forward": "→·", "inside-backward": "·←"}
_ARRIVING = {"start": "|→", "end": "←|", "inside-forward": "←·", "inside-backward": "·→"}
_WIDTH = 92


class DepartureButton(QtWidgets.QToolButton):
    """A click flips; the menu offers all choices."""

    chosen = Signal(str)  #: of departure.CHOICES

    def __init__(self, leaves, choices=CHOICES):
        super().__init__()
        self._arrows = _LEAVING if leaves else _ARRIVING
        self._made = "end"
        self.setPopupMode(QtWidgets.QToolButton.ToolButtonPopupMode.MenuButtonPopup)
        self.setMinimumWidth(_WIDTH)
        self.setToolTip(translate("Osculate", "Take the other end, or the other direction"))
        self.actions_ = {choice: self._action(choice) for choice in choices}
        menu = QtWidgets.QMenu(self)
        for action in self.actions_.values():
            menu.addAction(action)
        self.setMenu(menu)
        self.clicked.connect(lambda: self.chosen.emit(FLIPPED[self._made]))

    def show_choice(self, choice, made):
        """Shows what was chosen; `made` is the end that was taken where it is the nearest."""
        self._made = made if choice == NEAREST else choice
        for name, action in self.actions_.items():
            action.setChecked(name == choice)
        self.setText(f"{_word(self._made)}  {self._arrows[self._made]}")

    def _action(self, choice):
        action = QtGui.QAction(_name(choice), self)
        action.setCheckable(True)
        action.triggered.connect(lambda: self.chosen.emit(choice))
        return action


def _word(made):
    if made in INSIDE:
        return translate("Osculate", "inside")
    return translate("Osculate", "end") if made == "end" else translate("Osculate", "start")


def _name(choice):
    return {"nearest": translate("Osculate", "The end that lies nearest"),
            "start": translate("Osculate", "The start of the edge"),
            "end": translate("Osculate", "The end of the edge"),
            "inside-forward": translate("Osculate", "Inside, along the edge"),
            "inside-backward": translate("Osculate", "Inside, against the edge")}[choice]
