"""The command Match and its panel, used with mouse and keyboard."""

import FreeCAD
import FreeCADGui
import Part

import samples
from construct_case import ConstructCase
from osculate.gui import colors
from osculate.gui.construct.match_form import MatchForm

V = FreeCAD.Vector


class MatchCase(ConstructCase):
    form_type = MatchForm
    command = "Osculate_Match"

    def setUp(self):
        super().setUp()
        self.reference = samples.add_edge(
            self.doc, "Stays", samples.bezier((0, 0, 0), (20, 0, 0), (40, 10, 0), (50, 20, 0)))
        curve = Part.BSplineCurve()
        curve.interpolate([V(52, 16, 0), V(65, 20, 0), V(80, 25, 2), V(95, 20, 4), V(110, 10, 0),
                           V(125, 15, 0), V(140, 10, 0)])
        self.changed = samples.add_edge(self.doc, "Changes", curve)
        self.doc.recompute()
        self.fit()

    def match(self):
        return self.run_on((self.reference, "Edge1"), (self.changed, "Edge1"))


class StartTest(MatchCase):
    def test_two_selected_edges_are_matched_at_once(self):
        form = self.match()
        obj = self.doc.MatchedCurve
        self.assertEqual((obj.Status, obj.Continuity[0]), ("OK", "G2"))
        self.assertEqual((form.reference.name.text(), form.changed.name.text()),
                         ("Stays.Edge1", "Changes.Edge1"))
        self.assertIn("No point moves farther than", form.displacement.text())
        self.assertEqual(len([join for join in form.verdicts.joins if join.banner.isVisible()]), 2)
        self.screenshot("match_panel")

    def test_edges_are_asked_for(self):
        form = self.run_on()
        self.assertIn("the edge that stays", form.advice.text())
        self.screenshot("match_asks")
        self.select((self.reference, "Edge1"))
        self.assertTrue(form.changed.pick.isChecked())
        self.select((self.changed, "Edge1"))
        self.assertEqual(self.doc.MatchedCurve.Status, "OK")
        self.finish("Cancel")


class EndTest(MatchCase):
    def test_ok_is_one_step_of_undo(self):
        undos = self.doc.UndoCount
        form = self.match()
        self.click(form.order.buttons[1])
        self.click(form.hide_original)
        self.assertFalse(self.changed.Visibility)
        self.finish("Ok")
        self.assertEqual(self.doc.UndoCount, undos + 1)
        self.assertFalse(self.changed.ViewObject.Visibility)
        self.doc.undo()
        self.assertEqual(self.names(), ["Stays", "Changes"])
        self.assertTrue(self.changed.ViewObject.Visibility)

    def test_cancel_leaves_the_document_as_it_was(self):
        undos = self.doc.UndoCount
        form = self.match()
        self.click(form.hide_original)
        self.finish("Cancel")
        self.assertEqual((self.names(), self.doc.UndoCount), (["Stays", "Changes"], undos))
        self.assertTrue(self.changed.ViewObject.Visibility)
        self.assertEqual(self.marked_pixels(), 0)

    def test_editing(self):
        self.match()
        self.finish("Ok")
        obj = self.doc.MatchedCurve
        before = obj.Shape.Length
        form = self.edit(obj)
        self.click(form.order.buttons[4])
        self.assertNotEqual(obj.Shape.Length, before)
        self.finish("Cancel")
        self.assertEqual((obj.Shape.Length, obj.Order), (before, 2))

    def test_deleting_shows_the_edge_as_it_was(self):
        self.click(self.match().hide_original)
        self.finish("Ok")
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(self.doc.MatchedCurve)
        FreeCADGui.runCommand("Std_Delete")
        self.pump()
        self.assertEqual(self.names(), ["Stays", "Changes"])
        self.assertTrue(self.changed.ViewObject.Visibility)

    def marked_pixels(self):
        return self.count_pixels(self.image("match_cancelled"), colors.SIDES[1])


class FormTest(MatchCase):
    def setUp(self):
        super().setUp()
        self.form_ = self.match()
        self.obj = self.doc.MatchedCurve

    def test_orders(self):
        for order in (0, 1, 3, 4):
            self.click(self.form_.order.buttons[order])
            self.assertEqual((self.obj.Order, self.obj.Status), (order, "OK"))
            self.assertGreaterEqual(self.obj.Orders[0], order)

    def test_what_the_far_end_keeps(self):
        self.click(self.form_.keep.buttons[1])
        self.assertEqual((self.obj.Keep, self.obj.Status), (1, "OK"))
        self.assertEqual(self.form_.keep.buttons[1].text(), "C1")

    def test_spans_and_degree(self):
        self.form_.spans.setValue(1)
        self.pump()
        self.assertIn("at least 3", self.form_.trouble.text())
        self.form_.spans.setValue(3)
        self.pump()
        self.assertEqual((self.obj.Spans, self.obj.ChangedSpans), (3, 3))
        self.assertEqual(self.form_.degree.text(), "least (3)")
        self.form_.degree.setValue(6)
        self.pump()
        self.assertEqual(self.obj.CurveDegree, 6)

    def test_ends(self):
        self.click(self.form_.changed_end)
        self.assertEqual((self.obj.ChangedEnd, self.obj.EndsMade), ("end", "end-end"))
        self.form_.reference_end.actions_["inside-forward"].trigger()
        self.pump()
        self.assertTrue(self.form_.position.isVisible())
        self.assertEqual(self.obj.ReferenceEnd, "inside-forward")

    def test_swap(self):
        self.click(self.form_.swap)
        self.assertEqual((self.obj.Reference[0].Name, self.obj.Changed[0].Name),
                         ("Changes", "Stays"))
        self.assertEqual((self.obj.Status, self.form_.changed.name.text()), ("OK", "Stays.Edge1"))
        self.click(self.form_.back)
        self.assertEqual(self.obj.Changed[0].Name, "Changes")
        self.assertEqual(self.form_.changed.name.text(), "Changes.Edge1")

    def test_numbers(self):
        self.click(self.form_.section.header)
        row = self.form_.beta.rows[0]
        before = self.obj.MaxDisplacement.Value
        self.type_number(row.box, "2")
        self.assertEqual((self.obj.Beta1, self.obj.Beta1Fixed), (2.0, True))
        self.assertNotEqual(self.obj.MaxDisplacement.Value, before)
        self.screenshot("match_numbers")
        self.click(row.lock)
        self.assertFalse(self.obj.Beta1Fixed)

    def test_displacement_is_drawn(self):
        picture = self.image("match_view")
        self.assertGreater(self.count_pixels(picture, colors.SIDES[1]), 300)
        self.assertGreater(self.count_pixels(picture, "#7c8794", 20), 30)

    def test_energies_compare_with_the_edge_as_it_was(self):
        self.assertIn("bending", self.form_.energies.text())
        self.assertIn("%", self.form_.energies.text())

    def test_trouble(self):
        self.click(self.form_.order.buttons[4])
        self.form_.degree.setValue(3)
        self.pump()
        self.assertIn("degree", self.form_.trouble.text())
        self.assertFalse(self.form_.displacement.isVisible())
        self.screenshot("match_trouble")

    def test_dark(self):
        self.darken()
        self.screenshot("match_dark")
