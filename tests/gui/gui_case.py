"""What GUI tests have in common: a document of their own, clicks, waiting, screenshots."""

import importlib
import os
import sys
import time
import unittest

import FreeCAD
import FreeCADGui
import numpy

from osculate.gui import preferences
from osculate.gui.canvas import widgets_of
from osculate.gui.panel.panel_form import PanelForm
from osculate.gui.qt import Qt, QtCore, QtGui, QtWidgets

QTest = importlib.import_module(QtCore.QObject.__module__.split(".")[0] + ".QtTest").QTest

LIGHT, DARK = 0xFFFFFFFF, 0x202428FF
_OUTPUT = os.environ["OSCULATE_GUI_OUTPUT"]
_VIEW = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/View")


class GuiCase(unittest.TestCase):
    """A fresh document and default preferences for each test; no error may be left unseen."""

    form_type = PanelForm  #: the class of the form that `form` finds

    def setUp(self):
        preferences.parameters().Clear()
        self.uncaught = []
        sys.excepthook = lambda kind, error, trace: self.uncaught.append(repr(error))
        self.report_view().clear()
        FreeCADGui.getMainWindow().resize(1600, 1000)
        self.doc = FreeCAD.newDocument("Test")
        FreeCADGui.activateWorkbench("OsculateWorkbench")
        self.set_background(LIGHT)

    def tearDown(self):
        FreeCADGui.Control.closeDialog()
        self.pump()
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)
        self.pump()
        self.assertEqual(self.uncaught, [])
        self.assertNotIn("Traceback", self.report_view().toPlainText())

    @staticmethod
    def report_view():
        return FreeCADGui.getMainWindow().findChild(QtWidgets.QTextEdit, "Report view")

    # Events

    @staticmethod
    def pump():
        """Lets everything that is due happen."""
        for _ in range(5):
            QtWidgets.QApplication.processEvents()

    def wait_for(self, condition, what, seconds=10.0):
        """Pumps events until the condition holds."""
        end = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > end:
                self.fail(f"waited {seconds:g} s for {what}")
            QtWidgets.QApplication.processEvents()
            time.sleep(0.005)

    # The panel

    def run_command(self):
        FreeCADGui.runCommand("Osculate_AnalyzeJoin")
        self.wait_for(lambda: self.form() is not None and self.form().isVisible(), "the panel")
        return self.form()

    def form(self):
        """The panel's form, or None."""
        dialogs = [widget for widget in FreeCADGui.getMainWindow().findChildren(QtWidgets.QWidget)
                   if isinstance(widget, self.form_type)]
        return dialogs[0] if dialogs else None

    def select(self, *targets):
        """Selects (object, sub-element) pairs and waits until the panel was told."""
        FreeCADGui.Selection.clearSelection()
        for obj, sub in targets:
            FreeCADGui.Selection.addSelection(self.doc.Name, obj.Name, sub)
        self.pump()

    def analyze(self, *targets):
        """The command on a selection."""
        self.select(*targets)
        return self.run_command()

    def click(self, widget):
        is_box = isinstance(widget, QtWidgets.QCheckBox)  # broader than what can be clicked of it
        place = QtCore.QPoint(8, widget.height() // 2) if is_box else widget.rect().center()
        QTest.mouseClick(widget, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, place)
        self.pump()

    def type_number(self, box, text):
        box.setFocus()
        box.selectAll()
        QTest.keyClicks(box, text)
        QTest.keyClick(box, Qt.Key.Key_Return)
        self.pump()

    def close_panel(self):
        button = next(box.button(QtWidgets.QDialogButtonBox.StandardButton.Close)
                      for box in FreeCADGui.getMainWindow().findChildren(QtWidgets.QDialogButtonBox)
                      if box.button(QtWidgets.QDialogButtonBox.StandardButton.Close))
        self.click(button)
        self.wait_for(lambda: self.form() is None, "the panel to close")

    # The 3D view

    def view(self):
        return FreeCADGui.getDocument(self.doc.Name).ActiveView

    def click_at(self, point, modifiers=Qt.KeyboardModifier.NoModifier):
        """Clicks at an edge at a point of the model in the 3D view, as a user does."""
        view = self.view()
        _, canvas = widgets_of(view)
        x, y = view.getPointOnScreen(point)
        place = QtCore.QPoint(x, canvas.height() - 1 - y)
        QTest.mouseMove(canvas, place)
        self.wait_for(lambda: FreeCADGui.Selection.getPreselection().SubElementNames,
                      "the edge under the mouse")
        QTest.mouseClick(canvas, Qt.MouseButton.LeftButton, modifiers, place)

    @staticmethod
    def set_background(color):
        _VIEW.SetBool("Gradient", False)
        _VIEW.SetBool("Simple", True)
        _VIEW.SetUnsigned("BackgroundColor", color)

    def fit(self):
        self.view().setAnimationEnabled(False)
        self.view().viewTop()
        self.view().fitAll()
        self.pump()

    def image(self, name, size=(900, 600)):
        """The 3D view as a QImage; also kept in the output folder."""
        path = os.path.join(_OUTPUT, f"{name}.png")
        self.view().saveImage(path, *size, "Current")
        return QtGui.QImage(path)

    def screenshot(self, name):
        """The whole screen, for looking at."""
        self.pump()
        screen = QtGui.QGuiApplication.primaryScreen()
        screen.grabWindow(0).save(os.path.join(_OUTPUT, f"{name}.png"))

    @staticmethod
    def count_pixels(image, color, spread=6):
        """How many pixels have the colour "#rrggbb", give or take `spread` in each channel."""
        rows = image.convertToFormat(QtGui.QImage.Format.Format_RGBA8888)
        pixels = numpy.frombuffer(rows.constBits(), numpy.uint8).reshape(-1, 4)[:, :3]
        wanted = numpy.array(QtGui.QColor(color).getRgb()[:3], int)
        return int((abs(pixels.astype(int) - wanted) <= spread).all(axis=1).sum())
