"""The widgets of Blend."""

from osculate import MAX_ORDER
from osculate.features import beta_properties
from osculate.features.blend_curve import MOST_DEGREE, SIDES
from osculate.gui import resources
from osculate.gui.construct.construct_form import ConstructForm
from osculate.gui.construct.end_box import EndBox
from osculate.gui.construct.fairness_box import FairnessBox
from osculate.gui.panel.quiet import SpinBox
from osculate.gui.qt import QtWidgets, translate


class BlendForm(ConstructForm):
    """Both ends, the degree, what chooses the free numbers."""

    def __init__(self, preferences):
        super().__init__(translate("Osculate", "Blend"), "blend", preferences)
        self.setObjectName("OsculateBlendPanel")

    def content(self):
        self._degree, self._orders, self._least = 0, {}, 1
        colors = self.preferences.side_colors
        self.ends = [EndBox(side, number, color)
                     for number, (side, color) in enumerate(zip(SIDES, colors), start=1)]
        for index, end in enumerate(self.ends):
            end.edited.connect(self._end_edited)
            end.settled.connect(self.settled)
            end.edge.pick_toggled.connect(
                lambda is_on, index=index: self.edge_awaited.emit(index if is_on else None))
        self._make_choices()
        self.choices = self._choices_grid()
        return (*self.ends, self.choices)

    def show_parts(self, has_object):
        for end in self.ends:
            end.show_parts(has_object)
        self.choices.setVisible(has_object)

    def _make_choices(self):
        self.degree = SpinBox()
        self.degree.setMaximum(MOST_DEGREE)
        self.degree.valueChanged.connect(self._degree_changed)
        self.fairness = FairnessBox()
        self.fairness.chosen.connect(lambda name: self.edited.emit({"Fairness": name}, True))
        self.symmetric = QtWidgets.QCheckBox(translate("Osculate", "Symmetric"))
        self.symmetric.setToolTip(translate("Osculate", "Chosen numbers are equal at both ends"))
        self.symmetric.clicked.connect(
            lambda is_on: self.edited.emit({"Symmetric": is_on}, True))
        self.combs = QtWidgets.QCheckBox(translate("Osculate", "Curvature comb"))
        self.combs.setToolTip(translate("Osculate", "Combs of the blend and of both edges, in one "
                                                    "scale"))
        self.fair = QtWidgets.QPushButton(resources.icon("fair"), translate("Osculate", "Fair"))
        self.fair.setToolTip(translate("Osculate", "Let all numbers be chosen: the fairest curve"))
        self.fair.clicked.connect(self._make_fair)

    def _choices_grid(self):
        grid = QtWidgets.QWidget()
        layout = QtWidgets.QGridLayout(grid)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(QtWidgets.QLabel(translate("Osculate", "Degree")), 0, 0)
        layout.addWidget(self.degree, 0, 1)
        layout.addWidget(self.fairness, 0, 2)
        layout.addWidget(self.symmetric, 1, 0, 1, 2)
        layout.addWidget(self.fair, 1, 2)
        layout.addWidget(self.combs, 2, 0, 1, 3)
        layout.setColumnStretch(2, 1)
        return grid

    def show_edges(self, choice):
        for index, (end, link) in enumerate(zip(self.ends, choice.links)):
            end.show_edge(link, choice.awaited == index)

    def _end_edited(self, settings, is_settled):
        """Orders that outgrow the degree take the least one again."""
        orders = {**self._orders, **{name: value for name, value in settings.items()
                                     if name in self._orders}}
        if 0 < self._degree <= sum(orders.values()):
            settings = {**settings, "Degree": 0}
        self.edited.emit(settings, is_settled)

    def show_object(self, obj, result):
        made = (obj.EndsMade or "end-start").split("-")
        for end, name in zip(self.ends, made):
            end.show_object(obj, name)
        self._show_degree(obj)
        self.fairness.show_choice(obj.Fairness)
        self.symmetric.setChecked(obj.Symmetric)

    def _show_degree(self, obj):
        """The least degree is shown as a number, and stays the least when orders change."""
        self._degree = obj.Degree
        self._orders = {f"{side}Order": getattr(obj, f"{side}Order") for side in SIDES}
        self._least = least = sum(self._orders.values()) + 1
        blocked = self.degree.blockSignals(True)
        self.degree.setMinimum(min(least, obj.Degree or least))  # one that is too low is seen
        self.degree.setValue(obj.Degree or least)
        self.degree.blockSignals(blocked)
        self.degree.setToolTip(translate("Osculate", "At least {}, what the orders need; further "
                                                     "poles make the curve fairer").format(least))

    def _degree_changed(self, degree):
        self.edited.emit({"Degree": 0 if degree == self._least else degree}, True)

    def _make_fair(self):
        settings = {beta_properties.fixed_name(side, k): False
                    for side in SIDES for k in range(1, MAX_ORDER + 1)}
        if self.fairness.currentData() == "none":
            settings["Fairness"] = "mvc"
        self.edited.emit(settings, True)
