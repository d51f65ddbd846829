"""From a row of an audit to Match and back."""

import FreeCAD
import FreeCADGui
import numpy
import Part

import samples
from construct_case import ConstructCase
from osculate.features import make_audit
from osculate.gui import colors
from osculate.gui.audit.audit_form import AuditForm
from osculate.gui.audit.fix import Fix
from osculate.gui.construct.match_form import MatchForm

V = FreeCAD.Vector


class FixCase(ConstructCase):
    form_type = AuditForm

    def setUp(self):
        super().setUp()
        self.line, self.arc = samples.line_and_arc(self.doc)
        self.obj = make_audit(self.doc, [self.line, self.arc], required=2)
        self.fit()

    def edit_audit(self, line=0):
        """The panel of the audit with a row clicked."""
        self.form_type = AuditForm
        form = self.edit(self.obj)
        form.table.selectRow(line)
        self.pump()
        return form

    def match(self, form):
        """Match of the current row; returns its form."""
        self.click(form.match)
        self.form_type = MatchForm
        return self.shown_form()

    def back(self, button):
        """Ends Match; returns the form of the audit, which comes back."""
        self.press(button)
        self.form_type = AuditForm
        self.wait_for(lambda: self.form() is not None and self.form().isVisible(), "the audit")
        self.pump()
        return self.form()


class MatchTest(FixCase):
    def test_match_opens_with_edges_ends_and_order_and_shows_its_effect(self):
        form = self.match(self.edit_audit())
        fix = self.doc.MatchedCurve
        self.assertEqual((fix.Reference[0].Name, fix.Changed[0].Name), ("Line", "Arc"))
        self.assertEqual((fix.Order, fix.ReferenceEnd, fix.ChangedEnd, fix.Status),
                         (2, "end", "start", "OK"))
        self.assertTrue(fix.HideOriginal)
        self.assertIn("No point moves farther than", form.displacement.text())
        self.assertGreater(self.count_pixels(self.image("fix_view"), colors.SIDES[1]), 100)
        self.screenshot("fix_match")
        self.back("Cancel")

    def test_ok_fixes_the_row_in_one_step_of_undo(self):
        form = self.edit_audit()
        undos = self.doc.UndoCount
        self.match(form)
        form = self.back("Ok")
        self.assertEqual(self.doc.UndoCount, undos + 1)
        self.assertEqual((self.obj.Status, self.obj.OutOfTolerance), ("OK", 0))
        self.assertEqual([fix.Name for fix in self.obj.Fixes], ["MatchedCurve"])
        self.assertFalse(self.arc.Visibility)
        self.assertEqual(form.table.current, 0)
        self.assertIn("none below G2", form.summary.text())
        self.assertIn("MatchedCurve", form.sources.text())
        self.assertIn("MatchedCurve.Edge1", form.table.rows_shown.data(
            form.table.rows_shown.index(0, 2)))
        self.screenshot("fix_done")
        self.finish("Ok")
        self.doc.undo()
        self.assertEqual(self.names(), ["Line", "Arc", "Audit"])
        self.assertEqual((self.obj.OutOfTolerance, self.obj.Fixes), (1, []))
        self.pump()
        joins = self.obj.ViewObject.Proxy._joins
        self.assertEqual((joins.counts, joins.labels), ({1: 1}, 1))
        self.doc.redo()
        self.pump()
        self.assertEqual((self.obj.OutOfTolerance, len(self.obj.Fixes)), (0, 1))
        self.assertEqual((joins.counts, joins.labels), ({2: 1}, 0))

    def test_cancel_leaves_the_row_as_it_was(self):
        form = self.edit_audit()
        undos = self.doc.UndoCount
        self.match(form)
        form = self.back("Cancel")
        self.assertEqual((self.names(), self.doc.UndoCount), (["Line", "Arc", "Audit"], undos))
        self.assertEqual((self.obj.OutOfTolerance, self.obj.Fixes), (1, []))
        self.assertTrue(self.arc.Visibility)
        self.assertEqual(form.table.current, 0)
        self.finish("Cancel")

    def test_a_new_audit_is_kept_before_its_row_is_matched(self):
        self.doc.removeObject(self.obj.Name)
        self.form_type, self.command = AuditForm, "Osculate_Audit"
        form = self.run_on((self.line, ""), (self.arc, ""))
        self.obj = self.doc.Audit
        form.options.required.setValue(2)
        form.table.selectRow(0)
        self.pump()
        self.match(form)
        form = self.back("Ok")
        self.assertEqual(self.obj.OutOfTolerance, 0)
        self.finish("Ok")
        self.doc.undo()
        self.assertEqual(self.names(), ["Line", "Arc", "Audit"])

    def test_the_audit_may_go_meanwhile(self):
        self.match(self.edit_audit())
        self.doc.removeObject(self.obj.Name)
        self.press("Ok")
        self.pump()
        self.assertIsNone(FreeCADGui.Control.activeDialog() or None)
        self.assertIn("MatchedCurve", self.names())

    def test_an_edge_that_meets_the_required_order_gets_the_next_one(self):
        self.obj.Required = 1
        self.doc.recompute()
        self.match(self.edit_audit())
        self.assertEqual(self.doc.MatchedCurve.Order, 2)
        self.back("Cancel")


class WhyNotTest(FixCase):
    def reason(self, source, line=0):
        self.obj.Sources, self.obj.Pairs = [(source, "")], "all"
        self.doc.recompute()
        form = self.edit_audit(line)
        self.assertFalse(form.match.isEnabled())
        return form.reason.text()

    def test_an_edge_of_a_face(self):
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        self.assertIn("bounds a face of Box", self.reason(box))
        self.screenshot("fix_face")

    def test_a_knot(self):
        curve = Part.BSplineCurve()
        curve.interpolate([V(0, 30, 0), V(20, 40, 0), V(40, 30, 0), V(60, 50, 0)])
        self.assertIn("inner knot", self.reason(samples.add_edge(self.doc, "Spline", curve)))

    def test_of_two_edges_the_one_that_can_change_does(self):
        line = Part.LineSegment(V(-20, -1, 0), V(0, 0, 0)).toShape()
        fused, _ = Part.makeBox(10, 10, 10).generalFuse([line])
        both = self.doc.addObject("Part::Feature", "Both")
        both.Shape = fused
        self.obj.Sources, self.obj.Pairs = [(both, "")], "all"
        self.doc.recompute()
        loose = next(number for number, edge in enumerate(both.Shape.Edges, 1)
                     if abs(edge.Length - line.Length) < 1e-9)
        rows = self.obj.Proxy.result.rows
        found = numpy.flatnonzero((rows.edges == loose).any(axis=1))
        self.assertEqual(len(found), 3)
        for index in found:
            fix = Fix.of(self.obj, index)
            self.assertEqual(fix.links[1].sub, f"Edge{loose}")
            self.assertEqual((fix.ends[1], fix.hides), ("end", False))


class SeamTest(FixCase):
    def test_a_closed_edge_meets_itself(self):
        curve = Part.BezierCurve()
        curve.setPoles([V(0, 50, 0), V(40, 50, 0), V(60, 90, 0), V(-20, 110, 0), V(-40, 70, 0),
                        V(0, 50, 0)])
        closed = samples.add_edge(self.doc, "Closed", curve)
        self.obj.Sources = [(closed, "")]
        self.doc.recompute()
        self.assertEqual((self.obj.Joins, self.obj.OutOfTolerance), (1, 1))
        self.match(self.edit_audit())
        self.assertEqual(self.doc.MatchedCurve.Status, "OK")
        self.screenshot("fix_seam")
        self.back("Ok")
        self.assertEqual((self.obj.Status, self.obj.OutOfTolerance), ("OK", 0))
