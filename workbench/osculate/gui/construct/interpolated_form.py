"""The widgets of Interpolate."""

from osculate.features.interpolated_curve import (
    BESSEL, CLOSED, ENDS, NATURAL, SPACINGS, TANGENTS, links_of, own_tensions, tensions_of)
from osculate.gui import numbers
from osculate.gui.construct.construct_form import ConstructForm
from osculate.gui.construct.number_rows import grid_of
from osculate.gui.construct.point_table import PointTable
from osculate.gui.construct.row_tools import RowTools
from osculate.gui.construct.rows import row_of
from osculate.gui.construct.tension_row import TensionRow
from osculate.gui.construct.vector_row import VectorRow
from osculate.gui.panel.quiet import ComboBox
from osculate.gui.qt import QtWidgets, Signal, translate


class InterpolatedForm(ConstructForm):
    """The points, their tensions, the ends."""

    removed = Signal(object)  #: numbers of points, from 0
    moved = Signal(int, int)  #: number of a point, -1 or 1
    added = Signal()

    def __init__(self, preferences):
        super().__init__(translate("Osculate", "Interpolate"), "interpolate", preferences)
        self.setObjectName("OsculateInterpolatePanel")

    def content(self):
        self._obj = None
        self._make_points()
        self._make_tensions()
        self._make_ends()
        self._connect()
        self._parts = (self._grid, self.ends_row, self.start, self.end)
        return (self.table, self.tools, self.position, *self._parts)

    def show_edges(self, choice):
        self.tools.pick.setChecked(choice.awaited is not None)
        if self._obj is None:
            self.table.show_names([link.label() for link in choice.links])

    def show_parts(self, has_object):
        for part in self._parts:
            part.setVisible(has_object)
        self.tools.show_parts(has_object, can_add=not has_object)
        self.position.setVisible(False)
        if not has_object:
            self._obj = None

    def show_object(self, obj, result):
        self._obj = obj
        links = links_of(obj)
        names = ([link.label() for link in links] if links
                 else [_coordinates(point) for point in obj.Points])
        self._own = own_tensions(obj, len(names))
        self.table.show_points(names, tensions_of(obj, len(names)),
                               [own >= 0.0 for own in self._own])
        self.tools.show_parts(True, can_add=not links)
        self.tension.show_number(obj.Tension, True)
        self._show_ends(obj)
        self._show_marked()

    def reports(self, result):
        return ()

    # What is shown

    def _show_ends(self, obj):
        self.ends.setCurrentIndex(self.ends.findData(obj.Ends))
        self.spacing.setCurrentIndex(self.spacing.findData(obj.Spacing))
        has_tangents = obj.Ends == TANGENTS
        for row, vector in ((self.start, obj.StartTangent), (self.end, obj.EndTangent)):
            row.setVisible(has_tangents)
            row.findChild(VectorRow).show_vector(vector)

    def _show_marked(self):
        """The tension of the marked point, and its coordinates where it is no vertex."""
        marked = self.table.marked()
        obj = self._obj
        is_one = obj is not None and len(marked) == 1
        self.own.set_visible(is_one)
        is_free = is_one and not links_of(obj)
        self.position.setVisible(is_free)
        if not is_one:
            return
        index = marked[0]
        is_own = self._own[index] >= 0.0
        self.own.show_number(self._own[index] if is_own else obj.Tension, is_own)
        if is_free:
            self.position.show_vector(obj.Points[index])

    # Widgets

    def _make_points(self):
        self._own = []
        self.table = PointTable()
        self.tools = RowTools(self.table, translate(
            "Osculate", "Pick vertices: each click adds one or takes it out"), can_add=True)
        self.position = VectorRow(" mm")

    def _make_tensions(self):
        self.tension = TensionRow(translate("Osculate", "Tension"), translate(
            "Osculate", "Of all points without their own: 0 is the smoothest curve, a large one "
                        "nearly a polygon"), has_lock=False)
        self.own = TensionRow(translate("Osculate", "Marked"), translate(
            "Osculate", "The tension of the marked point"), has_lock=True)
        self._grid = QtWidgets.QWidget()
        grid = grid_of((self.tension, self.own))
        grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setLayout(grid)
        self.tension.lock.hide()
        self.own.set_visible(False)

    def _make_ends(self):
        self.ends = ComboBox()
        for name in ENDS:
            self.ends.addItem(_ends_name(name), name)
        self.spacing = ComboBox()
        for name in SPACINGS:
            self.spacing.addItem(_spacing_name(name), name)
        self.spacing.setToolTip(translate(
            "Osculate", "How the parameter's steps follow from the distances of the points"))
        self.ends_row = row_of(QtWidgets.QLabel(translate("Osculate", "Ends")), (self.ends, 1),
                               (self.spacing, 1))
        self.start, self.end = (row_of(QtWidgets.QLabel(name), (VectorRow(), 1)) for name in (
            translate("Osculate", "First"), translate("Osculate", "Last")))

    def _connect(self):
        self.tools.pick_toggled.connect(
            lambda is_on: self.edge_awaited.emit(0 if is_on else None))
        self.tools.removed.connect(self.removed)
        self.tools.moved.connect(self.moved)
        self.tools.added.connect(self.added)
        self.table.itemSelectionChanged.connect(self._show_marked)
        self.tension.given.connect(
            lambda _k, value, ends: self.edited.emit({"Tension": value}, ends))
        self.own.given.connect(lambda _k, value, ends: self._set_own(value, ends))
        self.own.freed.connect(lambda _k: self._set_own(-1.0, True))
        for row in (self.tension, self.own):
            row.settled.connect(self.settled)
        self.position.given.connect(self._set_point)
        self.ends.activated.connect(
            lambda index: self.edited.emit({"Ends": self.ends.itemData(index)}, True))
        self.spacing.activated.connect(lambda index: self.edited.emit(
            {"Spacing": self.spacing.itemData(index)}, True))
        for row, name in ((self.start, "StartTangent"), (self.end, "EndTangent")):
            row.findChild(VectorRow).given.connect(
                lambda vector, name=name: self.edited.emit({name: vector}, True))

    # What the user does

    def _set_own(self, value, is_settled):
        marked = self.table.marked()
        if len(marked) == 1:
            own = list(self._own)
            own[marked[0]] = value
            self.edited.emit({"Tensions": own}, is_settled)

    def _set_point(self, vector):
        marked = self.table.marked()
        if len(marked) == 1 and self._obj is not None:
            points = list(self._obj.Points)
            points[marked[0]] = vector
            self.edited.emit({"Points": points}, True)


def _coordinates(point):
    return "; ".join(numbers.number(coordinate) for coordinate in point)


def _ends_name(name):
    return {NATURAL: translate("Osculate", "Natural"),
            BESSEL: translate("Osculate", "As a parabola"),
            TANGENTS: translate("Osculate", "Given directions"),
            CLOSED: translate("Osculate", "Closed")}[name]


def _spacing_name(name):
    return {"centripetal": translate("Osculate", "Centripetal"),
            "chordal": translate("Osculate", "By distance"),
            "uniform": translate("Osculate", "Uniform")}[name]
