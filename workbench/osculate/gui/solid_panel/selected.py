"""The Bézier solids that are selected."""

import FreeCADGui

from osculate.features.bezier_solid import is_solid


def selected_solids():
    """The BezierSolids of the selection, each once, in its order."""
    objects = FreeCADGui.Selection.getSelection()
    return list({obj.Name: obj for obj in objects if is_solid(obj)}.values())
