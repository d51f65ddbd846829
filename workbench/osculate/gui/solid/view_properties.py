"""The view properties of a Bézier solid: what each means and begins with."""

import FreeCAD

from osculate.features.properties import add_properties
from osculate.gui import colors
from osculate.gui.overlays.nodes import rgb

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

#: Choices of SliceDirection: barycentric coordinates, then planes across an axis.
CORNERS = ("Corner 0", "Corner 1", "Corner 2", "Corner 3")
AXES = ("X", "Y", "Z")

_GROUPS = (
    ("Object Style", (
        ("ShapeColor", "App::PropertyColor", QT_TRANSLATE_NOOP(
            "App::Property", "The colour of the faces")),
        ("Transparency", "App::PropertyPercent", QT_TRANSLATE_NOOP(
            "App::Property", "How transparent the faces are, in percent")),
        ("LineColor", "App::PropertyColor", QT_TRANSLATE_NOOP(
            "App::Property", "The colour of the edges")),
        ("LineWidth", "App::PropertyFloatConstraint", QT_TRANSLATE_NOOP(
            "App::Property", "The width of the edges in pixels")),
        ("Deviation", "App::PropertyLength", QT_TRANSLATE_NOOP(
            "App::Property", "The largest distance of the drawn triangles from the faces; 0 for a "
                             "thousandth of the solid's size")),
        ("ColorByJacobian", "App::PropertyBool", QT_TRANSLATE_NOOP(
            "App::Property", "Whether the faces and slices are coloured by the Jacobian "
                             "determinant: blue where it is > 0, orange where the solid folds")),
    )),
    ("Control net", (
        ("ShowNet", "App::PropertyBool", QT_TRANSLATE_NOOP(
            "App::Property", "Whether the control net is drawn")),
        ("ShowIndices", "App::PropertyBool", QT_TRANSLATE_NOOP(
            "App::Property", "Whether the control points are labelled with their indices")),
        ("ShowWeights", "App::PropertyBool", QT_TRANSLATE_NOOP(
            "App::Property", "Whether the control points are labelled with their weights")),
        ("NetColor", "App::PropertyColor", QT_TRANSLATE_NOOP(
            "App::Property", "The colour of the control net")),
        ("PointSize", "App::PropertyFloatConstraint", QT_TRANSLATE_NOOP(
            "App::Property", "The size of the control points in pixels")),
    )),
    ("Slices", (
        ("ShowSlices", "App::PropertyBool", QT_TRANSLATE_NOOP(
            "App::Property", "Whether the interior is shown by slices; the faces are drawn "
                             "transparent then")),
        ("Slices", "App::PropertyIntegerConstraint", QT_TRANSLATE_NOOP(
            "App::Property", "The number of slices, evenly spaced")),
        ("SliceDirection", "App::PropertyEnumeration", QT_TRANSLATE_NOOP(
            "App::Property", "What is constant on a slice: the barycentric coordinate of a corner, "
                             "or a coordinate in space")),
    )),
)

_STARTS = {
    "ShapeColor": (0.7, 0.78, 0.88),
    "LineColor": (0.33, 0.42, 0.55),
    "LineWidth": (2.0, 1.0, 16.0, 1.0),
    "ShowNet": True,
    "NetColor": rgb(colors.SIDES[1]),
    "PointSize": (9.0, 3.0, 30.0, 2.0),
    "Slices": (5, 1, 50, 1),
    "SliceDirection": [*CORNERS, *AXES],
}

NAMES = tuple(name for _, properties in _GROUPS for name, _, _ in properties)


def complete(vobj):
    """Adds the properties that a view object does not have yet; those of an older version stay."""
    has_direction = hasattr(vobj, "SliceDirection")
    add_properties(vobj, _GROUPS, _STARTS)
    if not has_direction:
        vobj.SliceDirection = AXES[2]


def are_complete(vobj):
    """Whether all are there: they come one after the other, and each is told."""
    return hasattr(vobj, NAMES[-1])
