"""A reference to one edge of a document: names that survive edits, resolved when needed."""

from dataclasses import dataclass

import FreeCAD
import Part

translate = FreeCAD.Qt.translate


class LinkError(Exception):
    """A link leads to no edge; the message is a sentence for the user."""


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
        """The link in a property of a document object. Raises LinkError if it names no edge."""
        if not value or value[0] is None:
            raise LinkError(translate("Osculate", "No edge is linked (its object was deleted?)."))
        obj, subs = value
        names = [subs] if isinstance(subs, str) else [sub for sub in subs if sub]
        if len(names) != 1:
            raise LinkError(translate("Osculate", "{} is linked without one edge of it.")
                            .format(obj.Label))
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
        obj = self.resolve_object()
        try:
            shape = Part.getShape(obj, self.sub, needSubElement=True)
        except Exception as error:  # FreeCAD raises IndexError, ValueError or Part.OCCError here
            raise LinkError(self._missing(obj)) from error
        if shape.isNull():
            raise LinkError(self._missing(obj))
        if shape.ShapeType != "Edge":
            raise LinkError(translate("Osculate", "{} is not an edge but a {}.")
                            .format(self.label(), shape.ShapeType.lower()))
        return shape

    def _missing(self, obj):
        return translate("Osculate", "{} has no {}.").format(obj.Label, self.sub)

    def label(self):
        """What the user calls the edge, e.g. "Profile.Edge3"; names where the object is gone."""
        *path, element = self.sub.split(".")
        document = FreeCAD.listDocuments().get(self.document)
        owner = document.getObject(path[-1] if path else self.object) if document else None
        return "{}.{}".format(owner.Label if owner else self.object, element)


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
