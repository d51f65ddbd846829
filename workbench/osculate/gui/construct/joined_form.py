"""The widgets of Join."""

from osculate.features.joined_curve import in_words
from osculate.gui import numbers
from osculate.gui.construct.chain_table import ChainTable
from osculate.gui.construct.construct_form import ConstructForm
from osculate.gui.construct.row_tools import RowTools
from osculate.gui.construct.rows import row_of
from osculate.gui.panel.number_spin_box import NumberSpinBox
from osculate.gui.qt import QtWidgets, Signal, translate

_MOST_BANNERS = 2  # verdicts of more joins stand in the table alone


class JoinedForm(ConstructForm):
    """The edges with the joins between them, the tolerance, what the curve is made of."""

    removed = Signal(object)    #: numbers of edges, from 0
    moved = Signal(int, int)    #: number of an edge, -1 or 1

    def __init__(self, preferences):
        super().__init__(translate("Osculate", "Join"), "join", preferences)
        self.setObjectName("OsculateJoinPanel")

    def content(self):
        self._links = []
        self.table = ChainTable()
        self.tools = RowTools(self.table, translate(
            "Osculate", "Pick edges: each click adds one or takes it out"), can_add=False)
        self.tolerance = NumberSpinBox(" mm", 0.0)
        self.tolerance.setToolTip(translate(
            "Osculate", "How far the curve may leave the edges to close gaps and to have fewer "
                        "knots; 0: not at all"))
        self.summary = QtWidgets.QLabel()
        self.summary.setWordWrap(True)
        self._tolerance_row = row_of(QtWidgets.QLabel(translate("Osculate", "Tolerance")),
                                     (self.tolerance, 1))
        self._connect()
        return self.table, self.tools, self._tolerance_row, self.summary

    def _connect(self):
        self.tools.pick_toggled.connect(
            lambda is_on: self.edge_awaited.emit(0 if is_on else None))
        self.tools.removed.connect(self.removed)
        self.tools.moved.connect(self.moved)
        self.tolerance.valueChanged.connect(
            lambda value: self.edited.emit({"Tolerance": value}, True))

    def show_edges(self, choice):
        self._links = choice.links
        self.table.show_names([link.label() for link in choice.links])
        self.tools.pick.setChecked(choice.awaited is not None)

    def show_parts(self, has_object):
        for part in (self._tolerance_row, self.summary):
            part.setVisible(has_object)
        self.tools.show_parts(has_object, can_add=False)

    def show_object(self, obj, result):
        self.tolerance.show_value(obj.Tolerance.Value)
        self.table.show_joins(result)
        self.summary.setVisible(result is not None)
        if result is not None:
            self.summary.setText(_summary(result))

    def show_outcome(self, result, error, energies):
        super().show_outcome(result, error, energies)
        if result is not None:
            self.warnings.say("\n".join(in_words(warning, self._links)
                                        for warning in result.warnings), "warning")

    def reports(self, result):
        return result.reports if len(result.reports) <= _MOST_BANNERS else ()


def _summary(result):
    """e.g. "Degree 5, 12 spans, knots of multiplicity 2 to 5; leaves the edges by 3·10⁻⁴ mm"."""
    curve = result.curve
    inner = curve.multiplicities.tolist()[1:-1]
    knots = (translate("Osculate", "inner knots of multiplicity {}").format(_range(inner)) if inner
             else translate("Osculate", "no inner knots"))
    kind = translate("Osculate", "periodic") if curve.is_periodic else ""
    parts = [translate("Osculate", "Degree {}").format(curve.degree), kind,
             translate("Osculate", "{} spans").format(len(inner) + 1), knots]
    return "{}. {}".format(
        ", ".join(filter(None, parts)),
        translate("Osculate", "It leaves the edges by at most {}.").format(
            numbers.quantity(result.max_displacement_mm, "mm", 3)))


def _range(values):
    least, most = min(values), max(values)
    return str(least) if least == most else translate("Osculate", "{} to {}").format(least, most)
