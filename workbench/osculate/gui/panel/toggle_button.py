"""A button that is pressed or not, and shows it."""

from osculate.gui.qt import QtWidgets

#: FreeCAD's own style sheets, dark ones first of all, draw pressed and other buttons alike.
_STYLE = ("QToolButton:checked { background: palette(highlight); color: palette(highlighted-text);"
          " border: 1px solid palette(highlight); border-radius: 3px; }")


class ToggleButton(QtWidgets.QToolButton):
    """A checkable tool button in the colour of a selection where it is checked."""

    def __init__(self):
        super().__init__()
        self.setCheckable(True)
        self.setStyleSheet(_STYLE)
