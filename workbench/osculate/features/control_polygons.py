"""The document object ControlPolygons: of the Bézier segments of edges, with their differences."""

import FreeCAD
import numpy

from osculate.comb_drawing import nice
from osculate.features.edge_overlay import (
    EDGE_COUNT, SOURCES, WARNINGS, EdgeOverlay, sources_from)
from osculate.features.feature import STATUS, make
from osculate.features.properties import LOOK, set_if_changed
from osculate.polygons import control_polygons, derivatives, differences

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

#: How differences are drawn: as they are, or as the poles of the derivatives of each segment over
#: [0, 1], shortened to a part of the size of the curves.
PLAIN, DERIVATIVES = DIFFERENCES = ("plain", "derivatives")

_LONGEST = 0.25  # of the arrows of derivatives, as a share of the size of the curves

_CURVES = ("Curves", (SOURCES,))
_LOOK = ("Look", (
    ("Weights", "App::PropertyBool", QT_TRANSLATE_NOOP(
        "App::Property", "Whether the weights of rational segments stand at their poles"), LOOK),
    ("FirstDifferences", "App::PropertyBool", QT_TRANSLATE_NOOP(
        "App::Property", "Whether the first differences Δb of the poles are drawn as arrows"),
     LOOK),
    ("SecondDifferences", "App::PropertyBool", QT_TRANSLATE_NOOP(
        "App::Property", "Whether the second differences Δ²b of the poles are drawn as arrows"),
     LOOK),
    ("DifferenceScale", "App::PropertyEnumeration", QT_TRANSLATE_NOOP(
        "App::Property", "Whether differences are drawn as they are, or as poles of derivatives"),
     LOOK),
    ("Legend", "App::PropertyBool", QT_TRANSLATE_NOOP(
        "App::Property", "Whether the view explains what is drawn"), LOOK),
))
_RESULT = ("Result", (
    STATUS[0],
    EDGE_COUNT,
    ("Segments", "App::PropertyInteger", QT_TRANSLATE_NOOP(
        "App::Property", "Number of Bézier segments")),
    ("RationalSegments", "App::PropertyInteger", QT_TRANSLATE_NOOP(
        "App::Property", "Number of those that are rational")),
    ("Degrees", "App::PropertyIntegerList", QT_TRANSLATE_NOOP(
        "App::Property", "The degrees of the segments, each once")),
    ("Poles", "App::PropertyInteger", QT_TRANSLATE_NOOP(
        "App::Property", "Number of poles of all segments")),
    WARNINGS,
    STATUS[1],
))


class ControlPolygons(EdgeOverlay):
    """Proxy of an App::FeaturePython; documents name this class."""

    groups = (_CURVES, _LOOK)
    result_groups = (_RESULT,)
    starts = {"Weights": False, "FirstDifferences": False, "SecondDifferences": False,
              "DifferenceScale": list(DIFFERENCES), "Legend": True}

    def make_from(self, obj, curves):
        return control_polygons(curves)

    def show(self, obj, polygons):
        super().show(obj, polygons)
        for name, value in (("Segments", len(polygons.counts)),
                            ("RationalSegments", int(polygons.is_rational.sum())),
                            ("Degrees", numpy.unique(polygons.degrees).tolist()),
                            ("Poles", len(polygons.poles))):
            set_if_changed(obj, name, value)


def make_control_polygons(doc, sources, *, weights=False, first_differences=False,
                          second_differences=False, difference_scale=PLAIN,
                          name="ControlPolygons"):
    """Adds a ControlPolygons to a document and recomputes it.

    doc, sources: as those of make_curvature_comb
    weights, first_differences, second_differences: what is shown besides the polygons
    difference_scale: one of DIFFERENCES

    Raises ValueError before anything is changed. A link that leads to no edge is no error here: the
    object says so in its Warnings, or in its Status if none is left.
    """
    if difference_scale not in DIFFERENCES:
        raise ValueError(f"difference_scale: must be one of {', '.join(DIFFERENCES)}, not "
                         f"{difference_scale!r}")
    return make_object(doc, name=name, Sources=sources_from(sources), Weights=bool(weights),
                       FirstDifferences=bool(first_differences),
                       SecondDifferences=bool(second_differences),
                       DifferenceScale=difference_scale)


def make_object(doc, *, name="ControlPolygons", **settings):
    """Adds a ControlPolygons with some of its properties set, and recomputes it."""
    return make(doc, ControlPolygons, name, **settings)


def arrows_of(polygons, order, scaling):
    """(differences, factor): osculate.polygons.Differences of an order as a ControlPolygons draws
    them, and what their lengths are to be multiplied by.
    """
    if scaling == PLAIN:
        return differences(polygons, order), 1.0
    found = derivatives(polygons, order)
    longest = float(numpy.linalg.norm(found.vectors, axis=1).max(initial=0.0))
    size = size_of_poles(polygons)
    return found, nice(_LONGEST * size / longest) if longest > 0.0 else 1.0


def size_of_poles(polygons):
    """The diagonal of the box around all poles, mm."""
    if not len(polygons.poles):
        return 0.0
    return float(numpy.linalg.norm(numpy.ptp(polygons.poles, axis=0)))
