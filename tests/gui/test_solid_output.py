"""To B-Rep solid, Export to ParaView, and when the commands of solids are there."""

import os
import tempfile

import FreeCAD
import FreeCADGui

from osculate import solids
from osculate.gui.commands.solids import SOLID_COMMANDS
from osculate.gui.commands.solids.export_solid import export
from osculate.gui.qt import QtCore, QtWidgets
from solid_case import SolidCase


class OutputTest(SolidCase):
    def test_brep_follows_and_is_one_step(self):
        obj = self.solid(solids.ball_octant(50))
        self.run_command("Osculate_SolidToBRep", obj)
        brep = self.doc.getObject("SolidBRep")
        self.assertEqual((brep.Status, brep.Shape.ShapeType), ("OK", "Solid"))
        self.assertFalse(obj.Visibility)
        self.assertIn(obj.Label, brep.Label)
        self.fit()
        self.screenshot("solid_brep")
        points = obj.Points
        points[0] = points[0] * 1.5
        obj.Points = points
        self.doc.recompute()
        self.assertAlmostEqual(brep.Shape.Volume / obj.Volume.Value, 1.0, delta=1e-5)
        self.doc.undo()
        self.assertEqual((self.doc.Objects, obj.Visibility), ([obj], True))

    def test_what_bounds_no_solid_stays_visible(self):
        obj = self.solid(((0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)))
        self.run_command("Osculate_SolidToBRep", obj)
        self.assertTrue(obj.Visibility)
        self.assertNotEqual(self.doc.getObject("SolidBRep").Status, "OK")

    def test_export(self):
        first, second = self.solid(), self.solid(solids.random(3, 1))
        with tempfile.TemporaryDirectory() as folder:
            expected, path = (os.path.join(folder, name) for name in ("a.vtu", "b.vtu"))
            export([first, second], path[:-4])
            solids.write_vtu([first.Proxy.value, second.Proxy.value], expected)
            with open(expected, "rb") as one, open(path, "rb") as other:
                self.assertEqual(one.read(), other.read())

    def test_what_cannot_be_exported_is_said(self):
        obj = self.solid(solids.random(2, 1, 4))
        seen = []

        def close():
            box = QtWidgets.QApplication.activeModalWidget()
            seen.append(box.text())
            box.close()
        QtCore.QTimer.singleShot(200, close)
        with tempfile.TemporaryDirectory() as folder:
            export([obj], os.path.join(folder, "c.vtu"))
            self.assertEqual(os.listdir(folder), [])
        self.assertIn("E4", seen[0])

    def test_commands_wait_for_solids(self):
        box = self.doc.addObject("Part::Box", "Box")
        obj = self.solid()
        free = {"Osculate_BezierSolid", "Osculate_SolidFromPoints"}
        for command in SOLID_COMMANDS:
            self.select((box, ""))
            self.assertEqual(self.is_active(command.name), command.name in free, command.name)
        self.select((obj, ""))
        self.assertTrue(self.is_active("Osculate_SolidToBRep"))

    def test_icons_are_there(self):
        for command in SOLID_COMMANDS:
            path = command().GetResources()["Pixmap"]
            self.assertTrue(os.path.exists(path), path)
            self.assertFalse(FreeCADGui.getIcon(path).isNull())

    def test_saved_and_loaded_in_the_gui(self):
        obj = self.solid(solids.ball_octant(50))
        value = obj.Proxy.value
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "solid.FCStd")
            self.doc.saveAs(path)
            FreeCAD.closeDocument(self.doc.Name)
            self.doc = FreeCAD.openDocument(path)
            self.pump()
            self.assertEqual(self.doc.BezierSolid.Proxy.value, value)
