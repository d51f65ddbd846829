"""A part of the panel that folds away under its title and stays as the user left it."""

from osculate.gui import preferences
from osculate.gui.qt import Qt, QtWidgets


class Section(QtWidgets.QWidget):
    """A title that shows and hides a widget; `key` names what is remembered."""

    def __init__(self, title, content, key, is_open):
        super().__init__()
        self._parameter = f"{key}SectionOpen"
        self.content = content
        self.header = QtWidgets.QToolButton()
        self.header.setText(title)
        self.header.setAutoRaise(True)
        self.header.setCheckable(True)
        self.header.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.header.setSizePolicy(QtWidgets.QSizePolicy.Policy.Expanding,
                                  QtWidgets.QSizePolicy.Policy.Fixed)
        layout = QtWidgets.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(2)
        layout.addWidget(self.header)
        layout.addWidget(content)
        self._open(preferences.parameters().GetBool(self._parameter, is_open))
        self.header.toggled.connect(self._toggled)

    def _open(self, is_open):
        self.header.setChecked(is_open)
        self.header.setArrowType(Qt.ArrowType.DownArrow if is_open else Qt.ArrowType.RightArrow)
        self.content.setVisible(is_open)

    def _toggled(self, is_open):
        self._open(is_open)
        preferences.parameters().SetBool(self._parameter, is_open)
