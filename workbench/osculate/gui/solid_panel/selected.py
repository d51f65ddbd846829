"""The Bézier solids that are selected."""

import FreeCADGui

from osculate.features.bezier_solid import is_solid


def selected_solids():
    """The BezierSolids of the selection, each once, in its order."""
    objects = FreeCADGui.Selection.getSelection()
    return list({obj.Name: obj for obj in objects if is_solid(obj)}.values())


def take_selected_solids():
    """The same, and nothing is selected any more: its colour would hide what is shown of them."""
    objects = selected_solids()
    FreeCADGui.Selection.clearSelection()
    return objects
