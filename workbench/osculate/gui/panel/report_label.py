"""A label that shows part of a report as rich text, in colours that fit the widget's background."""

from osculate.gui import colors
from osculate.gui.qt import Qt, QtCore, QtWidgets
from osculate.gui.verdict import SYMBOLS, verdict_word

_NAME = "text-align:left"
_NUMBER = "text-align:right; white-space:nowrap"
_STRIPE = "background-color:rgba(127,127,127,0.16)"


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
        if self.isVisible():  # else it is written when it is shown
            self._write_again()

    def changeEvent(self, event):
        super().changeEvent(event)
        if event.type() in (QtCore.QEvent.Type.PaletteChange, QtCore.QEvent.Type.StyleChange):
            self._write_again()

    def showEvent(self, event):
        super().showEvent(event)
        self._write_again()  # a style sheet sets the palette just before

    def _write_again(self):
        if self._report is not None:
            self.setText(self.html(self._report))

    def html(self, report):
        raise NotImplementedError

    def is_dark(self):
        """Whether text is light on dark: style sheets tell only the colour of the text."""
        return self._text_color().lightness() > 128

    def faint(self, text):
        """Rich text that stands back."""
        red, green, blue = self._text_color().getRgb()[:3]
        return f'<span style="color:rgba({red},{green},{blue},0.65)">{text}</span>'

    def _text_color(self):
        return self.palette().color(self.foregroundRole())

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
            lines.append(self._line("td", row, widths, "" if number % 2 else _STRIPE))
        return f'<table width="100%" cellspacing="0" cellpadding="3">{"".join(lines)}</table>'

    @staticmethod
    def _line(kind, texts, widths, look):
        # Clear backgrounds keep Qt from painting the half-clear one again under each text.
        return "<tr>{}</tr>".format("".join(
            f'<{kind} width="{width}%" style="{_NUMBER if column else _NAME};{look}">'
            f'<span style="background-color:transparent">{text}</span></{kind}>'
            for column, (text, width) in enumerate(zip(texts, widths))))
