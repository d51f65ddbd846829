"""The widgets of the panel that edits the control net of a solid."""

from osculate.features import control_net
from osculate.features.control_net import MOST_DEGREE, NetError
from osculate.gui.construct.rows import row_of
from osculate.gui.construct.step_buttons import StepButtons, flat_button
from osculate.gui.panel.quiet import SpinBox
from osculate.gui.qt import QtWidgets, Signal, translate
from osculate.gui.solid_panel.net_table import NetTable
from osculate.gui.solid_panel.solid_form import SolidForm


class NetForm(SolidForm):
    """Degree, table, its tools, steps."""

    degree_wanted = Signal(int)

    def __init__(self, title):
        self.table = NetTable()
        self.degree = SpinBox()
        self.degree.setToolTip(translate("Osculate", "Raising the degree keeps the solid and gives "
                                                     "it more points"))
        self._make_buttons()
        steps = StepButtons()
        self.back, self.forward, self.show_steps = steps.back, steps.forward, steps.show_steps
        super().__init__(title, "solid-points", self._first_row(), self.table)
        self.column.insertWidget(self.column.count() - 1, steps)
        self.setObjectName("OsculateNetPanel")
        self.degree.valueChanged.connect(self.degree_wanted)

    def show_object(self, obj, value):
        """Shows a BezierSolid, and its value if it has one."""
        points, weights = list(obj.Points), list(obj.Weights)
        try:
            degree = control_net.degree_of(len(points))
        except NetError:
            return  # from a script: the trouble says so, and the table stays
        fourth = list(obj.FourthCoordinates)
        count = len(points)
        if len(weights) in (0, count) and len(fourth) in (0, count):
            self.table.show_net(degree, points, weights, fourth)
        self._show_degree(degree, value is not None)
        if value is not None:
            self.show_values([value])
        else:
            self._show_wrong(points, weights, fourth)

    def _show_degree(self, degree, can_be_raised):
        blocked = self.degree.blockSignals(True)
        self.degree.setRange(degree, MOST_DEGREE)
        self.degree.setValue(degree)
        self.degree.setEnabled(can_be_raised)
        self.degree.blockSignals(blocked)

    def _show_wrong(self, points, weights, fourth):
        try:
            control_net.value_of(points, weights, fourth)
        except NetError as error:
            if error.row is not None:
                self.table.show_wrong(error.row, error.column)

    def _make_buttons(self):
        self.copy = flat_button("copy", translate("Osculate", "Copy the table, for a spreadsheet"))
        self.paste = flat_button("paste", translate(
            "Osculate", "Paste a table: x y z in each row, with a weight or not, with indices "
                        "i j k l in front or not"))
        self.open = flat_button("open", translate(
            "Osculate", "Read a table from a text or CSV file"))

    def _first_row(self):
        space = QtWidgets.QWidget()
        return row_of(QtWidgets.QLabel(translate("Osculate", "Degree")), self.degree, (space, 1),
                      self.copy, self.paste, self.open)
