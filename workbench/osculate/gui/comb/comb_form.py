"""The widgets of the panel of a CurvatureComb, from top to bottom."""

import math

import numpy

from osculate import COMB_QUANTITIES
from osculate.gui import colors, comb_words, numbers
from osculate.gui.panel.quiet import ComboBox, Slider, SpinBox
from osculate.gui.panel.report_label import ReportLabel
from osculate.gui.panel.sources_form import SourcesForm
from osculate.gui.qt import QtCore, QtGui, QtWidgets, translate

_SLIDER = 200          # steps to either side
_PER_DECADE = 100.0    # of them


class CombForm(SourcesForm):
    """Shows a CurvatureComb; tells what the user changes."""

    def __init__(self):
        super().__init__(translate("Osculate", "Curvature comb"), "curvature-comb",
                         "OsculateCombPanel")
        self._obj, self._automatic = None, None  # what is shown, and its automatic scale
        self.quantity = _quantity_box()
        self.density = SpinBox()
        self.density.setRange(2, 1000)
        self.density.setToolTip(translate("Osculate", "Teeth of each Bézier segment"))
        self.scale = Slider(-_SLIDER, _SLIDER)
        self.scale.setToolTip(translate("Osculate", "Length of the teeth; Ctrl and the mouse wheel "
                                                    "in the 3D view do the same"))
        self.scale_text = QtWidgets.QLabel()
        self.automatic = QtWidgets.QCheckBox(translate("Osculate", "follows the curves"))
        self.automatic.setToolTip(translate("Osculate", "The teeth keep their share of the size of "
                                                        "the curves when these change"))
        self.flip = QtWidgets.QCheckBox(translate("Osculate", "on the other side"))
        self.table = CombTable()
        self._add_rows()
        self._connect()

    def _add_rows(self):
        rows = self.rows
        rows.addRow(translate("Osculate", "Show"), self.quantity)
        rows.addRow(translate("Osculate", "Density"), self.density)
        rows.addRow(translate("Osculate", "Scale"), self.scale)
        rows.addRow("", self.scale_text)
        rows.addRow("", self.automatic)
        rows.addRow("", self.flip)
        self.boxes = self.switches(translate("Osculate", "Draw"), {
            "Teeth": translate("Osculate", "teeth"),
            "Envelope": translate("Osculate", "envelope"),
            "Marks": translate("Osculate", "peaks, inflections, vertices"),
            "Legend": translate("Osculate", "legend")})
        rows.addRow(self.table)

    def _connect(self):
        self.quantity.activated.connect(
            lambda index: self.edited.emit({"Quantity": COMB_QUANTITIES[index]}, True))
        self.density.valueChanged.connect(
            lambda value: self.edited.emit({"Density": value}, True))
        self.scale.valueChanged.connect(self._scaled)
        self.scale.sliderReleased.connect(self.settled)
        self.automatic.clicked.connect(self._automatic_clicked)
        self.flip.clicked.connect(lambda: self.edited.emit(self.scaled_by(-1.0), True))

    def show_object(self, obj, automatic):
        """Shows a CurvatureComb; `automatic` is the length in mm that a tooth of value 1 has
        without its Factor, or None.
        """
        super().show_object(obj)
        self._obj, self._automatic = obj, automatic
        self.quantity.setCurrentIndex(COMB_QUANTITIES.index(obj.Quantity))
        _silently(self.density, obj.Density)
        self._show_scale(obj)
        for name, box in self.boxes.items():
            box.setChecked(getattr(obj, name))
        comb = obj.Proxy.result
        self.table.setVisible(comb is not None)
        if comb is not None:
            self.table.show_report(comb)

    def _show_scale(self, obj):
        has_scale = self._automatic is not None
        for widget in (self.scale, self.automatic, self.flip):
            widget.setEnabled(has_scale)
        self.automatic.setChecked(obj.AutoScale)
        if has_scale:
            factor = self._factor()
            self.scale.show_value(round(_PER_DECADE * math.log10(max(abs(factor), 1e-9))))
            self.flip.setChecked(factor < 0.0)
            self.scale_text.setText(comb_words.scale_text(obj.Quantity, self._automatic * factor))
        else:
            self.scale_text.setText(translate("Osculate", "zero everywhere"))

    # The scale, as so many times the automatic one

    def scaled_by(self, factor):
        """The properties that make the teeth longer by a factor."""
        return self._settings(self._factor() * factor) if self._automatic is not None else {}

    def _factor(self):
        return self._obj.Factor if self._obj.AutoScale else self._obj.Scale / self._automatic

    def _settings(self, factor):
        if self._obj.AutoScale:
            return {"Factor": factor}
        return {"Scale": factor * self._automatic}

    def _scaled(self, position):
        factor = math.copysign(10.0 ** (position / _PER_DECADE), self._factor())
        self.edited.emit(self._settings(factor), not self.scale.isSliderDown())

    def _automatic_clicked(self, is_on):
        factor = self._factor()  # the teeth stay as they are
        settings = {"Factor": factor} if is_on else {"Scale": factor * self._automatic}
        self.edited.emit({"AutoScale": is_on, **settings}, True)


class CombTable(ReportLabel):
    """The numbers of an osculate.Comb."""

    def html(self, report):
        comb = report
        curvature = _largest(comb.curvature)
        kinds = [mark.kind for mark in comb.marks]
        rows = [(translate("Osculate", "largest curvature"),
                 numbers.quantity(curvature, "mm⁻¹")),
                (translate("Osculate", "smallest radius"),
                 numbers.quantity(1.0 / curvature if curvature else None, "mm")),
                (translate("Osculate", "largest torsion"),
                 numbers.quantity(_largest(comb.torsion), "mm⁻¹")),
                (translate("Osculate", "inflections"), str(kinds.count("inflection"))),
                (translate("Osculate", "vertices"), str(kinds.count("vertex"))),
                (translate("Osculate", "length"),
                 numbers.quantity(float(comb.lengths.sum()), "mm"))]
        if "cusp" in kinds:
            rows.append((translate("Osculate", "cusps"), str(kinds.count("cusp"))))
        return self.table(("", ""), rows, (60, 40))


def _largest(values):
    return float(numpy.nanmax(numpy.abs(values), initial=0.0))


def _quantity_box():
    box = ComboBox()
    for quantity in COMB_QUANTITIES:
        box.addItem(_swatch(colors.QUANTITIES[quantity]), comb_words.title_of(quantity))
    return box


def _swatch(color):
    picture = QtGui.QPixmap(QtCore.QSize(14, 14))
    picture.fill(QtGui.QColor(color))
    return QtGui.QIcon(picture)


def _silently(box, value):
    blocked = box.blockSignals(True)
    box.setValue(value)
    box.blockSignals(blocked)
