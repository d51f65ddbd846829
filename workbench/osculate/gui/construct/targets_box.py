"""Where an extension ends: a point, a direction, a curvature, each of them or none."""

import FreeCAD

from osculate.features.edge_link import LinkError, VertexLink
from osculate.features.extended_curve_properties import (
    CURVATURES, MAGNITUDE, NONE, POINTS, POSITION, VECTOR, VERTEX)
from osculate.gui import resources
from osculate.gui.construct.vector_row import VectorRow
from osculate.gui.panel.edges_bar import ElidedLabel
from osculate.gui.panel.number_spin_box import NumberSpinBox
from osculate.gui.panel.quiet import ComboBox
from osculate.gui.panel.toggle_button import ToggleButton
from osculate.gui.qt import QtCore, QtWidgets, Signal, translate

_LEAST_CURVATURE, _MOST_CURVATURE = 0.0, 1e9


class TargetsBox(QtWidgets.QWidget):
    """A row for each kind of target."""

    edited = Signal(object, bool)  #: as ConstructForm.edited
    pick_toggled = Signal(bool)    #: whether the next click gives the point

    def __init__(self):
        super().__init__()
        self._far = None  # the PointGeometry of the far end
        self.point = _choice(POINTS, _point_name)
        self.vertex = ElidedLabel()
        self.pick = ToggleButton()
        self.pick.setIcon(resources.icon("follow"))
        self.pick.setIconSize(QtCore.QSize(16, 16))
        self.pick.setToolTip(translate("Osculate", "Pick a vertex, or a place on an edge or a "
                                                   "face, in the 3D view"))
        self.position = VectorRow(" mm")
        self.direction = QtWidgets.QCheckBox(translate("Osculate", "in a direction"))
        self.direction.setToolTip(translate("Osculate", "The direction of the tangent at the far "
                                                        "end, as a vector of any length"))
        self.vector = VectorRow()
        self.curvature = _choice(CURVATURES, _curvature_name)
        self.magnitude = NumberSpinBox(" 1/mm", _LEAST_CURVATURE, _MOST_CURVATURE)
        self.magnitude.setSizePolicy(QtWidgets.QSizePolicy.Policy.Ignored,
                                     QtWidgets.QSizePolicy.Policy.Fixed)
        self.curvature_vector = VectorRow(unit="1/mm")
        self._lay_out()
        self._connect()

    def show_object(self, obj, result):
        """Shows the targets of an ExtendedCurve; `result` is its construction, or None."""
        if result is not None:
            self._far = result.curve.geometry(result.curve.parameter_range[1], side="left")
        self.point.setCurrentIndex(self.point.findData(obj.PointTarget))
        self.vertex.set_text(_label(obj.PointVertex))
        self.vertex.setVisible(obj.PointTarget == VERTEX)
        self.position.show_vector(obj.PointPosition)
        self.position.setVisible(obj.PointTarget == POSITION)
        self.direction.setChecked(obj.DirectionTarget)
        self.vector.show_vector(obj.Direction)
        self.vector.setVisible(obj.DirectionTarget)
        self.curvature.setCurrentIndex(self.curvature.findData(obj.CurvatureTarget))
        self.magnitude.show_value(obj.Curvature)
        self.magnitude.setVisible(obj.CurvatureTarget == MAGNITUDE)
        self.curvature_vector.show_vector(obj.CurvatureVector)
        self.curvature_vector.setVisible(obj.CurvatureTarget == VECTOR)

    def show_picking(self, is_on):
        self.pick.setChecked(is_on)

    def _lay_out(self):
        grid = QtWidgets.QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(4)
        grid.setVerticalSpacing(3)
        for row, widgets in enumerate(((self.point, self.vertex, self.pick),
                                       (self.direction,), (self.curvature, self.magnitude))):
            for column, widget in enumerate(widgets):
                spans = 1 if len(widgets) == 3 or column == 0 else 2
                grid.addWidget(widget, 2 * row, column, 1, spans)
        for row, vector in enumerate((self.position, self.vector, self.curvature_vector)):
            grid.addWidget(vector, 2 * row + 1, 0, 1, 3)
        grid.setColumnStretch(1, 1)

    def _connect(self):
        self.point.activated.connect(self._point_chosen)
        self.pick.clicked.connect(self.pick_toggled)
        self.position.given.connect(
            lambda point: self.edited.emit({"PointPosition": point}, True))
        self.direction.clicked.connect(self._direction_chosen)
        self.vector.given.connect(self._direction_given)
        self.curvature.activated.connect(self._curvature_chosen)
        self.magnitude.valueChanged.connect(
            lambda value: self.edited.emit({"Curvature": value}, True))
        self.curvature_vector.given.connect(
            lambda vector: self.edited.emit({"CurvatureVector": vector}, True))

    # What is asked for begins as it is, so that the curve does not jump.

    def _point_chosen(self, index):
        settings = {"PointTarget": POINTS[index]}
        if settings["PointTarget"] == VERTEX and not self.vertex.toolTip():
            self.point.setCurrentIndex(self.point.findData(NONE))
            self.pick_toggled.emit(True)
            return
        if settings["PointTarget"] == POSITION and self._far is not None:
            settings["PointPosition"] = FreeCAD.Vector(*self._far.point)
        self.edited.emit(settings, True)

    def _direction_chosen(self, is_on):
        settings = {"DirectionTarget": is_on}
        if is_on and self._far is not None and self._far.tangent is not None:
            settings["Direction"] = FreeCAD.Vector(*self._far.tangent)
        self.edited.emit(settings, True)

    def _curvature_chosen(self, index):
        settings = {"CurvatureTarget": CURVATURES[index]}
        if self._far is not None and self._far.curvature is not None:
            settings["Curvature"] = self._far.curvature
            settings["CurvatureVector"] = _curvature_vector(self._far)
        self.edited.emit(settings, True)

    def _direction_given(self, vector):
        if vector.Length > 0.0:  # between two coordinates that are typed it may vanish
            self.edited.emit({"Direction": vector}, True)


def _curvature_vector(geometry):
    if geometry.normal is None:
        return FreeCAD.Vector()
    return FreeCAD.Vector(*geometry.normal) * geometry.curvature


def _choice(choices, name_of):
    box = ComboBox()
    for choice in choices:
        box.addItem(name_of(choice), choice)
    return box


def _label(value):
    """What the user calls the linked vertex; empty where there is none."""
    try:
        return VertexLink.of_property(value).label()
    except LinkError:
        return ""


def _point_name(choice):
    return {NONE: translate("Osculate", "to no point"),
            VERTEX: translate("Osculate", "to the vertex"),
            POSITION: translate("Osculate", "to the point")}[choice]


def _curvature_name(choice):
    return {NONE: translate("Osculate", "of any curvature"),
            MAGNITUDE: translate("Osculate", "of curvature"),
            VECTOR: translate("Osculate", "of curvature vector")}[choice]
