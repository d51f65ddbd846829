"""The dock Curve plot: saved to files, in another language, beside other bindings of Qt."""

import csv
import os
import sys
import tempfile
from unittest import mock

import FreeCADGui

import samples
from osculate.gui import matplotlib_qt
from osculate.gui.plot.plot_dock import PlotDock
from osculate.gui.qt import Qt, QtWidgets
from plot_case import PlotCase


class SaveTest(PlotCase):
    def setUp(self):
        super().setUp()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        line, arc = samples.line_and_arc(self.doc)
        self.plot((line, ""), (arc, ""))

    def save_as(self, name, chosen=""):
        path = os.path.join(self.folder, name)
        with mock.patch.object(QtWidgets.QFileDialog, "getSaveFileName",
                               return_value=(path, chosen)):
            self.click(self.tools.save)
        return path

    def test_pictures_and_values(self):
        for name in ("a.svg", "a.pdf", "a.png", "a.csv"):
            path = self.save_as(name)
            self.assertIn("Saved to", self.tools.advice.text())
            self.assertGreater(os.path.getsize(path), 1000)
        with open(path, newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual({row["label"] for row in rows}, {"Line.Edge1", "Arc.Edge1"})
        self.assertEqual([row["join"] for row in rows if row["join"]], ["G1", "G1"])

    def test_the_chosen_kind_gives_the_ending(self):
        self.save_as("b", "PDF (*.pdf)")
        self.assertEqual(os.listdir(self.folder), ["b.pdf"])

    def test_what_cannot_be_written_is_said(self):
        self.save_as("missing/a.svg")
        self.assertIn("No such file", self.tools.advice.text())
        self.save_as("a.txt")
        self.assertIn("must end with one of", self.tools.advice.text())
        self.assertEqual(os.listdir(self.folder), [])

    def test_another_file_is_not_replaced_without_a_question(self):
        path = os.path.join(self.folder, "b.svg")
        with open(path, "w", encoding="utf-8") as file:
            file.write("old")
        self.save_as("b", "SVG (*.svg)")
        self.assertIn("b.svg exists", self.tools.advice.text())
        with open(path, encoding="utf-8") as file:
            self.assertEqual(file.read(), "old")

    def test_cancelled(self):
        with mock.patch.object(QtWidgets.QFileDialog, "getSaveFileName", return_value=("", "")):
            self.click(self.tools.save)
        self.assertEqual(os.listdir(self.folder), [])


class BindingTest(PlotCase):
    def test_other_bindings_of_qt_do_not_lead_matplotlib_astray(self):
        others = {"PyQt6.QtCore": object(), "PyQt5.QtCore": object()}
        with mock.patch.dict("sys.modules", others):
            with matplotlib_qt.ours_alone():
                self.assertTrue(others.keys().isdisjoint(sys.modules))
            self.assertLessEqual(others.keys(), sys.modules.keys())


class GermanTest(PlotCase):
    def setUp(self):
        super().setUp()
        FreeCADGui.setLocale("German")
        self.pump()

    def tearDown(self):
        FreeCADGui.setLocale("English")
        super().tearDown()

    def test_words(self):
        line, _ = samples.line_and_arc(self.doc)
        window = FreeCADGui.getMainWindow()
        dock = PlotDock(window)
        self.addCleanup(dock.deleteLater)
        self.addCleanup(dock.close)
        window.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, dock)
        self.select((line, ""))
        dock.show()
        self.wait_for(lambda: dock.source.plot is not None, "the plot")
        self.pump()
        self.assertEqual(dock.windowTitle(), "Kurvenverlauf")
        self.assertEqual(dock.form.lock.text(), "Maßstab festhalten")
        drawing = dock.form.canvas.drawing
        self.assertEqual(drawing.look.words["missing"], "gibt es nicht")
        self.assertLessEqual(dock.form.minimumSizeHint().width(), 520)
        self.screenshot("plot_german")
