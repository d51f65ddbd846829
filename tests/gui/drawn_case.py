"""Bézier solids for the GUI tests."""

import os

import FreeCAD
import FreeCADGui
import osculate

from gui_case import GuiCase
from osculate import solids
from osculate.gui.solid.solid_view import SolidView


class PlainSolid:
    """A stand-in: a net that is set from outside."""

    def __init__(self, obj):
        obj.addProperty("App::PropertyVectorList", "Points")
        obj.addProperty("App::PropertyFloatList", "Weights")
        obj.addProperty("App::PropertyFloatList", "FourthCoordinates")
        obj.Proxy = self

    def execute(self, _obj):
        pass

    def dumps(self):
        return None

    def loads(self, _state):
        return None

    __getstate__ = dumps
    __setstate__ = loads


def add_solid(doc, value, name="Solid"):
    """A document object with the net of a value, and its view."""
    obj = doc.addObject("App::FeaturePython", name)
    PlainSolid(obj)
    SolidView(obj.ViewObject)
    show(obj, value)
    doc.recompute()
    return obj


def show(obj, value):
    """Gives an object the net of another value."""
    obj.Points = [FreeCAD.Vector(*point[:3]) for point in value.points]
    obj.Weights = list(value.weights) if value.is_rational else []
    obj.FourthCoordinates = [point[3] for point in value.points] if value.dimension == 4 else []


def folded():
    """A solid that folds over itself at corner 3, which is pushed almost to corner 0."""
    value = solids.random(3, 1)
    points = value.points
    points[-1] = 0.9 * points[0] + 0.1 * points[10]
    return osculate.BezierTetrahedron(3, points, value.weights)


class DrawnCase(GuiCase):
    def look(self, view_name="viewIsometric"):
        self.view().setAnimationEnabled(False)
        getattr(self.view(), view_name)()
        self.view().fitAll()
        self.pump()

    def reloaded(self, obj):
        """The object after its document was saved, closed and opened."""
        path = os.path.join(os.environ["OSCULATE_GUI_OUTPUT"], "solid.FCStd")
        name = obj.Name
        self.doc.saveAs(path)
        FreeCAD.closeDocument(self.doc.Name)
        self.doc = FreeCAD.openDocument(path)
        self.pump()
        return self.doc.getObject(name)

    def clear_selection(self):
        FreeCADGui.Selection.clearSelection()
        self.pump()
