"""Keeps a join as an object of its document."""

import FreeCAD

from osculate.features import make_join_check
from osculate.features.edge_link import LinkError
from osculate.gui.qt import translate
from osculate.gui.transaction import transaction


def keep_join(place, options):
    """Adds a JoinCheck for a JoinPlace in one step of undo, and returns it.

    Raises LinkError if the edges are in different documents. If anything fails the document is left
    as it was.
    """
    require_one_document(place, place.first.document)
    document = FreeCAD.getDocument(place.first.document)
    with transaction(document, translate("Osculate", "Keep join check")):
        obj = make_join_check(
            document, _target(place.first), _target(place.second), order=options.order,
            ends=place.ends, preset=options.preset, values=options.values, knot=place.knot)
    return obj


def require_one_document(place, name):
    """Raises LinkError unless both edges are in the document, as links between objects must be."""
    if {place.first.document, place.second.document} != {name}:
        raise LinkError(translate("Osculate", "A check must be in one document with its edges."))


def _target(link):
    return link.resolve_object(), link.sub
