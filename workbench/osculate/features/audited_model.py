"""The objects that an audit looks at, as one shape, and what its edges are in the document."""

import functools
from bisect import bisect_right

import FreeCAD
import Part

from osculate.features.edge_link import EdgeLink, LinkError

translate = FreeCAD.Qt.translate


class AuditedModel:
    """One shape of some whole objects, in global coordinates; its edges are numbered from 1.

    links: EdgeLinks to objects (`sub` names no element). An object without a shape of its own, as
        an App::Part, stands for what is seen in it.
    fixes: MatchedCurves: the curve of each stands for the edge that it changes.
    keeps_wires: of an object without faces the edges count one by one otherwise, so that open ends
        of its wires can touch others.

    Raises LinkError where there is no object; `shape`, made when it is asked for, where one has no
    edge.
    """

    def __init__(self, links, fixes=(), keeps_wires=False):
        stand_ins = _stand_ins(fixes)
        self._members = [_Member(link, stand_ins, keeps_wires) for link in _with_shapes(
            links, {name for name, _ in stand_ins})]
        if not self._members:
            raise LinkError(translate("Osculate", "There is nothing to audit (was its object "
                                                  "deleted?)."))
        self._firsts = self._edges = None  # made when a second object asks for them

    @functools.cached_property
    def shape(self):
        shapes = [member.shape for member in self._members]
        return shapes[0] if len(shapes) == 1 else Part.Compound(shapes)

    @property
    def is_one_object(self):
        return len(self._members) == 1

    def is_same(self, other):
        """Whether nothing of the model changed since another one was made."""
        return (len(self._members) == len(other._members)
                and all(map(_Member.is_same, self._members, other._members)))

    def edge_link(self, number):
        """The EdgeLink of an edge of the shape."""
        if self.is_one_object:
            return self._members[0].edge_link(number)
        if self._firsts is None:
            self._number_edges()
        if self._edges is not None:
            return self._edges[number - 1]
        member = bisect_right(self._firsts, number) - 1
        return self._members[member].edge_link(number - self._firsts[member] + 1)

    def edge_label(self, number):
        """What the user calls an edge: "Edge3", or "Body.Edge3" where there are more objects."""
        label = self.edge_link(number).label()
        return label.rpartition(".")[2] if self._is_plain(number) else label

    def _is_plain(self, number):
        return self.is_one_object and not self._members[0].has_stand_in(number)

    def row_label(self, row):
        """What the user calls the join of an AuditRow, e.g. "Edge3 – Edge4"."""
        first = self.edge_label(row.edges[0])
        if row.kind == "knot":
            return translate("Osculate", "{}, knot at {}").format(first, f"{row.parameter:.6g}")
        if row.kind == "seam":
            return translate("Osculate", "{}, closing").format(first)
        return f"{first} – {self.edge_label(row.edges[1])}"

    def _number_edges(self):
        """Which edges of the compound are those of which object."""
        counts = [len(member.shape.Edges) for member in self._members]
        if sum(counts) == len(self.shape.Edges):
            self._firsts = [1 + sum(counts[:number]) for number in range(len(counts))]
            return
        # Objects share edges: the compound has each once, as the first object has it.
        self._firsts, self._edges, known = [], [], {}
        for member, count in zip(self._members, counts):
            for number, edge in enumerate(member.shape.Edges, 1):
                same = known.setdefault(edge.hashCode(), [])
                if not any(edge.isSame(other) for other in same):
                    same.append(edge)
                    self._edges.append(member.edge_link(number))


class _Member:
    """One object of a model."""

    def __init__(self, link, stand_ins, keeps_wires):
        self._link, self._keeps_wires = link, keeps_wires
        self._whole = whole_shape(link)
        owner = link.owner().Name
        own = {key: _last(stand_ins, key) for key in stand_ins if key[0] == owner}
        self._stand_ins = {int(element[len("Edge"):]): found for (_, element), found in own.items()}

    @functools.cached_property
    def shape(self):
        """The edges still share their vertices where they are in no wire."""
        shape = self._whole
        if shape.isNull() or not shape.countElement("Edge"):
            raise LinkError(translate("Osculate", "{} has no edges.")
                            .format(self._link.owner().Label))
        if self._stand_ins or not (self._keeps_wires or shape.countElement("Face")):
            return self._loose(shape)
        return shape

    def is_same(self, other):
        return (self._link == other._link and self._keeps_wires == other._keeps_wires
                and not self._stand_ins and not other._stand_ins
                and self._whole.isSame(other._whole))

    def has_stand_in(self, number):
        return number in self._stand_ins

    def edge_link(self, number):
        if number in self._stand_ins:
            return self._stand_ins[number]
        return EdgeLink(self._link.document, self._link.object, f"{self._link.sub}Edge{number}")

    def _loose(self, shape):
        """The edges in no wire, with others in the place of some."""
        if shape.countElement("Face"):
            raise LinkError(translate(
                "Osculate", "Edges of {} bound faces: no other curve can stand for them.")
                .format(self._link.owner().Label))
        return Part.Compound([
            self._stand_ins[number].resolve() if number in self._stand_ins else edge
            for number, edge in enumerate(shape.Edges, 1)])


def whole_shape(link):
    """The shape of the object that a link leads to or into, in global coordinates. Where nothing
    moves it, it shares edges with other objects, which FreeCAD's getShape would not tell.
    """
    obj, path = link.resolve_object(), link.sub.rpartition(".")
    if not path[0] and "Shape" in obj.PropertiesList and obj.getParentGeoFeatureGroup() is None:
        return obj.Shape
    return Part.getShape(obj, path[0] + path[1])


def _with_shapes(links, originals):
    """The links, those to groups replaced by links to what is seen in them."""
    found = {}
    for link in links:
        if link.sub.rpartition(".")[2]:
            raise LinkError(translate("Osculate", "{} is only a part of an object; an audit takes "
                                                  "whole ones.").format(link.label()))
        found.update(dict.fromkeys(_expanded(link, originals)))
    return list(found)


def _expanded(link, originals):
    owner = link.owner()
    if "Shape" in owner.PropertiesList or not owner.hasExtension("App::GroupExtension"):
        return [link]
    members = []
    for name in owner.getSubObjects():
        member = EdgeLink(link.document, link.object, link.sub + name)
        child = member.owner()
        if child.Visibility or child.Name in originals:  # what a fix changes may be hidden
            members += [found for found in _expanded(member, originals) if _has_edges(found)]
    return members


def _has_edges(link):
    shape = whole_shape(link)
    return not shape.isNull() and shape.countElement("Edge") > 0


def _stand_ins(fixes):
    """(name of an object, "Edge1") -> EdgeLink to the curve of a fix."""
    found = {}
    for fix in fixes:
        try:
            link = EdgeLink.of_property(fix.Changed)
            key = link.owner().Name, link.sub.rpartition(".")[2]
        except LinkError:
            continue  # what it changed was deleted
        found[key] = EdgeLink.of(fix, "Edge1")
    return found


def _last(stand_ins, key):
    """What stands for an edge, or for what stands for it; None where nothing does."""
    found = None
    while key in stand_ins:
        found = stand_ins[key]
        key = found.object, found.sub
    return found
