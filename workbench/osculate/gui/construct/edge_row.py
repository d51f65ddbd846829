"""One edge of a construction: its number, its name, and a button to pick another one."""

from osculate.gui import resources
from osculate.gui.panel.edges_bar import ElidedLabel
from osculate.gui.panel.side_tag import side_tag
from osculate.gui.panel.toggle_button import ToggleButton
from osculate.gui.qt import QtCore, QtWidgets, Signal, translate


class EdgeRow(QtWidgets.QWidget):
    """A row; `role` says what becomes of the edge, and what a construction adds at the end of the
    row goes into `extras`.
    """

    pick_toggled = Signal(bool)

    def __init__(self, number, color, role=""):
        super().__init__()
        self.tag = side_tag(number, color)
        self.name = ElidedLabel()
        self.role = QtWidgets.QLabel(role)
        self.role.setVisible(bool(role))
        self.pick = ToggleButton()
        self.pick.setIcon(resources.icon("follow"))
        self.pick.setIconSize(QtCore.QSize(16, 16))
        self.pick.setToolTip(translate("Osculate", "Pick an edge in the 3D view or in the tree"))
        self.pick.clicked.connect(self.pick_toggled)
        self.extras = QtWidgets.QHBoxLayout()
        self.extras.setSpacing(4)
        layout = QtWidgets.QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(6)
        layout.addWidget(self.tag)
        layout.addWidget(self.name, 1)
        layout.addWidget(self.role)
        layout.addWidget(self.pick)
        layout.addLayout(self.extras)

    def show_edge(self, link, is_awaited):
        """Shows an EdgeLink (None: none yet), and whether the next click gives it."""
        empty = (translate("Osculate", "pick an edge") if is_awaited
                 else translate("Osculate", "no edge"))
        self.name.set_text(link.label() if link else empty)
        self.name.setEnabled(link is not None)
        self.pick.setChecked(is_awaited)
