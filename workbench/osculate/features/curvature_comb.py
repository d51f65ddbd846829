"""The document object CurvatureComb: curvature, torsion or a rate of them along edges."""

import FreeCAD
import numpy

import osculate
from osculate.comb_drawing import automatic_scale
from osculate.features.edge_link import EdgeLink, LinkError, edges_at
from osculate.features.feature import FAILURES, STATUS, Feature, make
from osculate.features.properties import LOOK, set_if_changed

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
translate = FreeCAD.Qt.translate

_DENSITY = (24, 2, 1000, 4)  # default, least, most, step

_CURVES = ("Curves", (
    ("Sources", "App::PropertyLinkSubListGlobal", QT_TRANSLATE_NOOP(
        "App::Property", "Edges, faces, or whole objects, whose edges have the comb")),
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
    ("EdgeCount", "App::PropertyInteger", QT_TRANSLATE_NOOP(
        "App::Property", "Number of edges")),
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
    ("Warnings", "App::PropertyStringList", QT_TRANSLATE_NOOP(
        "App::Property", "What has no comb, in sentences")),
    STATUS[1],
))


class CurvatureComb(Feature):
    """Proxy of an App::FeaturePython; documents name this class.

    `EdgeCount` is set whenever there is a new comb.
    """

    groups = (_CURVES, _LOOK)
    result_groups = (_RESULT,)
    starts = {"Quantity": list(osculate.COMB_QUANTITIES), "Density": _DENSITY, "AutoScale": True,
              "Scale": 100.0, "Factor": 1.0, "Teeth": True, "Envelope": True, "Marks": True,
              "Legend": True}

    problems = ()    #: why some edges have no comb, in sentences
    _made_of = None  # what was looked at last, and
    _comb = None     # what was made of it

    def construct(self, obj):
        self._look(obj)
        if self._comb is None:
            raise LinkError(" ".join(self.problems))
        return self._comb

    def put(self, obj, comb):
        obj.EdgeCount = len(comb.lengths)

    def show(self, obj, comb):
        curvature = _largest(comb.curvature)
        obj.Length = float(comb.lengths.sum())
        obj.LargestCurvature = curvature
        obj.SmallestRadius = 1.0 / curvature if curvature > 0.0 else 0.0
        obj.LargestTorsion = _largest(comb.torsion)
        kinds = [mark.kind for mark in comb.marks]
        for name, kind in (("Inflections", "inflection"), ("Vertices", "vertex"),
                           ("Cusps", "cusp")):
            set_if_changed(obj, name, kinds.count(kind))
        set_if_changed(obj, "Warnings", list(self.problems))

    def follow(self, obj):
        """Looks at the edges and options as they are now; True if the comb changed. The properties
        of the object stay: they follow with its recompute.
        """
        if not self._look(obj):
            return False
        self.result = self._comb
        self.error = "" if self._comb else " ".join(self.problems)
        return True

    def _look(self, obj):
        """Makes the comb anew if what it is made of changed; True if it did."""
        edges, problems = _edges_of(links_of(obj))
        made_of = edges, (obj.Density, obj.Quantity, tuple(problems))
        if self._made_of is not None and _are_same(made_of, self._made_of):
            return False
        curves = _curves_from(edges, problems)
        self._made_of, self.problems = made_of, tuple(dict.fromkeys(problems))
        self._comb = osculate.comb(curves, density=obj.Density,
                                   quantities=[obj.Quantity]) if curves else None
        return True


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


def sources_from(sources):
    """The value of the property Sources from objects and (object, sub) pairs."""
    return [source if isinstance(source, (tuple, list)) else (source, "") for source in sources]


def links_of(obj):
    """The sources of a CurvatureComb as EdgeLinks; `sub` is empty for a whole object."""
    return [EdgeLink.of(source, sub) for source, subs in obj.Sources
            for sub in ((subs,) if isinstance(subs, str) else subs or ("",))]


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


def _edges_of(links):
    """(edges, problems): what the links lead to, and why some lead nowhere."""
    edges, problems = [], []
    for link in links:
        try:
            edges += edges_at(link)
        except LinkError as error:
            problems.append(str(error))
    if not edges and not problems:
        problems.append(translate("Osculate", "No edge is linked (its object was deleted?)."))
    return edges, problems


def _curves_from(edges, problems):
    curves = []
    for edge in edges:
        try:
            curves.append(osculate.Curve.from_edge(edge))
        except FAILURES as error:
            problems.append(str(error))
    return curves


def _are_same(first, second):
    edges, others = first[0], second[0]
    return (first[1] == second[1] and len(edges) == len(others)
            and all(map(_is_equal, edges, others)))


def _is_equal(edge, other):
    """Whether two edges are one, in one place: isEqual says no where the place was computed twice.
    """
    return (edge.isPartner(other) and edge.Orientation == other.Orientation
            and edge.Placement.toMatrix().A == other.Placement.toMatrix().A)


def _largest(values):
    return float(numpy.nanmax(numpy.abs(values), initial=0.0))
