"""The widgets of the panel of a Probe, from top to bottom."""

from osculate.features.probe import radius_of
from osculate.gui import comb_words, numbers
from osculate.gui.construct.position_row import PositionRow
from osculate.gui.panel.number_spin_box import NumberSpinBox
from osculate.gui.panel.report_label import ReportLabel
from osculate.gui.panel.sources_form import SourcesForm
from osculate.gui.panel.toggle_button import ToggleButton
from osculate.gui.probe_words import kind_name, missing_lines, value_text
from osculate.gui.qt import Qt, QtWidgets, Signal, translate


class ProbeForm(SourcesForm):
    """Shows a Probe; tells what the user changes."""

    special_wanted = Signal(bool)  #: the next special point (True), or that before

    def __init__(self):
        super().__init__(translate("Osculate", "Probe"), "probe", "OsculateProbePanel")
        self._probe = self._reading = None
        self.position = PositionRow("")
        self.arc_length = NumberSpinBox(" mm", 0.0)
        self.arc_length.setToolTip(translate("Osculate", "Arc length from the start of the edges"))
        self.parameter = NumberSpinBox()
        self.parameter.setToolTip(translate("Osculate", "The parameter of the edge, in its own "
                                                        "direction"))
        self.edge = QtWidgets.QLabel()
        self.special = QtWidgets.QLabel()
        self.before = _arrow(Qt.ArrowType.LeftArrow,
                             translate("Osculate", "To the special point before"))
        self.after = _arrow(Qt.ArrowType.RightArrow,
                            translate("Osculate", "To the next special point"))
        self.snap = _toggle(translate("Osculate", "Snap"), translate(
            "Osculate", "The mouse takes the point to ends, joins, knots, inflections and vertices "
                        "that are near; Shift does the opposite"))
        self.snap.setChecked(True)
        self.follow = _toggle(translate("Osculate", "Follow the mouse"), translate(
            "Osculate", "The point follows the mouse along the edges until a click; without this "
                        "it is dragged, or brought by a double-click"))
        self._add_rows()
        self._connect()

    def _add_rows(self):
        rows = self.rows
        rows.addRow(translate("Osculate", "Position"), self.position)
        rows.addRow(translate("Osculate", "Arc length"), self.arc_length)
        rows.addRow(translate("Osculate", "Parameter"), _row(self.parameter, self.edge, wide=0))
        rows.addRow(translate("Osculate", "Special"), _row(self.before, self.after, self.special))
        rows.addRow(translate("Osculate", "Mouse"), _row(self.snap, self.follow))
        self.boxes = self.switches("", {
            "Frame": translate("Osculate", "frame t, n, b"),
            "OsculatingPlane": translate("Osculate", "osculating plane"),
            "Circle": translate("Osculate", "osculating circle"),
            "NormalPlane": translate("Osculate", "normal plane"),
            "DeCasteljau": translate("Osculate", "de Casteljau"),
            "RectifyingPlane": translate("Osculate", "rectifying plane"),
            "ReadOut": translate("Osculate", "values at the point"),
            "Marks": translate("Osculate", "special points"),
            "Legend": translate("Osculate", "legend")}, columns=2)
        self.table, self.missing = ReadingTable(), QtWidgets.QLabel()
        self.missing.setWordWrap(True)
        rows.addRow(self.table)
        rows.addRow(self.missing)

    def _connect(self):
        self.position.given.connect(lambda share, is_settled: self.edited.emit(
            {"Position": share}, is_settled))
        self.position.settled.connect(self.settled)
        self.arc_length.valueChanged.connect(lambda s: self._go_to(s))
        self.parameter.valueChanged.connect(lambda parameter: self._go_to(
            self._probe.arc_length_of(self._reading.sides[-1].curve, parameter)))
        self.before.clicked.connect(lambda: self.special_wanted.emit(False))
        self.after.clicked.connect(lambda: self.special_wanted.emit(True))

    def _go_to(self, s):
        self.edited.emit({"Position": s / self._probe.length}, True)

    def show_object(self, obj):
        super().show_object(obj)
        for name, box in self.boxes.items():
            box.setChecked(getattr(obj, name))
        reading = obj.Proxy.result
        self.table.setVisible(reading is not None)
        if reading is not None:
            self._probe, self._reading = obj.Proxy.probe, reading
            self._show_reading(reading)

    def _show_reading(self, reading):
        side = reading.sides[-1]
        self.position.show_share(reading.share)
        self.arc_length.setMaximum(self._probe.length)
        self.arc_length.show_value(reading.s)
        self.parameter.show_value(side.parameter)
        self.edge.setText(translate("Osculate", "on edge {}").format(side.curve + 1)
                          if len(self._probe.curves) > 1 else "")
        self.special.setText(", ".join(map(kind_name, reading.kinds)))
        for button, is_forward in ((self.before, False), (self.after, True)):
            button.setEnabled(self._probe.next_special(reading.s, is_forward) is not None)
        self.table.show_report((reading, self._probe.size))
        missing = missing_lines(reading)
        self.missing.setText("\n".join(missing))
        self.missing.setVisible(bool(missing))


class ReadingTable(ReportLabel):
    """The numbers of a ProbeReading, of both sides where they differ."""

    def html(self, report):
        reading, size = report
        geometries = [side.geometry for side in reading.sides]
        rows = [(f"κ {self.faint(translate('Osculate', 'curvature'))}",
                 *self._texts(geometries, "curvature", size)),
                (f"R {self.faint(translate('Osculate', 'radius'))}",
                 *(numbers.quantity(radius_of(geometry), "mm") for geometry in geometries)),
                (f"τ {self.faint(translate('Osculate', 'torsion'))}",
                 *self._texts(geometries, "torsion", size))]
        rows += [(comb_words.SYMBOLS[quantity], *self._texts(geometries, quantity, size))
                 for quantity in ("curvature_rate", "curvature_rate2", "torsion_rate")]
        if len(geometries) == 1:
            return self.table(("", ""), rows, (45, 55))
        heads = "", translate("Osculate", "before"), translate("Osculate", "after")
        return self.table(heads, rows, (30, 35, 35))

    @staticmethod
    def _texts(geometries, quantity, size):
        return [value_text(geometry, quantity, size) for geometry in geometries]


def _row(*widgets, wide=None):
    """Widgets side by side; `wide`: the number of that which takes the room that is left."""
    layout = QtWidgets.QHBoxLayout()
    for number, widget in enumerate(widgets):
        layout.addWidget(widget, int(number == wide))
    if wide is None:
        layout.addStretch(1)
    return layout


def _arrow(arrow, tip):
    button = QtWidgets.QToolButton()
    button.setArrowType(arrow)
    button.setToolTip(tip)
    return button


def _toggle(text, tip):
    button = ToggleButton()
    button.setText(text)
    button.setToolTip(tip)
    return button
