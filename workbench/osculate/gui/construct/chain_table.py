"""The edges of a chain, and what continuity each has with the next, before and now."""

from osculate.gui import resources
from osculate.gui.construct.row_table import RowTable
from osculate.gui.qt import QtGui, translate
from osculate.gui.verdict import look_of


class ChainTable(RowTable):
    """A row an edge: its name, the join to the next one as it was, and as it is."""

    def __init__(self):
        super().__init__((translate("Osculate", "Edge"), translate("Osculate", "Was"),
                          translate("Osculate", "Is")), 44)
        self.horizontalHeaderItem(1).setToolTip(translate(
            "Osculate", "The continuity of the edge with the next one"))
        self.horizontalHeaderItem(2).setToolTip(translate(
            "Osculate", "The continuity of the joined curve there"))

    def show_joins(self, result):
        """Shows the joins of a Construction (None: none), which are in the order of travel."""
        pairs = list(zip(result.input_reports, result.reports)) if result else []
        for row in range(self.rowCount()):
            reports = pairs[row] if row < len(pairs) else (None, None)
            for column, report in enumerate(reports, start=1):
                _show(self.item(row, column), report)


def _show(item, report):
    item.setIcon(resources.icon(look_of(report.order, report.verdicts).icon) if report
                 else QtGui.QIcon())
    item.setToolTip(report.headline if report else "")
