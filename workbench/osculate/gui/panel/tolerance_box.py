"""Which tolerances count: a preset or own values, and up to which order joins are analysed."""

from dataclasses import astuple

from osculate import Tolerances
from osculate.features.tolerance_choice import CUSTOM, PRESETS, ToleranceValues, values_of
from osculate.gui.panel.analysis import Options
from osculate.gui.panel.tolerance_spin_box import ToleranceSpinBox
from osculate.gui.qt import QtWidgets, Signal, translate

_PERCENT = (1.0, 1.0, 100.0, 100.0, 100.0)  # shown = factor * value, for the orders 0 to 4


class ToleranceBox(QtWidgets.QWidget):
    """Preset, order and five values; changing a value makes the tolerances the user's own."""

    changed = Signal(object)  #: Options

    def __init__(self, options):
        super().__init__()
        self.preset = QtWidgets.QComboBox()
        self.preset.addItems([*PRESETS, CUSTOM])
        self.order = QtWidgets.QSpinBox()
        self.order.setRange(0, 8)
        self.order.setPrefix("G")
        self.values = [ToleranceSpinBox(suffix) for suffix in (" mm", " °", " %", " %", " %")]
        self.source = QtWidgets.QLabel()
        self.source.setWordWrap(True)
        self._lay_out()
        self.show_options(options)
        self.preset.currentTextChanged.connect(self._preset_chosen)
        self.order.valueChanged.connect(self._emit)
        for box in self.values:
            box.valueChanged.connect(self._value_chosen)

    def _lay_out(self):
        layout = QtWidgets.QFormLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setVerticalSpacing(3)
        layout.addRow(translate("Osculate", "Preset"), self.preset)
        layout.addRow(self.source)
        layout.addRow(translate("Osculate", "Up to order"), self.order)
        labels = (translate("Osculate", "G0 gap"), translate("Osculate", "G1 angle"),
                  translate("Osculate", "G2 relative"), translate("Osculate", "G3 relative"),
                  translate("Osculate", "G4 and above"))
        for label, box in zip(labels, self.values):
            layout.addRow(label, box)

    def options(self):
        values = ToleranceValues(*(box.value() / factor
                                   for box, factor in zip(self.values, _PERCENT)))
        return Options(self.order.value(), self.preset.currentText(), values)

    def show_options(self, options):
        """Shows Options without telling anyone."""
        self._silently(self.preset.setCurrentText, options.preset)
        self._silently(self.order.setValue, options.order)
        self._show_values(options.values if options.preset == CUSTOM
                          else values_of(options.preset))
        self._show_source(options.preset)

    def _preset_chosen(self, preset):
        if preset != CUSTOM:
            self._show_values(values_of(preset))
        self._show_source(preset)
        self._emit()

    def _value_chosen(self):
        self._silently(self.preset.setCurrentText, CUSTOM)
        self._show_source(CUSTOM)
        self._emit()

    def _show_values(self, values):
        for box, value, factor in zip(self.values, astuple(values), _PERCENT):
            self._silently(box.setValue, value * factor)

    def _show_source(self, preset):
        self.source.setText(_source_of(preset))

    def _emit(self):
        self.changed.emit(self.options())

    @staticmethod
    def _silently(setter, value):
        widget = setter.__self__
        blocked = widget.blockSignals(True)
        setter(value)
        widget.blockSignals(blocked)


def _source_of(preset):
    """Where the numbers of a preset are from."""
    for known in Tolerances.presets():
        if known.name == preset:
            borrowed = translate("Osculate", " From Osculate: {}.").format(known.borrowed)
            return known.source + "." + (borrowed if known.borrowed else "")
    return translate("Osculate", "Your own values.")
