"""The number of a side in a disk of its colour, as in the 3D view."""

from osculate.gui.qt import Qt, QtWidgets


def side_tag(number, color):
    """A label with the number; `color` is "#rrggbb"."""
    tag = QtWidgets.QLabel(str(number))
    tag.setAlignment(Qt.AlignmentFlag.AlignCenter)
    tag.setFixedSize(20, 20)
    tag.setStyleSheet(f"background: {color}; color: white; border-radius: 10px;"
                      " font-weight: bold;")
    return tag
