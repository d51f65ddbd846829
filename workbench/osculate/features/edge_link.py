"""References to an edge or a vertex of a document: names that survive edits."""

from dataclasses import dataclass

import FreeCAD
import Part

translate = FreeCAD.Qt.translate


class LinkError(Exception):
    """A link leads to no edge or vertex; the message is a sentence for the user."""


@dataclass(frozen=True)
class EdgeLink:
    """Edge `sub` of an object, by names.

    `sub` is the path from the object down to the edge as FreeCAD's selection gives it, e.g.
    "Edge3", or "Sketch.Edge3" under an App::Part whose placement then counts.
    """

    document: str
    object: str
    sub: str

    @classmethod
    def of(cls, obj, sub):
        """The link to `sub` of a document object."""
        return cls(obj.Document.Name, obj.Name, sub)

    @classmethod
    def of_property(cls, value):
        """The link in a property of a document object. Raises LinkError if it names none."""
        if not value or value[0] is None:
            raise LinkError(cls._none())
        obj, subs = value
        names = [subs] if isinstance(subs, str) else [sub for sub in subs if sub]
        if len(names) != 1:
            raise LinkError(cls._not_one(obj))
        return cls.of(obj, names[0])

    def resolve_object(self):
        """The document object. Raises LinkError if it is gone."""
        document = FreeCAD.listDocuments().get(self.document)
        obj = document.getObject(self.object) if document else None
        if obj is None:
            raise LinkError(translate("Osculate", "{} no longer exists.").format(self.object))
        return obj

    def resolve(self):
        """The Part.Edge in global coordinates. Raises LinkError if there is none."""
        return self._resolve("Edge")

    def _resolve(self, kind):
        obj = self.resolve_object()
        try:
            shape = Part.getShape(obj, self.sub, needSubElement=True)
        except Exception as error:  # FreeCAD raises IndexError, ValueError or Part.OCCError here
            raise LinkError(self.missing(obj)) from error
        if shape.isNull():
            raise LinkError(self.missing(obj))
        if shape.ShapeType != kind:
            raise LinkError(self._other_kind(shape.ShapeType.lower()))
        return shape

    def owner(self):
        """The document object to which it belongs, under any App::Part. Raises LinkError."""
        owner = self._owner()
        if owner is None:
            raise LinkError(translate("Osculate", "{} no longer exists.").format(self.object))
        return owner

    def _owner(self):
        path = self.sub.split(".")[:-1]
        document = FreeCAD.listDocuments().get(self.document)
        return document.getObject(path[-1] if path else self.object) if document else None

    # What is said where it leads to none

    @staticmethod
    def _none():
        return translate("Osculate", "No edge is linked (its object was deleted?).")

    @staticmethod
    def _not_one(obj):
        return translate("Osculate", "{} is linked without one edge of it.").format(obj.Label)

    def _other_kind(self, kind):
        return translate("Osculate", "{} is not an edge but a {}.").format(self.label(), kind)

    def missing(self, obj):
        """The sentence that the object has no such edge."""
        return translate("Osculate", "{} has no {}.").format(obj.Label, self.sub)

    def label(self):
        """What the user calls it, e.g. "Profile.Edge3"; names where the object is gone."""
        owner = self._owner()
        element = self.sub.rpartition(".")[2]
        return "{}.{}".format(owner.Label if owner else self.object, element)


class VertexLink(EdgeLink):
    """Vertex `sub` of an object, by names."""

    def resolve(self):
        """The Part.Vertex in global coordinates. Raises LinkError if there is none."""
        return self._resolve("Vertex")

    @staticmethod
    def _none():
        return translate("Osculate", "No vertex is linked (its object was deleted?).")

    @staticmethod
    def _not_one(obj):
        return translate("Osculate", "{} is linked without one vertex of it.").format(obj.Label)

    def _other_kind(self, kind):
        return translate("Osculate", "{} is not a vertex but a {}.").format(self.label(), kind)


def resolve_each(links):
    """The Part.Edges of some EdgeLinks, in order; equal links give one and the same edge. Raises
    LinkError.
    """
    edges = {link: link.resolve() for link in dict.fromkeys(links)}
    return [edges[link] for link in links]


def edges_of_object(obj, path=""):
    """Links to every edge with a length of the object at `path` under `obj`, in FreeCAD's order.

    Raises LinkError if it has no shape with edges.
    """
    shape = Part.getShape(obj, path)
    links = [EdgeLink.of(obj, f"{path}Edge{number}")
             for number, edge in enumerate(shape.Edges, start=1) if not edge.Degenerated]
    if not links:
        raise LinkError(translate("Osculate", "{} has no edges.").format(obj.Label))
    return links


def edges_at(link):
    """Every edge with a length of what a link leads to: an edge, a face, or all of an object if its
    `sub` names no element. In global coordinates. Raises LinkError if there are none.
    """
    obj = link.resolve_object()
    element = link.sub.rpartition(".")[2]
    try:
        shape = Part.getShape(obj, link.sub, needSubElement=bool(element))
    except Exception as error:  # FreeCAD raises IndexError, ValueError or Part.OCCError here
        raise LinkError(link.missing(obj)) from error
    edges = [] if shape.isNull() else [edge for edge in shape.Edges if not edge.Degenerated]
    if not edges:
        raise LinkError(link.missing(obj) if element else
                        translate("Osculate", "{} has no edges.").format(obj.Label))
    return edges


def resolve_all(links):
    """A dict from each EdgeLink to its Part.Edge, with one look at each shape. Raises LinkError."""
    shapes = {}
    return {link: _edge_in_shape(link, shapes) for link in links}


def _edge_in_shape(link, shapes):
    """The edge by its number in the shape of its owner, which `shapes` keeps for the next."""
    path, _, element = link.sub.rpartition(".")
    owner = link.document, link.object, path
    if owner not in shapes:
        obj = link.resolve_object()
        shapes[owner] = Part.getShape(obj, path + "." if path else "").Edges
    number = element[len("Edge"):]
    if number.isdigit() and 0 < int(number) <= len(shapes[owner]):
        return shapes[owner][int(number) - 1]
    return link.resolve()  # says what is wrong
