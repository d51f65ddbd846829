"""The document object CurvatureComb: curvature, torsion or a rate of them along edges."""

import FreeCAD
import numpy

import osculate
from osculate.comb_drawing import automatic_scale
from osculate.features.edge_overlay import (
    EDGE_COUNT, SOURCES, WARNINGS, EdgeOverlay, sources_from)
from osculate.features.feature import STATUS, make
from osculate.features.properties import LOOK, set_if_changed

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

_DENSITY = (24, 2, 1000, 4)  # default, least, most, step

_CURVES = ("Curves", (
    SOURCES,
    ("Quantity", "App::PropertyEnumeration", QT_TRANSLATE_NOOP(
        "App::Property", "What the teeth show: curvature, torsion, or a rate by arc length")),
    ("Density", "App::PropertyIntegerConstraint", QT_TRANSLATE_NOOP(
        "App::Property", "Teeth of each Bézier segment")),
))
_LOOK = ("Look", (
    ("AutoScale", "App::PropertyBool", QT_TRANSLATE_NOOP(
        "App::Property", "Whether the length of the teeth suits the size of the curves"), LOOK),
    ("Scale", "App::PropertyFloat", QT_TRANSLATE_NOOP(
        "App::Property", "Length of a tooth in mm for a value of 1, where it is not automatic"),
     LOOK),
    ("Factor", "App::PropertyFloat", QT_TRANSLATE_NOOP(
        "App::Property", "Makes the teeth longer or shorter than the automatic scale does"), LOOK),
    ("Teeth", "App::PropertyBool", QT_TRANSLATE_NOOP(
        "App::Property", "Whether the teeth are drawn"), LOOK),
    ("Envelope", "App::PropertyBool", QT_TRANSLATE_NOOP(
        "App::Property", "Whether the line over the teeth is drawn"), LOOK),
    ("Marks", "App::PropertyBool", QT_TRANSLATE_NOOP(
        "App::Property", "Whether peaks, inflections, vertices and cusps are marked"), LOOK),
    ("Legend", "App::PropertyBool", QT_TRANSLATE_NOOP(
        "App::Property", "Whether the view explains the comb"), LOOK),
))
_RESULT = ("Result", (
    STATUS[0],
    EDGE_COUNT,
    ("Length", "App::PropertyLength", QT_TRANSLATE_NOOP(
        "App::Property", "Length of all edges")),
    ("LargestCurvature", "App::PropertyFloat", QT_TRANSLATE_NOOP(
        "App::Property", "Largest curvature, 1/mm")),
    ("SmallestRadius", "App::PropertyDistance", QT_TRANSLATE_NOOP(
        "App::Property", "Smallest radius of curvature; 0 where nothing bends")),
    ("LargestTorsion", "App::PropertyFloat", QT_TRANSLATE_NOOP(
        "App::Property", "Largest magnitude of the torsion, 1/mm")),
    ("Inflections", "App::PropertyInteger", QT_TRANSLATE_NOOP(
        "App::Property", "Number of inflections")),
    ("Vertices", "App::PropertyInteger", QT_TRANSLATE_NOOP(
        "App::Property", "Number of vertices: points where the curvature is stationary")),
    ("Cusps", "App::PropertyInteger", QT_TRANSLATE_NOOP("App::Property", "Number of cusps")),
    WARNINGS,
    STATUS[1],
))


class CurvatureComb(EdgeOverlay):
    """Proxy of an App::FeaturePython; documents name this class."""

    groups = (_CURVES, _LOOK)
    result_groups = (_RESULT,)
    starts = {"Quantity": list(osculate.COMB_QUANTITIES), "Density": _DENSITY, "AutoScale": True,
              "Scale": 100.0, "Factor": 1.0, "Teeth": True, "Envelope": True, "Marks": True,
              "Legend": True}

    def options(self, obj):
        return obj.Density, obj.Quantity

    def make_from(self, obj, curves):
        return osculate.comb(curves, density=obj.Density, quantities=[obj.Quantity])

    def show(self, obj, comb):
        super().show(obj, comb)
        curvature = _largest(comb.curvature)
        obj.Length = float(comb.lengths.sum())
        obj.LargestCurvature = curvature
        obj.SmallestRadius = 1.0 / curvature if curvature > 0.0 else 0.0
        obj.LargestTorsion = _largest(comb.torsion)
        kinds = [mark.kind for mark in comb.marks]
        for name, kind in (("Inflections", "inflection"), ("Vertices", "vertex"),
                           ("Cusps", "cusp")):
            set_if_changed(obj, name, kinds.count(kind))


def make_curvature_comb(doc, sources, *, quantity="curvature", density=24, name="CurvatureComb"):
    """Adds a CurvatureComb to a document and recomputes it.

    doc:      the App.Document
    sources:  objects of it, and (object, "Edge1") pairs; of an object all edges count, of a pair
              the edge, or the edges of the face. A path may lead down an App::Part
              ("Sketch.Edge1", or "Sketch." for all of it).
    quantity: one of osculate.COMB_QUANTITIES
    density:  teeth of each Bézier segment, 2 to 1000

    Raises ValueError before anything is changed. A link that leads to no edge is no error here: the
    object says so in its Warnings, or in its Status if none is left.
    """
    if quantity not in osculate.COMB_QUANTITIES:
        raise ValueError(f"quantity: must be one of {', '.join(osculate.COMB_QUANTITIES)}, not "
                         f"{quantity!r}")
    if not _DENSITY[1] <= density <= _DENSITY[2]:
        raise ValueError(f"density: must be {_DENSITY[1]} to {_DENSITY[2]}, not {density}")
    return make_object(doc, name=name, Sources=sources_from(sources), Quantity=quantity,
                       Density=density)


def make_object(doc, *, name="CurvatureComb", **settings):
    """Adds a CurvatureComb with some of its properties set, and recomputes it."""
    return make(doc, CurvatureComb, name, **settings)


def scale_of(obj):
    """The length in mm of a tooth of value 1 as a CurvatureComb is drawn; None where its values are
    zero, or it has none.
    """
    scale = automatic_scale_of(obj)
    if scale is None or not obj.AutoScale:
        return scale and obj.Scale
    return scale * obj.Factor


def automatic_scale_of(obj):
    """The same without the Factor, and whether it is used or not."""
    comb = obj.Proxy.result
    return None if comb is None else automatic_scale([comb], obj.Quantity)


def _largest(values):
    return float(numpy.nanmax(numpy.abs(values), initial=0.0))
