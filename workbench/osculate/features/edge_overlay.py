"""What document objects have in common that draw something along edges and follow these live."""

import FreeCAD

import osculate
from osculate.features.edge_link import EdgeLink, LinkError, edges_at
from osculate.features.feature import FAILURES, Feature
from osculate.features.properties import set_if_changed

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
translate = FreeCAD.Qt.translate

SOURCES = ("Sources", "App::PropertyLinkSubListGlobal", QT_TRANSLATE_NOOP(
    "App::Property", "Edges, faces, or whole objects, all of whose edges count"))
EDGE_COUNT = ("EdgeCount", "App::PropertyInteger", QT_TRANSLATE_NOOP(
    "App::Property", "Number of edges"))
WARNINGS = ("Warnings", "App::PropertyStringList", QT_TRANSLATE_NOOP(
    "App::Property", "What is left out, in sentences"))


class EdgeOverlay(Feature):
    """Base of the proxies; a subclass has the properties SOURCES, EDGE_COUNT and WARNINGS.

    `EdgeCount` is set whenever there is something new to draw.
    """

    problems = ()    #: why some edges are left out, in sentences
    _edges = None    # that were looked at last, and
    _curves = ()     # the curves of those that have one, and why others have none
    _refusals = ()
    _made_of = None  # what `_made` was made of, besides them
    _made = None

    # What a subclass does

    def options(self, _obj):
        """What the result depends on besides the edges, as a tuple."""
        return ()

    def make_from(self, obj, curves):
        """The result, of osculate.Curves; they are the same list as long as the edges are the same.
        Raises one of FAILURES.
        """
        raise NotImplementedError

    # What all do

    def construct(self, obj):
        self._look(obj)
        if self._made is None:
            raise LinkError(" ".join(self.problems))
        return self._made

    def put(self, obj, _result):
        obj.EdgeCount = len(self._curves)

    def show(self, obj, _result):
        set_if_changed(obj, "Warnings", list(self.problems))

    def follow(self, obj):
        """Looks at the edges and options as they are now; True if the result changed. The
        properties of the object stay: they follow with its recompute.
        """
        if not self._look(obj):
            return False
        self.result = self._made
        self.error = "" if self._made is not None else " ".join(self.problems)
        return True

    def _look(self, obj):
        """Makes the result anew if what it is made of changed; True if it did."""
        edges, problems = _edges_of(links_of(obj))
        made_of = self.options(obj), problems
        is_other = self._edges is None or not are_same_edges(edges, self._edges)
        if not is_other and made_of == self._made_of:
            return False
        if is_other:
            self._edges, self._curves, self._refusals = edges, *_curves_from(edges)
        self._made_of, self._made = made_of, None
        problems = [*problems, *self._refusals]
        if self._curves:
            try:
                self._made = self.make_from(obj, self._curves)
            except FAILURES as error:
                problems.append(str(error))
        self.problems = tuple(dict.fromkeys(problems))
        return True


def sources_from(sources):
    """The value of the property Sources from objects and (object, sub) pairs."""
    return [source if isinstance(source, (tuple, list)) else (source, "") for source in sources]


def links_of(obj):
    """The sources of an object as EdgeLinks; `sub` is empty for a whole object."""
    return [EdgeLink.of(source, sub) for source, subs in obj.Sources
            for sub in ((subs,) if isinstance(subs, str) else subs or ("",))]


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


def _curves_from(edges):
    """(curves, problems)"""
    curves, problems = [], []
    for edge in edges:
        try:
            curves.append(osculate.Curve.from_edge(edge))
        except FAILURES as error:
            problems.append(str(error))
    return curves, problems


def are_same_edges(edges, others):
    """Whether two lists have the same Part.Edges in the same places."""
    return len(edges) == len(others) and all(map(_is_equal, edges, others))


def _is_equal(edge, other):
    """Whether two edges are one, in one place: isEqual says no where the place was computed twice.
    """
    return (edge.isPartner(other) and edge.Orientation == other.Orientation
            and edge.Placement.toMatrix().A == other.Placement.toMatrix().A)
