"""What can be done with the reports: copy, save, keep as an object of the document."""

from osculate.gui import resources
from osculate.gui.qt import Qt, QtCore, QtGui, QtWidgets, Signal, translate


class ActionsBar(QtWidgets.QWidget):
    """Buttons; the panel does what they say."""

    copy_requested = Signal(str)  #: "text", "json" or "csv"
    save_requested = Signal()
    keep_requested = Signal()

    def __init__(self, with_keep):
        super().__init__()
        self.copy = self._button("copy", translate("Osculate", "Copy"))
        self.copy.setPopupMode(QtWidgets.QToolButton.ToolButtonPopupMode.MenuButtonPopup)
        self.copy.setToolTip(translate("Osculate", "Copy the report as text"))
        self.copy.clicked.connect(lambda: self.copy_requested.emit("text"))
        self.copy.setMenu(self._copy_menu())
        self.save = self._button("save", translate("Osculate", "Save…"))
        self.save.setToolTip(translate("Osculate", "Save all joins as CSV or JSON"))
        self.save.clicked.connect(self.save_requested)
        layout = QtWidgets.QGridLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(4)
        layout.addWidget(self.copy, 0, 0)
        layout.addWidget(self.save, 0, 1)
        if with_keep:
            layout.addWidget(self._keep_button(), 1, 0, 1, 2)

    def _keep_button(self):
        self.keep = QtWidgets.QPushButton(resources.icon("keep"),
                                          translate("Osculate", "Keep as object"))
        self.keep.setToolTip(translate("Osculate", "Add a check of this join to the document; "
                                                   "it follows every edit"))
        self.keep.clicked.connect(self.keep_requested)
        return self.keep

    def _copy_menu(self):
        menu = QtWidgets.QMenu(self)
        for kind, label in (("text", translate("Osculate", "Text (this join)")),
                            ("json", translate("Osculate", "JSON (all joins)")),
                            ("csv", translate("Osculate", "CSV (all joins)"))):
            action = QtGui.QAction(label, menu)
            action.triggered.connect(lambda _checked=False, kind=kind:
                                     self.copy_requested.emit(kind))
            menu.addAction(action)
        return menu

    @staticmethod
    def _button(icon, text):
        button = QtWidgets.QToolButton()
        button.setIcon(resources.icon(icon))
        button.setIconSize(QtCore.QSize(18, 18))
        button.setText(text)
        button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        button.setSizePolicy(QtWidgets.QSizePolicy.Policy.Expanding,
                             QtWidgets.QSizePolicy.Policy.Fixed)
        return button
