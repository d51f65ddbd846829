"""A label that shows part of a report as rich text, in colours that fit the widget's background."""

from osculate.gui import colors
from osculate.gui.qt import Qt, QtCore, QtGui, QtWidgets
from osculate.gui.verdict import SYMBOLS, verdict_word

_NAME = ' align="left"'
_NUMBER = ' align="right" style="white-space:nowrap"'


class ReportLabel(QtWidgets.QLabel):
    """Base of the tables; what it shows is written by `html(report)` of the class."""

    def __init__(self):
        super().__init__()
        self._report = None
        self.setWordWrap(True)
        self.setTextFormat(Qt.TextFormat.RichText)
        self.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)

    def show_report(self, report):
        self._report = report
        self.setText(self.html(report))

    def changeEvent(self, event):
        super().changeEvent(event)
        if event.type() == QtCore.QEvent.Type.PaletteChange and self._report is not None:
            self.setText(self.html(self._report))

    def html(self, report):
        raise NotImplementedError

    def is_dark(self):
        return self.palette().color(QtGui.QPalette.ColorRole.Window).lightness() < 128

    def faint(self, text):
        """Rich text in a colour between text and background."""
        return f'<span style="color:{self._mixed(0.62)}">{text}</span>'

    def verdict(self, verdict, with_word=True):
        """Rich text of a verdict: symbol, word and colour; faint where there is none."""
        if verdict is None:
            return self.faint(verdict_word(None) if with_word else "–")
        color = colors.VERDICT_TEXT[verdict][self.is_dark()]
        word = f"&nbsp;{verdict_word(verdict)}" if with_word else ""
        return f'<b style="color:{color}">{SYMBOLS[verdict]}{word}</b>'

    def table(self, heads, rows, widths):
        """A table; the first column is left-aligned, the others right. `widths` in percent."""
        lines = [self._line("th", [self.faint(head) for head in heads], widths, "")]
        for number, row in enumerate(rows):
            stripe = f' bgcolor="{self._mixed(0.06)}"' if number % 2 == 0 else ""
            lines.append(self._line("td", row, widths, stripe))
        return f'<table width="100%" cellspacing="0" cellpadding="3">{"".join(lines)}</table>'

    @staticmethod
    def _line(kind, texts, widths, stripe):
        cells = [f'<{kind} width="{width}%"{_NUMBER if column else _NAME}{stripe}>{text}</{kind}>'
                 for column, (text, width) in enumerate(zip(texts, widths))]
        return f'<tr>{"".join(cells)}</tr>'

    def _mixed(self, share):
        """"#rrggbb" of so much of the text's colour in that of the background."""
        palette = self.palette()
        text = palette.color(QtGui.QPalette.ColorRole.WindowText).getRgb()
        back = palette.color(QtGui.QPalette.ColorRole.Window).getRgb()
        return "#{:02x}{:02x}{:02x}".format(*(round(share * one + (1.0 - share) * other)
                                              for one, other in zip(text[:3], back[:3])))
