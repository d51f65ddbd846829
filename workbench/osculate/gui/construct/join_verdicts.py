"""The verdicts of the joins that a construction made, live."""

from osculate.gui import preferences
from osculate.gui.panel.order_table import OrderTable
from osculate.gui.panel.section import Section
from osculate.gui.panel.side_tag import side_tag
from osculate.gui.panel.verdict_banner import VerdictBanner
from osculate.gui.qt import Qt, QtWidgets, translate

_TILE = 40


class JoinVerdicts(QtWidgets.QWidget):
    """A banner for each join, and the tables of their orders to fold out."""

    def __init__(self):
        super().__init__()
        self.joins = []
        self._tables = QtWidgets.QWidget()
        self._tables_layout = _column(self._tables)
        self.section = Section(translate("Osculate", "Deviations at the joins"), self._tables,
                               "Deviations", False)
        self._banners_layout = _column(self)
        self._banners_layout.addWidget(self.section)

    def show_reports(self, reports):
        for number in range(len(self.joins), len(reports)):
            self._add(number)
        for join, report in zip(self.joins, reports):
            join.show_report(report)
        for number, join in enumerate(self.joins):
            join.set_visible(number < len(reports))

    def _add(self, number):
        join = _Join(number)
        self.joins.append(join)
        self._banners_layout.insertWidget(number, join.head)
        self._tables_layout.addWidget(join.table_name)
        self._tables_layout.addWidget(join.orders)


class _Join:
    """The widgets of one join."""

    def __init__(self, number):
        colors = preferences.load().side_colors
        self.banner = VerdictBanner(_TILE)
        self.orders = OrderTable()
        self.table_name = side_tag(number + 1, colors[number % 2])
        self.head = QtWidgets.QWidget()
        layout = QtWidgets.QHBoxLayout(self.head)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(side_tag(number + 1, colors[number % 2]), 0, Qt.AlignmentFlag.AlignTop)
        layout.addWidget(self.banner, 1)

    def show_report(self, report):
        self.banner.show_report(report)
        self.orders.show_report(report)

    def set_visible(self, is_visible):
        for widget in (self.head, self.table_name, self.orders):
            widget.setVisible(is_visible)


def _column(widget):
    layout = QtWidgets.QVBoxLayout(widget)
    layout.setContentsMargins(0, 0, 0, 0)
    layout.setSpacing(4)
    return layout
