"""The table of orders: by how much each deviates, what is allowed, and the verdict."""

from osculate.features.join_check import continuity_name
from osculate.gui import numbers
from osculate.gui.panel.report_label import ReportLabel
from osculate.gui.qt import translate


class OrderTable(ReportLabel):
    """One row for each order from 0."""

    def html(self, report):
        heads = (translate("Osculate", "Order"), translate("Osculate", "Deviation"),
                 translate("Osculate", "Tolerance"), "")
        rows = [self._row(report, order) for order in range(len(report.verdicts))]
        return self.table(heads, rows, (32, 24, 22, 22))

    def _row(self, report, order):
        return (f"<b>{continuity_name(order)}</b> {self.faint(order_word(order))}",
                _deviation(report, order),
                self.faint(numbers.residual(order, report.tolerances[order])),
                self.verdict(report.verdicts[order]))


def _deviation(report, order):
    """The residual; "≈ 0" where it is within what double coordinates carry, and where that is too
    much to decide, the most that it can be.
    """
    residual, uncertainty = report.residuals[order], report.uncertainties[order]
    if residual is None or uncertainty is None:
        return numbers.residual(order, residual)
    if report.verdicts[order] == "undecided":
        return "&lt; " + numbers.residual(order, residual + uncertainty, 2)
    if residual > uncertainty:
        return numbers.residual(order, residual)
    return "≈ " + numbers.residual(order, 0.0)


def order_word(order):
    """What an order compares."""
    words = (translate("Osculate", "position"), translate("Osculate", "tangent"),
             translate("Osculate", "curvature"))
    return words[order] if order < len(words) else ""
