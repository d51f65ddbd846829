"""The widgets of the panel, from top to bottom."""

from osculate.gui import resources
from osculate.gui.panel.actions_bar import ActionsBar
from osculate.gui.panel.definitions_table import DefinitionsTable
from osculate.gui.panel.edges_bar import EdgesBar
from osculate.gui.panel.joins_list import JoinsList
from osculate.gui.panel.message import Message
from osculate.gui.panel.order_table import OrderTable
from osculate.gui.panel.section import Section
from osculate.gui.panel.sides_table import SidesTable
from osculate.gui.panel.tolerance_box import ToleranceBox
from osculate.gui.panel.verdict_banner import VerdictBanner
from osculate.gui.qt import QtWidgets, translate


class PanelForm(QtWidgets.QWidget):
    """Shows a JoinAnalysis; knows nothing of documents and views."""

    def __init__(self, options, preferences, with_keep):
        super().__init__()
        self.setWindowTitle(translate("Osculate", "Analyze join"))
        self.setWindowIcon(resources.icon("analyze-join"))
        self.setObjectName("OsculateJoinPanel")
        self.follow = QtWidgets.QCheckBox(translate("Osculate", "Follow the selection"))
        self.follow.setChecked(preferences.follow_selection)
        self.advice = Message()
        self.trouble = Message()
        self.warnings = Message()
        self.edges = EdgesBar(preferences.side_colors)
        self.joins = JoinsList()
        self.banner = VerdictBanner()
        self.orders = OrderTable()
        self.sides = SidesTable(preferences.side_colors)
        self.definitions = DefinitionsTable()
        self.tolerances = ToleranceBox(options)
        self.actions = ActionsBar(with_keep)
        self.sections = self._make_sections()
        self._lay_out()
        self._show_parts(has_place=False, has_report=False, has_list=False)

    def _make_sections(self):
        return [
            Section(translate("Osculate", "Both sides"), self.sides, "Sides", True),
            Section(translate("Osculate", "Definitions of G2 and G3"), self.definitions,
                    "Definitions", False),
        ]

    def _lay_out(self):
        self.tolerance_section = Section(translate("Osculate", "Tolerances"), self.tolerances,
                                         "Tolerances", False)
        layout = QtWidgets.QVBoxLayout(self)
        layout.setSpacing(8)
        for widget in (self.follow, self.advice, self.joins, self.edges, self.trouble, self.banner,
                       self.warnings, self.orders, self.actions, *self.sections,
                       self.tolerance_section):
            layout.addWidget(widget)
        layout.addStretch(1)

    def show_analysis(self, analysis):
        """Shows the current join of an analysis, or its error."""
        place, report = analysis.place, analysis.report
        has_list = len(analysis.joins) > 1
        self._show_parts(place is not None, report is not None, has_list)
        self.trouble.say(analysis.error, "error")
        if has_list:
            self.joins.show_joins(analysis.joins, place)
        if place is not None:
            self.edges.show_join(place, report, analysis.is_one_join)
        if report is not None:
            self._show_report(report)

    def _show_report(self, report):
        for part in (self.banner, self.orders, self.sides, self.definitions):
            part.show_report(report)
        self.warnings.say("\n".join(warning.sentence for warning in report.warnings), "warning")

    def _show_parts(self, has_place, has_report, has_list):
        self.edges.setVisible(has_place)
        self.joins.setVisible(has_list)
        for part in (self.banner, self.orders, self.actions, *self.sections):
            part.setVisible(has_report)
        if not has_report:
            self.warnings.say("")
