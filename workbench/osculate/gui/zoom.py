"""Moves the camera of the active 3D view to a join."""

import FreeCADGui
from pivy import coin

#: How much of the two segments around a join is brought into view.
_SLACK = 1.3


def zoom_to(report):
    """Fits the segments of both sides into the active view, if it is a 3D view."""
    view = FreeCADGui.ActiveDocument.ActiveView if FreeCADGui.ActiveDocument else None
    if not hasattr(view, "getCameraNode"):
        return
    box = coin.SbBox3f()
    for side in report.sides:
        box.extendBy(coin.SbVec3f(*map(float, side.point)))
        for pole in side.segment.poles if side.segment else ():
            box.extendBy(coin.SbVec3f(*map(float, pole)))
    width, height = view.getSize()
    view.getCameraNode().viewBoundingBox(box, width / height, _SLACK)
