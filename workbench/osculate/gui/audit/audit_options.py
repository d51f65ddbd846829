"""How an audit judges, and what of it is drawn."""

from osculate import MAX_ORDER
from osculate.features.audit_properties import DRAWN, PAIRS
from osculate.features.tolerance_choice import CUSTOM
from osculate.features.tolerance_properties import tolerance_settings, tolerance_values_in
from osculate.gui.panel.analysis import Options
from osculate.gui.panel.number_spin_box import NumberSpinBox
from osculate.gui.panel.quiet import ComboBox, SpinBox
from osculate.gui.panel.tolerance_box import ToleranceBox
from osculate.gui.qt import QtWidgets, Signal, translate


class AuditOptions(QtWidgets.QWidget):
    """Which pairs count, what is required, and the tolerances."""

    edited = Signal(object)  #: properties to set, as a dict

    def __init__(self, options):
        super().__init__()
        self.required = SpinBox()
        self.required.setRange(0, MAX_ORDER)
        self.required.setPrefix("G")
        self.required.setToolTip(translate("Osculate", "Joins below this order are out of "
                                                       "tolerance"))
        self.pairs = ComboBox()
        for name, text in zip(PAIRS, (translate("Osculate", "all but corners"),
                                      translate("Osculate", "neighbours in a wire"),
                                      translate("Osculate", "all pairs"))):
            self.pairs.addItem(text, name)
        self.pairs.setToolTip(translate("Osculate", "Which edges at a vertex are a join"))
        self.corner = NumberSpinBox(" °", 0.0, 180.0)
        self.corner.setToolTip(translate("Osculate", "Tangents that turn by more are a corner"))
        self.touch = NumberSpinBox(" mm", 0.0, 1e6)
        self.touch.setToolTip(translate(
            "Osculate", "How far ends of edges in no wire may be apart to be a join; 0: only where "
                        "they share a vertex"))
        self.tolerances = ToleranceBox(options)
        self._lay_out()
        self._connect()

    def _lay_out(self):
        rows = QtWidgets.QFormLayout()
        rows.setVerticalSpacing(3)
        rows.addRow(translate("Osculate", "Required"), self.required)
        rows.addRow(translate("Osculate", "Joins are"), self.pairs)
        rows.addRow(translate("Osculate", "Corner from"), self.corner)
        rows.addRow(translate("Osculate", "Ends touch within"), self.touch)
        layout = QtWidgets.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addLayout(rows)
        layout.addWidget(self.tolerances)

    def _connect(self):
        self.required.valueChanged.connect(self._required_changed)
        self.pairs.activated.connect(
            lambda index: self.edited.emit({"Pairs": self.pairs.itemData(index)}))
        self.corner.valueChanged.connect(lambda value: self.edited.emit({"CornerAngle": value}))
        self.touch.valueChanged.connect(lambda value: self.edited.emit({"TouchDistance": value}))
        self.tolerances.changed.connect(self._tolerances_changed)

    def show_object(self, obj):
        """Shows the options of an Audit."""
        blocked = self.required.blockSignals(True)
        self.required.setValue(obj.Required)
        self.required.blockSignals(blocked)
        self.pairs.setCurrentIndex(PAIRS.index(obj.Pairs))
        self.corner.setEnabled(obj.Pairs == "tangent")
        self.corner.show_value(obj.CornerAngle.Value)
        self.touch.show_value(obj.TouchDistance.Value)
        if options_of(obj) != self.tolerances.options():
            self.tolerances.show_options(options_of(obj))

    def _required_changed(self, order):
        settings = {"Required": order}
        if order > self.tolerances.order.value():
            settings["OrderAsked"] = order
        self.edited.emit(settings)

    def _tolerances_changed(self, options):
        settings = {"OrderAsked": options.order, "Preset": options.preset}
        if options.preset == CUSTOM:
            settings.update(tolerance_settings(options.values))
        if options.order < self.required.value():
            settings["Required"] = options.order
        self.edited.emit(settings)


class AuditLook(QtWidgets.QWidget):
    """What of an audit is drawn."""

    edited = Signal(object)  #: properties to set, as a dict

    def __init__(self):
        super().__init__()
        self.drawn = ComboBox()
        for name, text in zip(DRAWN, (translate("Osculate", "all joins"),
                                      translate("Osculate", "those out of tolerance"),
                                      translate("Osculate", "none"))):
            self.drawn.addItem(text, name)
        self.labels = SpinBox()
        self.labels.setRange(0, 1000)
        self.labels.setToolTip(translate("Osculate", "How many joins that are out of tolerance "
                                                     "have a number, the worst first"))
        self.legend = QtWidgets.QCheckBox(translate("Osculate", "legend"))
        rows = QtWidgets.QFormLayout(self)
        rows.setContentsMargins(0, 0, 0, 0)
        rows.setVerticalSpacing(3)
        rows.addRow(translate("Osculate", "Draw"), self.drawn)
        rows.addRow(translate("Osculate", "Most numbers"), self.labels)
        rows.addRow("", self.legend)
        self.drawn.activated.connect(
            lambda index: self.edited.emit({"Drawn": self.drawn.itemData(index)}))
        self.labels.valueChanged.connect(lambda value: self.edited.emit({"MostLabels": value}))
        self.legend.clicked.connect(lambda is_on: self.edited.emit({"Legend": is_on}))

    def show_object(self, obj):
        self.drawn.setCurrentIndex(DRAWN.index(obj.Drawn))
        blocked = self.labels.blockSignals(True)
        self.labels.setValue(obj.MostLabels)
        self.labels.blockSignals(blocked)
        self.legend.setChecked(obj.Legend)


def options_of(obj):
    """The Options of an Audit."""
    return Options(obj.OrderAsked, obj.Preset, tolerance_values_in(obj))
