"""What the scripts that draw the pictures of the documentation have in common."""

import math
import os
import sys
import time
import traceback

import FreeCAD
import FreeCADGui
import Part

from osculate.gui import preferences
from osculate.gui.qt import QtCore, QtGui, QtWidgets

FOLDER = os.path.dirname(os.path.abspath(__file__))
LIGHT, DARK = 0xF7F8FAFF, 0x23272EFF
INK = (0.25, 0.3, 0.36)
V = FreeCAD.Vector


def run(main):
    """Draws in a plain window, then ends FreeCAD."""
    status = 1
    try:
        print("--- begin ---", file=sys.__stdout__)
        window = FreeCADGui.getMainWindow()
        window.resize(1400, 900)
        window.move(0, 0)
        hide_docks()
        FreeCADGui.activateWorkbench("OsculateWorkbench")
        preferences.parameters().Clear()
        set_background(LIGHT)
        main()
        status = 0
    except BaseException:
        traceback.print_exc(file=sys.__stdout__)
    sys.__stdout__.flush()
    os._exit(status)


def save_view(document, name, width, height):
    """The 3D view alone."""
    FreeCADGui.getDocument(document.Name).ActiveView.saveImage(
        os.path.join(FOLDER, f"{name}.png"), width, height, "Current")


def find_form(kind):
    """The form of a class that is open."""
    return next(widget for widget in FreeCADGui.getMainWindow().findChildren(QtWidgets.QWidget)
                if isinstance(widget, kind))


def look(document, view_name, magnified=1.0):
    """Fits the model into a standard view, and then goes nearer."""
    view = FreeCADGui.getDocument(document.Name).ActiveView
    view.setAnimationEnabled(False)
    view.setCameraType("Orthographic")
    getattr(view, view_name)()
    view.fitAll()
    height = view.getCameraNode().height
    height.setValue(height.getValue() / magnified)
    pump()


def ink(document):
    """Draws all curves of a document plainly."""
    for obj in document.Objects:
        obj.ViewObject.LineWidth = 3.0
        obj.ViewObject.LineColor = INK


def arc(center, radius, first, last):
    circle = Part.Circle(center, V(0, 0, 1), radius)
    return Part.ArcOfCircle(circle, math.radians(first), math.radians(last))


def set_background(color):
    group = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/View")
    group.SetBool("Gradient", False)
    group.SetBool("Simple", True)
    group.SetUnsigned("BackgroundColor", color)


def widen_tree():
    """Makes room in the dock for the tree and for what it says of the selected object."""
    window = FreeCADGui.getMainWindow()
    docks = [dock for dock in window.findChildren(QtWidgets.QDockWidget) if dock.isVisible()]
    window.resizeDocks(docks, [330] * len(docks), QtCore.Qt.Orientation.Horizontal)
    for dock in docks:
        for splitter in dock.findChildren(QtWidgets.QSplitter):
            splitter.setSizes([370, 360])
    pump()


def hide_docks(*others):
    """Leaves only the tree, the panel and others that are named; the report view opens by itself
    where it warns.
    """
    for dock in FreeCADGui.getMainWindow().findChildren(QtWidgets.QDockWidget):
        dock.setVisible(dock.objectName() in ("Combo View", "Tasks", *others))


def grab(name, *docks):
    """The window as the screen shows it, with the docks that are named."""
    hide_docks(*docks)
    pump()
    size = FreeCADGui.getMainWindow().size()
    screen = QtGui.QGuiApplication.primaryScreen()
    picture = screen.grabWindow(0, 0, 0, size.width(), size.height())
    picture.save(os.path.join(FOLDER, f"{name}.png"))


def grab_edited(obj, view_name, magnified, name):
    """The window while an object is edited; closes its document then."""
    document = obj.Document
    obj.ViewObject.doubleClicked()
    pump()
    look(document, view_name, magnified)
    grab(name)
    FreeCADGui.Control.closeDialog()
    FreeCAD.closeDocument(document.Name)


def pump(seconds=0.5):
    """Lets FreeCAD paint."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        QtWidgets.QApplication.processEvents()
        time.sleep(0.005)
