"""Keeps a join as an object of its document."""

import FreeCAD

from osculate.features import make_join_check
from osculate.gui.qt import translate


def keep_join(place, options):
    """Adds a JoinCheck for a JoinPlace in one step of undo, and returns it.

    If anything fails the document is left as it was.
    """
    document = FreeCAD.getDocument(place.first.document)
    document.openTransaction(translate("Osculate", "Keep join check"))
    try:
        obj = make_join_check(
            document, _target(place.first), _target(place.second), order=options.order,
            ends=place.ends, preset=options.preset, values=options.values, knot=place.knot)
    except BaseException:
        document.abortTransaction()
        raise
    document.commitTransaction()
    return obj


def _target(link):
    return link.resolve_object(), link.sub
