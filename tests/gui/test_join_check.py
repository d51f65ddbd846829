"""The object JoinCheck: kept from the panel, in the tree, in the view, in files."""

import os
import subprocess
import tempfile
import textwrap

import FreeCAD
import FreeCADGui

import samples
from gui_case import GuiCase
from osculate.gui import colors
from osculate.gui.qt import QtWidgets


class JoinCheckCase(GuiCase):
    def setUp(self):
        super().setUp()
        self.doc.UndoMode = 1
        self.line, self.arc = samples.line_and_arc(self.doc)

    def keep(self):
        form = self.analyze((self.line, "Edge1"), (self.arc, "Edge1"))
        self.click(form.actions.keep)
        return self.doc.JoinCheck

    def icon(self, obj):
        return os.path.basename(obj.ViewObject.Proxy.getIcon())


class KeepTest(JoinCheckCase):
    def test_object_says_what_the_panel_said(self):
        check = self.keep()
        self.assertEqual((check.Continuity, check.Order, check.Status), ("G1", 1, "OK"))
        self.assertEqual(check.Verdicts, ["pass", "pass", "fail", "fail", "fail"])
        self.assertIn("JoinCheck was added", self.form().advice.text())

    def test_options_of_the_panel_are_kept(self):
        form = self.analyze((self.line, "Edge1"), (self.arc, "Edge1"))
        self.type_number(form.tolerances.values[2], "150")
        form.tolerances.order.setValue(2)
        self.click(form.edges.nearest)
        self.click(form.actions.keep)
        check = self.doc.JoinCheck
        self.assertEqual((check.Preset, check.OrderAsked, check.Ends), ("custom", 2, "end-start"))
        self.assertAlmostEqual(check.CurvatureTolerance, 1.5)
        self.assertEqual(check.Continuity, "G2")

    def test_is_one_step_of_undo(self):
        names = [obj.Name for obj in self.doc.Objects]
        undos = self.doc.UndoCount
        self.keep()
        self.assertEqual(self.doc.UndoCount, undos + 1)
        self.doc.undo()
        self.assertEqual([obj.Name for obj in self.doc.Objects], names)
        self.doc.redo()
        self.assertEqual(self.doc.JoinCheck.Continuity, "G1")

    def test_knot_of_a_spline(self):
        sketch = samples.profile(self.doc)
        form = self.analyze((sketch, "Edge4"))
        self.click(form.actions.keep)
        self.assertEqual((self.doc.JoinCheck.Knot, self.doc.JoinCheck.Continuity), (1, "G4"))

    def test_edges_of_two_documents_are_analysed_but_not_kept(self):
        other = FreeCAD.newDocument("Other")
        _, arc = samples.line_and_arc(other)
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(self.doc.Name, "Line", "Edge1")
        FreeCADGui.Selection.addSelection(other.Name, arc.Name, "Edge1")
        form = self.run_command()
        self.assertIn("<b>G1</b>", form.banner.text.text())
        self.click(form.actions.keep)
        self.assertIn("in one document", form.advice.text())
        self.assertIsNone(self.doc.getObject("JoinCheck"))

    def test_one_label_where_panel_and_object_show_the_same(self):
        self.fit()
        self.analyze((self.line, "Edge1"), (self.arc, "Edge1"))
        panel_only = self.count_pixels(self.image("label_panel"), colors.ORDERS[1])
        self.click(self.form().actions.keep)
        both = self.count_pixels(self.image("label_panel_and_object"), colors.ORDERS[1])
        self.assertLess(both, 1.3 * panel_only)
        self.close_panel()
        alone = self.count_pixels(self.image("label_object"), colors.ORDERS[1])
        self.assertGreater(alone, 0.7 * panel_only)


class TreeAndViewTest(JoinCheckCase):
    def setUp(self):
        super().setUp()
        self.check = self.keep()
        self.close_panel()

    def test_icon_and_label_follow_the_verdict(self):
        self.assertEqual(self.icon(self.check), "verdict-g1.svg")
        self.line.Placement.Base.z = 1.0
        self.doc.recompute()
        self.assertEqual(self.icon(self.check), "verdict-gap.svg")
        self.fit()
        self.assertGreater(self.count_pixels(self.image("object_gap"), colors.GAP), 300)

    def test_hidden_object_has_no_label(self):
        self.fit()
        self.check.Visibility = False
        self.assertEqual(self.count_pixels(self.image("object_hidden"), colors.ORDERS[1]), 0)

    def test_deleted_edge_shows_as_an_error(self):
        self.doc.removeObject(self.arc.Name)
        self.doc.recompute()
        self.assertEqual(self.check.Continuity, "error")
        self.assertIn("deleted", self.check.Status)
        self.assertEqual(self.icon(self.check), "verdict-error.svg")
        self.assertEqual(self.count_pixels(self.image("object_error"), colors.ORDERS[1]), 0)
        self.screenshot("object_error_tree")

    def test_survives_saving_and_loading(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "check.FCStd")
            self.doc.saveAs(path)
            FreeCAD.closeDocument(self.doc.Name)
            self.doc = FreeCAD.openDocument(path)
            self.pump()
            check = self.doc.JoinCheck
            self.assertEqual((check.Continuity, self.icon(check)), ("G1", "verdict-g1.svg"))
            self.assertNotIn("Touched", check.State)
            self.fit()
            self.assertGreater(self.count_pixels(self.image("loaded"), colors.ORDERS[1]), 300)
            self.doc.Line.Placement.Base.z = 1.0
            self.doc.recompute()
            self.assertEqual(check.Continuity, "gap")

    def test_copy_lives_on_its_own(self):
        copy = self.doc.copyObject(self.check, False)
        self.check.Preset = "creo"
        self.doc.recompute()
        self.assertEqual((copy.Preset, copy.Continuity), ("osculate", "G1"))
        self.assertEqual(self.icon(copy), "verdict-g1.svg")

    def test_opens_as_a_plain_object_without_the_addon(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "check.FCStd")
            self.doc.saveAs(path)
            script = os.path.join(folder, "open_it.py")
            with open(script, "w", encoding="utf-8") as file:
                file.write(textwrap.dedent(f"""
                    import os, FreeCAD
                    check = FreeCAD.openDocument({path!r}).JoinCheck
                    print("plain:", check.Continuity, check.Headline, flush=True)
                    os._exit(0)
                    """))
            environment = {**os.environ, "FREECAD_USER_HOME": folder}
            environment.pop("PYTHONPATH", None)
            result = subprocess.run(["freecadcmd", script], env=environment, timeout=60,
                                    capture_output=True, text=True, check=True)
            self.assertIn(f"plain: G1 {self.check.Headline}", result.stdout)


class EditTest(JoinCheckCase):
    def setUp(self):
        super().setUp()
        self.check = self.keep()
        self.close_panel()
        self.fit()

    def edit(self):
        """What a double-click in the tree does."""
        self.assertTrue(self.check.ViewObject.Proxy.doubleClicked(self.check.ViewObject))
        self.wait_for(lambda: self.form() is not None and self.form().isVisible(), "the panel")
        return self.form()

    def press(self, button):
        box = next(box for box in
                   FreeCADGui.getMainWindow().findChildren(QtWidgets.QDialogButtonBox)
                   if box.button(button))
        self.click(box.button(button))
        self.wait_for(lambda: self.form() is None, "the panel to close")

    def test_ok_keeps_changes_in_one_step_of_undo(self):
        form = self.edit()
        self.assertFalse(form.follow.isChecked())
        self.type_number(form.tolerances.values[2], "150")
        self.click(form.edges.swap)
        self.assertEqual(self.check.Continuity, "G2")
        self.press(QtWidgets.QDialogButtonBox.StandardButton.Ok)
        self.assertEqual(self.check.First[0].Name, "Arc")
        self.doc.undo()
        self.assertEqual((self.check.Continuity, self.check.First[0].Name), ("G1", "Line"))

    def test_cancel_leaves_the_document_as_it_was(self):
        undos = self.doc.UndoCount
        form = self.edit()
        form.tolerances.preset.setCurrentText("exact")
        self.pump()
        self.assertEqual(self.check.Preset, "exact")
        self.press(QtWidgets.QDialogButtonBox.StandardButton.Cancel)
        self.assertEqual((self.check.Preset, self.check.Continuity), ("osculate", "G1"))
        self.assertEqual(self.doc.UndoCount, undos)

    def test_looking_changes_nothing(self):
        undos = self.doc.UndoCount
        self.edit()
        self.press(QtWidgets.QDialogButtonBox.StandardButton.Ok)
        self.assertEqual(self.doc.UndoCount, undos)

    def test_other_edges_can_be_chosen(self):
        first, second = samples.cut_curve(self.doc)
        form = self.edit()
        self.click(form.follow)
        self.select((first, "Edge1"), (second, "Edge1"))
        self.press(QtWidgets.QDialogButtonBox.StandardButton.Ok)
        self.assertEqual((self.check.First[0].Name, self.check.Continuity), ("First", "G4"))

    def test_broken_link_can_be_mended(self):
        self.doc.removeObject(self.arc.Name)
        self.doc.recompute()
        first, second = samples.cut_curve(self.doc)
        form = self.edit()
        self.assertIn("Select two edges", form.advice.text())
        self.select((first, "Edge1"), (second, "Edge1"))
        self.press(QtWidgets.QDialogButtonBox.StandardButton.Ok)
        self.assertEqual((self.check.Status, self.check.Continuity), ("OK", "G4"))

    def test_deleting_an_edge_while_it_is_edited(self):
        form = self.edit()
        self.doc.removeObject(self.arc.Name)
        self.pump()
        self.assertIn("Arc no longer exists", form.trouble.text())
        form.tolerances.order.setValue(3)
        self.pump()
        self.press(QtWidgets.QDialogButtonBox.StandardButton.Cancel)

    def test_leaving_edit_mode_by_the_tree_closes_the_panel(self):
        self.edit()
        FreeCADGui.getDocument(self.doc.Name).resetEdit()
        self.wait_for(lambda: self.form() is None, "the panel to close")
        self.assertGreater(self.count_pixels(self.image("after_edit_mode"), colors.ORDERS[1]), 300)

    def test_deleting_the_object_while_it_is_edited(self):
        self.edit()
        self.doc.removeObject(self.check.Name)
        self.pump()
        self.assertIsNone(self.form())


class MadeWithoutGuiTest(GuiCase):
    def test_gets_icon_and_label_when_it_is_opened(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "headless.FCStd")
            script = os.path.join(folder, "make_it.py")
            with open(script, "w", encoding="utf-8") as file:
                file.write(textwrap.dedent(f"""
                    import os, sys, FreeCAD
                    sys.path.insert(0, {os.path.dirname(samples.__file__)!r})
                    import samples
                    from osculate.features import make_join_check
                    doc = FreeCAD.newDocument("Headless")
                    line, arc = samples.line_and_arc(doc)
                    make_join_check(doc, (line, "Edge1"), (arc, "Edge1"))
                    doc.saveAs({path!r})
                    os._exit(0)
                    """))
            subprocess.run(["freecadcmd", script], timeout=60, capture_output=True, check=True)
            self.doc = FreeCAD.openDocument(path)
        self.pump()
        for obj in self.doc.Objects:
            obj.Visibility = True  # files made without a GUI do not say
        self.fit()
        icon = self.doc.JoinCheck.ViewObject.Proxy.getIcon()
        self.assertEqual(os.path.basename(icon), "verdict-g1.svg")
        self.assertGreater(self.count_pixels(self.image("headless"), colors.ORDERS[1]), 300)
