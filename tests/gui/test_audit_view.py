"""What is drawn of an Audit: dots, numbers, legend; saved and loaded, hidden and deleted."""

import os
import tempfile

import FreeCAD

from audit_case import AuditCase
from osculate.features import make_audit
from osculate.gui import colors
from osculate.gui.audit.audit_model import RANK

V = FreeCAD.Vector
G0, G1 = colors.ORDERS[:2]


class DrawnTest(AuditCase):
    def setUp(self):
        super().setUp()
        self.obj = make_audit(self.doc, [self.profile], pairs="all", required=2)
        self.pump()

    def test_dots_numbers_and_legend(self):
        self.assertGreater(self.drawn("audit_drawn", G0), 60)
        self.assertGreater(self.drawn("audit_drawn", G1), 120)
        joins = self.obj.ViewObject.Proxy._joins
        self.assertEqual((joins.labels, joins.out_of_tolerance), (3, 3))
        self.assertEqual(joins.counts, {0: 1, 1: 2, 4: 2})
        self.darken()
        self.assertGreater(self.drawn("audit_drawn_dark", G0), 60)
        self.screenshot("audit_drawn_dark_screen")

    def test_what_is_drawn_can_be_chosen(self):
        joins = self.obj.ViewObject.Proxy._joins
        self.obj.Drawn = "out of tolerance"
        self.assertEqual(joins.counts, {0: 1, 1: 2})
        self.obj.MostLabels = 2
        self.assertEqual((joins.labels, joins.out_of_tolerance), (2, 3))
        self.assertIn((None, "the worst 2 of 3 numbered"),
                      list(self.obj.ViewObject.Proxy._legend_rows(self.obj)))
        self.image("audit_two_numbers")
        self.obj.Drawn = "none"
        self.assertEqual((joins.counts, joins.labels), ({}, 0))
        self.obj.Legend = False
        self.assertEqual(self.drawn("audit_not_drawn", G1), 0)
        self.assertNotIn("Touched", self.obj.State)

    def test_hidden_and_deleted_leave_no_trace(self):
        self.obj.Visibility = False
        self.assertEqual(self.drawn("audit_hidden", G1), 0)
        self.obj.Visibility = True
        self.assertGreater(self.drawn("audit_shown", G1), 120)
        self.doc.openTransaction("Delete")
        self.doc.removeObject(self.obj.Name)
        self.doc.commitTransaction()
        self.pump()
        self.assertEqual(self.drawn("audit_deleted", G1), 0)
        self.doc.undo()
        self.pump()
        self.obj = self.doc.Audit
        self.assertGreater(self.drawn("audit_undone", G1), 120)
        self.assertTrue(self.obj.ViewObject.Proxy._legend.is_shown)

    def test_undo_of_an_edit_of_the_model_is_followed(self):
        joins = self.obj.ViewObject.Proxy._joins
        self.doc.openTransaction("Edit")
        self.profile.delGeometry(0)
        self.doc.recompute()
        self.doc.commitTransaction()
        self.assertEqual(joins.counts, {0: 1, 1: 1, 4: 2})
        self.doc.undo()
        self.pump()
        self.assertEqual(joins.counts, {0: 1, 1: 2, 4: 2})
        self.assertEqual(self.obj.Joins, 5)

    def test_survives_saving_and_loading(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "audit.FCStd")
            self.doc.saveAs(path)
            FreeCAD.closeDocument(self.doc.Name)
            self.doc = FreeCAD.openDocument(path)
        self.pump()
        self.fit()
        self.assertNotIn("Touched", self.doc.Audit.State)
        self.assertGreater(self.drawn("audit_loaded", G1), 120)
        self.assertIn("5 joins", self.edit(self.doc.Audit).summary.text().replace("<b>", "")
                      .replace("</b>", ""))

    def test_in_an_app_part_the_dots_are_where_the_joins_are(self):
        part = self.doc.addObject("App::Part", "Part")
        part.addObjects([self.profile, self.obj])
        self.obj.Sources = [(self.profile, "")]
        part.Placement.Base = V(0, 0, 50)
        self.doc.recompute()
        matrix = self.obj.ViewObject.Proxy._joins.to_world.matrix.getValue()
        self.assertAlmostEqual(matrix.getValue()[3][2], -50.0, places=4)

    def test_a_failing_audit_says_so_and_keeps_the_last(self):
        self.doc.removeObject(self.profile.Name)
        self.obj.touch()
        self.doc.recompute()
        self.assertIn((None, "out of date"),
                      list(self.obj.ViewObject.Proxy._legend_rows(self.obj)))
        form = self.edit(self.obj)
        self.assertIn("nothing to audit", form.trouble.text())
        self.assertEqual(len(self.texts(form, RANK)), 5)
        self.click_row(form, 0)
        self.assertIn("Profile no longer exists", form.advice.text())
        self.finish("Cancel")
