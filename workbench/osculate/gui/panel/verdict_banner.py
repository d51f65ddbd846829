"""The verdict, large and plain."""

from osculate.gui import numbers, resources
from osculate.gui.panel.report_label import ReportLabel
from osculate.gui.qt import Qt, QtWidgets, translate
from osculate.gui.verdict import look_of, missing_text

_TILE = 60


class VerdictBanner(QtWidgets.QWidget):
    """The tile of the order, what is missed, the tolerance, and the parametric order."""

    def __init__(self, tile_size=_TILE):
        super().__init__()
        self._tile_size = tile_size
        self.tile = QtWidgets.QLabel()
        self.text = _VerdictText()
        layout = QtWidgets.QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(10)
        layout.addWidget(self.tile, 0, Qt.AlignmentFlag.AlignTop)
        layout.addWidget(self.text, 1)

    def show_report(self, report):
        look = look_of(report.order, report.verdicts)
        self.tile.setPixmap(resources.icon(look.icon).pixmap(self._tile_size, self._tile_size))
        self.text.show_report(report)


class _VerdictText(ReportLabel):
    def html(self, report):
        missing = missing_text(report.order, report.verdicts, report.residuals)
        name = look_of(report.order, report.verdicts).name
        return (f'<div style="font-size:large"><b>{name}</b>{", " if missing else ""}{missing}'
                f"</div><div>{self.faint(_conditions(report))}</div>")


def _conditions(report):
    following = report.order + 1
    if following < len(report.tolerances):
        allowed = numbers.residual(following, report.tolerances[following])
        first = translate("Osculate", "tolerance {} ({})").format(allowed, report.preset)
    else:
        first = translate("Osculate", "all orders asked for pass ({})").format(report.preset)
    return f"{first}<br>" + _parametric(report.parametric_order)


def _parametric(order):
    if order < 0:
        return translate("Osculate", "not continuous in the curves' parameters")
    return translate("Osculate", "C{} in the curves' own parameters").format(order)
