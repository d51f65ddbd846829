"""A line of advice or of trouble, with a colour at its edge; gone where there is nothing to say."""

from osculate.gui import colors
from osculate.gui.qt import Qt, QtWidgets

_STYLES = {"hint": colors.FRAME[2], "warning": colors.ORDERS[1], "error": colors.GAP}


class Message(QtWidgets.QLabel):
    """Shows a sentence as a hint, a warning or an error."""

    def __init__(self):
        super().__init__()
        self._style = None
        self.setWordWrap(True)
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.hide()

    def say(self, text, style="hint"):
        self._take_style(style)
        self.setText(text)
        self.setVisible(bool(text))

    def _take_style(self, style):
        if style != self._style:  # a style sheet costs more than a text
            self._style, color = style, _STYLES[style]
            self.setStyleSheet(f"QLabel {{ border-left: 4px solid {color}; padding: 4px 6px;"
                               f" background: {_with_alpha(color, 30)}; }}")


def _with_alpha(color, alpha):
    red, green, blue = (int(color[i:i + 2], 16) for i in (1, 3, 5))
    return f"rgba({red}, {green}, {blue}, {alpha})"
