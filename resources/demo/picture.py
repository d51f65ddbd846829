"""The demo on a screen: draws joins.FCStd into joins.png, part.png and blend.png, the panel into
panel.png.

Run by resources/demo/run inside FreeCAD, where a script that raises would leave the window open.
"""
import os
import sys
import time
import traceback
from pathlib import Path

import FreeCAD
import FreeCADGui

from osculate.gui.colors import SIDES
from osculate.gui.qt import QtGui, QtWidgets

import models

OUTPUT = Path(os.environ["OSCULATE_DEMO_OUTPUT"])
SECONDS_TO_PAINT = 0.5
SECONDS_TO_WAIT = 20.0
SAMPLE = tuple(f"G{order}{part}" for order in range(5) for part in "ab")
CLOSE_UP = "G2"
BLEND = ("Kept1", "BlendCurve", "Kept2")
BLEND_COLOR = (1.0, 1.0, 1.0)


def pump(seconds):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        QtWidgets.QApplication.processEvents()


def wait_until(condition, what):
    end = time.monotonic() + SECONDS_TO_WAIT
    while not condition():
        if time.monotonic() > end:
            raise TimeoutError(what)
        pump(0.05)


def rgb(color):
    return tuple(int(color[i:i + 2], 16) / 255 for i in (1, 3, 5))


def dress(document):
    """Colours the two sides of the sample, thickens the curves, hides their vertices."""
    for obj in document.Objects:
        if hasattr(obj, "Shape"):
            obj.ViewObject.LineWidth = 3
            obj.ViewObject.PointSize = 1
    document.getObject("SOT428_DPAK").ViewObject.Transparency = 40
    for name in SAMPLE:
        document.getObject(name).ViewObject.LineColor = rgb(SIDES["ab".index(name[-1])])
    for name, color in zip(BLEND, (rgb(SIDES[0]), BLEND_COLOR, rgb(SIDES[1]))):
        document.getObject(name).ViewObject.LineColor = color
        document.getObject(name).ViewObject.LineWidth = 5


def show(document, names, with_checks=True):
    """Shows the named objects and the checks of their joins, nothing else."""
    for obj in document.Objects:
        checked = getattr(obj, "First", None)
        obj.ViewObject.Visibility = obj.Name in names or (
            with_checks and checked is not None and checked[0].Name in names)


def draw(view, name, zoom):
    """The 3D view as it stands, fitted, then magnified (fitting leaves room for a turn)."""
    view.fitAll()
    height = view.getCameraNode().height
    height.setValue(height.getValue() / zoom)
    pump(SECONDS_TO_PAINT)
    view.saveImage(str(OUTPUT / name), 1600, 1000, "Current")


def draw_models(document, view):
    show(document, SAMPLE + ("Outline",))
    view.viewTop()
    draw(view, "joins.png", 1.4)
    show(document, ("SOT428_DPAK",))
    view.viewAxonometric()
    draw(view, "part.png", 1.1)
    show(document, BLEND)
    face_plane_of(document.getObject("BlendCurve").Shape, view)
    draw(view, "blend.png", 1.0)


def face_plane_of(shape, view):
    """Turns the view to look at a plane curve from in front."""
    normal = shape.findPlane().Axis
    view.setCameraOrientation(FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), normal).Q)


def grab_panel(document, view):
    """The screen with the panel on one pair of the sample."""
    pair = (f"{CLOSE_UP}a", f"{CLOSE_UP}b")
    show(document, pair, with_checks=False)
    view.viewAxonometric()
    view.fitAll()
    FreeCADGui.Selection.clearSelection()
    for name in pair:
        FreeCADGui.Selection.addSelection(document.Name, name, "Edge1")
    FreeCADGui.runCommand("Osculate_AnalyzeJoin")
    wait_until(FreeCADGui.Control.activeDialog, "the panel did not open")
    pump(SECONDS_TO_PAINT)
    screen = QtGui.QGuiApplication.primaryScreen()
    if not screen.grabWindow(0).save(str(OUTPUT / "panel.png")):
        raise RuntimeError("panel.png could not be written")
    FreeCADGui.Control.closeDialog()


def main():
    window = FreeCADGui.getMainWindow()
    window.resize(1600, 1000)
    for dock in window.findChildren(QtWidgets.QDockWidget):
        dock.setVisible(dock.objectName() in ("Combo View", "Tasks"))
    FreeCADGui.activateWorkbench("OsculateWorkbench")
    document = FreeCAD.openDocument(str(OUTPUT / "joins.FCStd"))
    view = FreeCADGui.getDocument(document.Name).activeView()
    view.setAnimationEnabled(False)  # it would turn the view back from where it was fitted
    pump(SECONDS_TO_PAINT)
    dress(document)
    draw_models(document, view)
    grab_panel(document, view)
    for obj in document.Objects:
        obj.ViewObject.Visibility = True
    models.keep_no_backups()
    document.save()


try:
    main()
    code = 0
except BaseException:
    traceback.print_exc(file=sys.stdout)
    code = 1
sys.stdout.flush()
os._exit(code)
