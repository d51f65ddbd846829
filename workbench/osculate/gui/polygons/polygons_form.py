"""The widgets of the panel of ControlPolygons, from top to bottom."""

import numpy

from osculate.features.control_polygons import DERIVATIVES, DIFFERENCES, PLAIN
from osculate.gui.panel.quiet import ComboBox
from osculate.gui.panel.report_label import ReportLabel
from osculate.gui.panel.sources_form import SourcesForm
from osculate.gui.qt import translate


class PolygonsForm(SourcesForm):
    """Shows a ControlPolygons; tells what the user changes."""

    def __init__(self):
        super().__init__(translate("Osculate", "Control polygons"), "control-polygons",
                         "OsculatePolygonsPanel")
        self.boxes = self.switches(translate("Osculate", "Draw"), {
            "Weights": translate("Osculate", "weights of rational segments"),
            "FirstDifferences": translate("Osculate", "first differences Δb"),
            "SecondDifferences": translate("Osculate", "second differences Δ²b"),
            "Legend": translate("Osculate", "legend")})
        self.scaling = ComboBox()
        self.scaling.addItem(translate("Osculate", "as they are"), PLAIN)
        self.scaling.addItem(translate("Osculate", "as derivatives: n Δb, n (n−1) Δ²b"),
                             DERIVATIVES)
        self.scaling.setToolTip(translate(
            "Osculate", "As derivatives they are the poles of the derivatives of each segment of "
                        "degree n over [0, 1], drawn shorter; rational segments have none"))
        self.scaling.activated.connect(
            lambda index: self.edited.emit({"DifferenceScale": DIFFERENCES[index]}, True))
        self.rows.addRow(translate("Osculate", "Differences"), self.scaling)
        self.table = PolygonsTable()
        self.rows.addRow(self.table)

    def show_object(self, obj):
        super().show_object(obj)
        for name, box in self.boxes.items():
            box.setChecked(getattr(obj, name))
        self.scaling.setCurrentIndex(DIFFERENCES.index(obj.DifferenceScale))
        self.scaling.setEnabled(obj.FirstDifferences or obj.SecondDifferences)
        polygons = obj.Proxy.result
        self.table.setVisible(polygons is not None)
        if polygons is not None:
            self.table.show_report(polygons)


class PolygonsTable(ReportLabel):
    """How many segments there are of each degree."""

    def html(self, report):
        rows = []
        for degree in numpy.unique(report.degrees).tolist():
            for is_rational, kind in ((False, translate("Osculate", "polynomial")),
                                      (True, translate("Osculate", "rational"))):
                count = int(((report.degrees == degree)
                             & (report.is_rational == is_rational)).sum())
                if count:
                    rows.append((translate("Osculate", "degree {}, {}").format(degree, kind),
                                 str(count), str(count * (degree + 1))))
        heads = ("", translate("Osculate", "segments"), translate("Osculate", "poles"))
        return self.table(heads, rows, (50, 25, 25))
