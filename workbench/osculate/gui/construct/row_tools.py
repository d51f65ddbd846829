"""The buttons below a table of rows: pick in the view, up, down, remove, and perhaps add."""

from osculate.gui import resources
from osculate.gui.qt import QtCore, QtWidgets, Signal, translate


class RowTools(QtWidgets.QWidget):
    """What they do to the rows that are marked in a RowTable."""

    pick_toggled = Signal(bool)
    removed = Signal(object)  #: numbers of rows, from 0
    moved = Signal(int, int)  #: number of a row, -1 or 1
    added = Signal()

    def __init__(self, table, pick_tip, can_add):
        super().__init__()
        self._table = table
        self.pick = _button("follow", pick_tip, checkable=True)
        self.up = _button("up", translate("Osculate", "Move the marked row up"))
        self.down = _button("down", translate("Osculate", "Move the marked row down"))
        self.remove = _button("remove", translate("Osculate", "Take the marked rows out"))
        self.add = _button("add", translate("Osculate", "Add a point by its coordinates"))
        self._can_add = can_add
        layout = QtWidgets.QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        for button in (self.pick, self.add, self.up, self.down, self.remove):
            layout.addWidget(button)
        layout.addStretch(1)
        self.pick.clicked.connect(self.pick_toggled)
        self.add.clicked.connect(self.added)
        self.remove.clicked.connect(lambda: self.removed.emit(table.marked()))
        self.up.clicked.connect(lambda: self._move(-1))
        self.down.clicked.connect(lambda: self._move(1))
        self.show_parts(False, can_add)

    def show_parts(self, has_object, can_add):
        """Rows are changed only where there is an object; points added only where none is linked.
        """
        for button in (self.up, self.down, self.remove):
            button.setVisible(has_object)
        self.add.setVisible(self._can_add and can_add)

    def _move(self, step):
        marked = self._table.marked()
        if len(marked) == 1:
            self.moved.emit(marked[0], step)
            self._table.mark(marked[0] + step)


def _button(icon, tip, checkable=False):
    button = QtWidgets.QToolButton()
    button.setIcon(resources.icon(icon))
    button.setIconSize(QtCore.QSize(16, 16))
    button.setToolTip(tip)
    button.setCheckable(checkable)
    return button
