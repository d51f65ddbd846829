"""The contact of two solids: the order, and by how much each order is missed."""

from osculate.gui import numbers
from osculate.gui.panel.report_label import ReportLabel
from osculate.gui.qt import translate


class ContactLabel(ReportLabel):
    """Shows an osculate.ContactReport."""

    def html(self, report):
        return f"{self._headline(report)}{self._table(report) if report.meets else ''}"

    def _headline(self, report):
        faces = report.faces
        if not report.meets:
            return translate("Osculate", "<b>No faces meet.</b> Face {} and face {} come nearest: "
                                         "their points are up to {} apart.").format(
                *faces, numbers.quantity(report.gap_mm, "mm"))
        text = translate("Osculate", "<b>C{}</b>: face {} meets face {}").format(
            report.order, *faces)
        if report.overlaps:
            text += "<br>" + translate("Osculate", "Both solids lie on the same side of it.")
        return f"<p>{text}</p>"

    def _table(self, report):
        heads = (translate("Osculate", "Order"), translate("Osculate", "In space"),
                 translate("Osculate", "With weights"), "")
        rows = [(f"<b>C{order}</b>", _residual(report.residuals_mm, order),
                 _residual(report.homogeneous_residuals_mm, order),
                 self.verdict("pass" if order <= report.order else "fail"))
                for order in range(max(map(len, (report.residuals_mm,
                                                 report.homogeneous_residuals_mm))))]
        return self.table(heads, rows, (16, 28, 28, 28))


def _residual(residuals, order):
    return numbers.quantity(residuals[order], "mm", 3) if order < len(residuals) else ""
