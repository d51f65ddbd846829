"""The widgets of Extend."""

from osculate import MAX_ORDER
from osculate.features.edge_link import EdgeLink
from osculate.features.extended_curve_properties import (
    BETA, CONTINUATIONS, GEOMETRIC, NATURAL, NUMBERS, PARAMETRIC, REPARAMETRISED, TANGENTIAL,
    beta_numbers, tangential_numbers)
from osculate.gui import resources
from osculate.gui.construct.beta_row import BetaRow
from osculate.gui.construct.construct_form import ConstructForm
from osculate.gui.construct.degree_box import DegreeBox
from osculate.gui.construct.departure_button import DepartureButton
from osculate.gui.construct.edge_row import EdgeRow
from osculate.gui.construct.fairness_box import FairnessBox
from osculate.gui.construct.length_rows import LengthRow, ParameterRow, TangentialRow
from osculate.gui.construct.number_rows import NumberRows, grid_of
from osculate.gui.construct.order_buttons import OrderButtons
from osculate.gui.construct.targets_box import TargetsBox
from osculate.gui.construct.rows import row_of
from osculate.gui.panel.quiet import ComboBox
from osculate.gui.panel.section import Section
from osculate.gui.qt import Qt, QtWidgets, translate


class ExtendForm(ConstructForm):
    """The end, how it is continued, how far, and the numbers that are left."""

    def __init__(self, preferences):
        super().__init__(translate("Osculate", "Extend"), "extend", preferences)
        self.setObjectName("OsculateExtendPanel")

    def content(self):
        self.edge = EdgeRow(1, self.preferences.side_colors[0])
        self.end = DepartureButton(leaves=True, choices=("end", "start"))
        self.edge.extras.addWidget(self.end)
        self._make_contact()
        self._make_numbers()
        self._make_choices()
        self.targets = TargetsBox()
        self.target_section = Section(translate("Osculate", "Target"), self.targets, "Target", True)
        self.number_section = Section(translate("Osculate", "Numbers"), self._numbers_row(),
                                      "Numbers", False)
        self._connect()
        self._choices = self._choices_row()
        self._parts = (self._contact_row(), self._grid, self.target_section, self.number_section,
                       self._choices, row_of((self.fair, 1), self.include))
        return self.edge, *self._parts

    def show_parts(self, has_object):
        self.end.setVisible(has_object)
        for part in self._parts:
            part.setVisible(has_object)

    def show_edges(self, choice):
        self.edge.show_edge(choice.links[0], choice.awaited == 0)

    def show_object(self, obj, result):
        continuation = obj.Continuation
        is_natural = continuation == NATURAL
        self.end.show_choice(obj.End, obj.End)
        self.continuation.setCurrentIndex(CONTINUATIONS.index(continuation))
        self.order.show_letter("C" if continuation in (PARAMETRIC, REPARAMETRISED) else "G")
        self.order.show_order(obj.Order)
        self._show_numbers(obj, result)
        self.degree.show_degree(obj.Degree, obj.CurveDegree)
        self.fairness.show_choice(obj.Fairness)
        self._show_free(obj.FreeNumbers)
        self.targets.show_object(obj, result)
        self.include.setChecked(obj.IncludeSource)
        for part in (self.target_section, self._choices, self.fair):
            part.setVisible(not is_natural)
        self.number_section.setVisible(continuation == GEOMETRIC and obj.Order > 0)

    def _show_numbers(self, obj, result):
        if result is not None:
            self.length.scale = scale = _source_length(obj)
            for row in self.tangential.rows:
                row.scale = scale
        self.parameter.set_visible(obj.Continuation == REPARAMETRISED)
        self.parameter.show_number(obj.Parameter, True)
        self.length.show_number(obj.WantedLength.Value or self.length.scale, obj.WantedLengthFixed)
        order = obj.Order if obj.Continuation == GEOMETRIC else 0
        self.numbers.setCurrentIndex(NUMBERS.index(obj.Numbers))
        self.beta.show_object(obj, order if obj.Numbers == BETA else 0)
        self.tangential.show_object(obj, order if obj.Numbers == TANGENTIAL else 0)

    def _show_free(self, count):
        """How many numbers nothing fixes, so that fairness chose them."""
        fair = translate("Osculate", "Fair")
        self.fair.setText(translate("Osculate", "{} ({} free)").format(fair, count)
                          if count else fair)
        self.fair.setToolTip(
            translate("Osculate", "Let all numbers be chosen: the fairest curve") + "\n" +
            translate("Osculate", "Nothing fixes {} numbers; fairness chose them").format(count))

    # Widgets

    def _make_contact(self):
        self.order = OrderButtons()
        self.continuation = ComboBox()
        for name in CONTINUATIONS:
            self.continuation.addItem(_continuation_name(name), name)
            self.continuation.setItemData(self.continuation.count() - 1, _meaning(name),
                                          Qt.ItemDataRole.ToolTipRole)

    def _make_numbers(self):
        self.parameter, self.length = ParameterRow(), LengthRow()
        orders = range(1, MAX_ORDER + 1)
        self.beta = NumberRows(beta_numbers, [BetaRow(k) for k in orders])
        self.tangential = NumberRows(tangential_numbers, [TangentialRow(k) for k in orders])
        self._grid = QtWidgets.QWidget()
        grid = grid_of([self.parameter, self.length, *self.beta.rows, *self.tangential.rows])
        grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setLayout(grid)
        self.numbers = ComboBox()
        for name in NUMBERS:
            self.numbers.addItem(_numbers_name(name), name)

    def _make_choices(self):
        self.degree = DegreeBox()
        self.fairness = FairnessBox()
        self.fair = QtWidgets.QPushButton(resources.icon("fair"), "")
        self.include = QtWidgets.QCheckBox(translate("Osculate", "Together with the edge"))
        self.include.setToolTip(translate("Osculate", "One wire of the edge and its continuation, "
                                                      "as a sweep takes it"))

    def _contact_row(self):
        widget = QtWidgets.QWidget()
        layout = QtWidgets.QVBoxLayout(widget)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(4)
        layout.addWidget(self.order)
        layout.addWidget(self.continuation)
        return widget

    def _numbers_row(self):
        return row_of(QtWidgets.QLabel(translate("Osculate", "given as")), (self.numbers, 1))

    def _choices_row(self):
        return row_of(QtWidgets.QLabel(translate("Osculate", "Degree")), self.degree,
                      (self.fairness, 1))

    # What the user does

    def _connect(self):
        self.edge.pick_toggled.connect(
            lambda is_on: self.edge_awaited.emit(0 if is_on else None))
        self.end.chosen.connect(lambda end: self._step(End=end))
        self.order.chosen.connect(lambda order: self._step(Order=order))
        self.continuation.activated.connect(
            lambda index: self._step(Continuation=CONTINUATIONS[index]))
        self.parameter.given.connect(
            lambda _, number, is_settled: self.edited.emit({"Parameter": number}, is_settled))
        self.length.given.connect(lambda _, number, is_settled: self.edited.emit(
            {"WantedLength": number, "WantedLengthFixed": True}, is_settled))
        self.length.freed.connect(lambda _: self._step(WantedLengthFixed=False))
        self.numbers.activated.connect(lambda index: self._step(Numbers=NUMBERS[index]))
        self.degree.valueChanged.connect(lambda degree: self._step(Degree=degree))
        self.fairness.chosen.connect(lambda name: self._step(Fairness=name))
        self.fair.clicked.connect(self._make_fair)
        self.include.clicked.connect(lambda is_on: self._step(IncludeSource=is_on))
        for rows in (self.beta, self.tangential, self.targets):
            rows.edited.connect(self.edited)
        for rows in (self.parameter, self.length, self.beta, self.tangential):
            rows.settled.connect(self.settled)

    def _step(self, **settings):
        self.edited.emit(settings, True)

    def _make_fair(self):
        settings = {**beta_numbers.freed(), **tangential_numbers.freed()}
        if self.fairness.currentData() == "none":
            settings["Fairness"] = "mvc"
        self._step(**settings)


def _source_length(obj):
    """The length of the edge in mm, > 0: the object was just made from it."""
    return EdgeLink.of_property(obj.Source).resolve().Length


def _continuation_name(name):
    return {GEOMETRIC: translate("Osculate", "The shape goes on (G)"),
            PARAMETRIC: translate("Osculate", "The parameter goes on too (C)"),
            REPARAMETRISED: translate("Osculate", "Likewise, up to a parameter"),
            NATURAL: translate("Osculate", "The curve itself goes on")}[name]


def _meaning(name):
    return {GEOMETRIC: translate("Osculate", "Geometric continuity of the order chosen; all "
                                             "numbers are free"),
            PARAMETRIC: translate("Osculate", "Derivatives by the edge's own parameter, up to the "
                                              "order chosen"),
            REPARAMETRISED: translate("Osculate", "Of the parametric continuation over 0 to 1 the "
                                                  "part up to a parameter, by de Casteljau"),
            NATURAL: translate("Osculate", "The same polynomial or rational curve beyond its end: "
                                           "a circle stays this circle")}[name]


def _numbers_name(name):
    return {BETA: translate("Osculate", "β, speeds as shares of the chord"),
            TANGENTIAL: translate("Osculate", "C, tangential coordinates of poles")}[name]
