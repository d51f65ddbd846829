"""The widgets of Match."""

from osculate import MAX_ORDER
from osculate.features.departure import INSIDE
from osculate.features.matched_curve import CHANGED_CHOICES, beta_numbers
from osculate.gui import numbers, resources
from osculate.gui.construct.beta_row import BetaRow
from osculate.gui.construct.construct_form import ConstructForm
from osculate.gui.construct.degree_box import DegreeBox
from osculate.gui.construct.departure_button import DepartureButton
from osculate.gui.construct.edge_row import EdgeRow
from osculate.gui.construct.number_rows import NumberRows, grid_of
from osculate.gui.construct.order_buttons import OrderButtons
from osculate.gui.construct.position_row import PositionRow
from osculate.gui.construct.rows import row_of
from osculate.gui.panel.quiet import SpinBox
from osculate.gui.panel.section import Section
from osculate.gui.qt import QtCore, QtWidgets, Signal, translate

_MOST_SPANS, _LEAST_WIDTH = 1000000, 70


class MatchForm(ConstructForm):
    """Both edges, the orders at the join and at the far end, how much of the edge may change."""

    swapped = Signal()

    def __init__(self, preferences):
        super().__init__(translate("Osculate", "Match"), "match", preferences)
        self.setObjectName("OsculateMatchPanel")

    def content(self):
        self._far_report = None
        self._make_edges()
        self._make_orders()
        self._make_choices()
        self._connect()
        self._parts = (self._orders_row(), self._keep_row(), self._choices_row(), self.section,
                       self.displacement, self.hide_original)
        return self.reference, self.position, self.changed, *self._parts

    def show_parts(self, has_object):
        for part in (*self._parts, self.reference_end, self.changed_end):
            part.setVisible(has_object)
        if not has_object:
            self.position.hide()

    def show_edges(self, choice):
        for index, row in enumerate((self.reference, self.changed)):
            row.show_edge(choice.links[index], choice.awaited == index)

    def show_object(self, obj, result):
        made = (obj.EndsMade or "end-start").split("-")
        self.reference_end.show_choice(obj.ReferenceEnd, made[0])
        self.changed_end.show_choice(obj.ChangedEnd, made[1])
        self.position.setVisible(obj.ReferenceEnd in INSIDE)
        self.position.show_share(obj.ReferencePosition)
        self.order.show_order(obj.Order)
        self.keep.show_order(obj.Keep)
        self.degree.show_degree(obj.Degree, obj.CurveDegree)
        self._show_spans(obj.Spans)
        self.section.setVisible(obj.Order > 0)
        self.beta.show_object(obj, obj.Order)
        self.hide_original.setChecked(obj.HideOriginal)
        self.displacement.setVisible(result is not None)
        if result is not None:
            self._far_report = obj.Proxy.far_report
            self._show_displacement(result.max_displacement_mm)

    def reports(self, result):
        return [report for report in (result.reports[0], self._far_report) if report]

    def _show_spans(self, spans):
        blocked = self.spans.blockSignals(True)
        self.spans.setValue(spans)
        self.spans.blockSignals(blocked)

    def _show_displacement(self, value):
        text = (translate("Osculate", "It meets the reference already") if value == 0.0 else
                translate("Osculate", "No point moves farther than {}").format(
                    f"<b>{numbers.quantity(value, 'mm')}</b>"))
        self.displacement.setText(text)

    # Widgets

    def _make_edges(self):
        first, second = self.preferences.side_colors
        self.reference = EdgeRow(1, first, translate("Osculate", "stays"))
        self.reference_end = DepartureButton(leaves=True)
        self.reference.extras.addWidget(self.reference_end)
        self.position = PositionRow()
        self.changed = EdgeRow(2, second, translate("Osculate", "changes"))
        self.changed_end = DepartureButton(leaves=False, choices=CHANGED_CHOICES)
        self.changed.extras.addWidget(self.changed_end)

    def _make_orders(self):
        self.order, self.keep = OrderButtons(), OrderButtons()
        self.keep.show_letter("C")
        self.swap = QtWidgets.QToolButton()
        self.swap.setIcon(resources.icon("swap"))
        self.swap.setIconSize(QtCore.QSize(16, 16))
        self.swap.setToolTip(translate("Osculate", "Swap the edges: the other one is changed"))

    def _make_choices(self):
        self.degree = DegreeBox()
        self.spans = SpinBox()
        self.spans.setRange(0, _MOST_SPANS)
        self.spans.setMinimumWidth(_LEAST_WIDTH)
        self.spans.setSizePolicy(QtWidgets.QSizePolicy.Policy.Ignored,
                                 QtWidgets.QSizePolicy.Policy.Fixed)
        self.spans.setSpecialValueText(translate("Osculate", "as needed"))
        self.spans.setToolTip(translate("Osculate", "How many spans may change, from the join; "
                                                    "more of them let each point move less"))
        self.beta = NumberRows(beta_numbers, [BetaRow(k) for k in range(1, MAX_ORDER + 1)])
        rows = QtWidgets.QWidget()
        grid = grid_of(self.beta.rows)
        grid.setContentsMargins(0, 0, 0, 0)
        rows.setLayout(grid)
        self.section = Section(translate("Osculate", "Numbers"), rows, "MatchNumbers", False)
        self.displacement = QtWidgets.QLabel()
        self.displacement.setWordWrap(True)
        self.hide_original = QtWidgets.QCheckBox(translate("Osculate", "Hide the edge as it was"))

    def _orders_row(self):
        return row_of((self.order, 1), self.swap)

    def _keep_row(self):
        name = QtWidgets.QLabel(translate("Osculate", "Far end keeps"))
        name.setToolTip(translate("Osculate", "Up to which derivative nothing changes at the other "
                                              "end: contact there up to this order stays"))
        return row_of(name, (self.keep, 1))

    def _choices_row(self):
        return row_of(QtWidgets.QLabel(translate("Osculate", "Degree")), self.degree,
                      QtWidgets.QLabel(translate("Osculate", "Spans")), (self.spans, 1))

    # What the user does

    def _connect(self):
        for index, row in enumerate((self.reference, self.changed)):
            row.pick_toggled.connect(
                lambda is_on, index=index: self.edge_awaited.emit(index if is_on else None))
        self.reference_end.chosen.connect(lambda end: self._step(ReferenceEnd=end))
        self.changed_end.chosen.connect(lambda end: self._step(ChangedEnd=end))
        self.position.given.connect(lambda share, is_settled: self.edited.emit(
            {"ReferencePosition": share}, is_settled))
        self.position.settled.connect(self.settled)
        self.order.chosen.connect(lambda order: self._step(Order=order))
        self.keep.chosen.connect(lambda order: self._step(Keep=order))
        self.swap.clicked.connect(self.swapped)
        self.degree.valueChanged.connect(lambda degree: self._step(Degree=degree))
        self.spans.valueChanged.connect(lambda count: self._step(Spans=count))
        self.beta.edited.connect(self.edited)
        self.beta.settled.connect(self.settled)
        self.hide_original.clicked.connect(lambda is_on: self._step(HideOriginal=is_on))

    def _step(self, **settings):
        self.edited.emit(settings, True)
