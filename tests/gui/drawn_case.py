"""Bézier solids for the GUI tests."""

import os

import FreeCAD
import FreeCADGui
import numpy
import osculate
from pivy import coin

from gui_case import GuiCase
from osculate import solids
from osculate.features.bezier_solid import settings_of
from osculate.gui.qt import QtGui


def show(obj, value):
    """Gives a BezierSolid the net of another value."""
    for name, setting in settings_of(value).items():
        setattr(obj, name, setting)
    obj.Document.recompute()


def nodes_of(obj, kind):
    """The nodes of a Coin class that are drawn of an object."""
    search = coin.SoSearchAction()
    search.setType(coin.SoType.fromName(kind))
    search.setInterest(coin.SoSearchAction.ALL)
    search.apply(obj.ViewObject.RootNode)
    paths = search.getPaths()
    return [paths[i].getTail() for i in range(paths.getLength())]


def triangles_of(obj):
    """The number of triangles in the scene."""
    return sum(node.coordIndex.getNum() // 4 for node in nodes_of(obj, "IndexedFaceSet"))


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

    @staticmethod
    def difference(first, second):
        """The largest difference of a channel of two QImages, 0 to 255."""
        form = QtGui.QImage.Format.Format_RGBA8888
        images = [image.convertToFormat(form) for image in (first, second)]  # that own the bits
        bits = [numpy.frombuffer(image.constBits(), numpy.uint8).astype(int) for image in images]
        return int(abs(bits[0] - bits[1]).max())

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
