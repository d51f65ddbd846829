"""What other systems would say: every definition of G2 and G3 with its verdict."""

from osculate.gui import numbers
from osculate.gui.panel.report_label import ReportLabel
from osculate.gui.qt import translate


class DefinitionsTable(ReportLabel):
    """The sentence why the definitions disagree, then one row for each."""

    def html(self, report):
        rows = [self._row(name, detail) for name, detail in report.definition_details.items()]
        heads = (translate("Osculate", "Definition"), translate("Osculate", "Value"), "")
        table = self.table(heads, rows, (68, 20, 12))
        reason = f"<p><i>{report.disagreement}</i></p>" if report.disagreement else ""
        return reason + table

    def _row(self, name, detail):
        title = name.capitalize().replace("-", " ")
        words = f"<b>{title}</b> {self.faint(detail.who)}<br>{self.faint(detail.meaning)}"
        return words, _value(detail), self.verdict(detail.verdict, with_word=False)


def _value(detail):
    if detail.value is None:
        return numbers.MISSING
    if detail.unit == "deg":
        return numbers.number(detail.value, 3) + "°"
    return numbers.quantity(100.0 * detail.value, "%", 3)
