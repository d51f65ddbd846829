"""The command Audit and its panel: what is audited, OK and Cancel, files."""

import json
import os
import tempfile

import FreeCAD

import samples
from audit_case import AuditCase
from osculate.features import make_audit
from osculate.gui import colors
from osculate.gui.audit.audit_model import JOIN, RANK
from osculate.gui.audit.audit_panel import AuditPanel


class PanelTest(AuditCase):
    def test_ok_keeps_the_audit_in_one_step_of_undo(self):
        undos = self.doc.UndoCount
        form = self.run_on((self.profile, ""))
        obj = self.doc.Audit
        self.assertEqual((obj.Status, obj.Joins), ("OK", len(self.texts(form, RANK))))
        self.screenshot("audit_panel")
        self.finish("Ok")
        self.assertEqual(self.names(), ["Profile", "Audit"])
        self.assertEqual(self.doc.UndoCount, undos + 1)
        self.doc.undo()
        self.assertEqual(self.names(), ["Profile"])

    def test_cancel_leaves_the_document_as_it_was(self):
        self.run_on((self.profile, "Edge1"))  # of an edge the whole object counts
        self.assertEqual(self.doc.Audit.EdgeCount, 5)
        self.assertGreater(self.drawn("audit_before_cancel", colors.ORDERS[1]), 50)
        self.finish("Cancel")
        self.assertEqual(self.names(), ["Profile"])
        self.assertEqual(self.drawn("audit_cancelled", colors.ORDERS[1]), 0)

    def test_asks_for_a_selection_and_takes_a_click(self):
        line, _ = samples.line_and_arc(self.doc)
        form = self.run_on()
        self.assertIn("Select objects", form.advice.text())
        self.screenshot("audit_asks")
        self.select((self.profile, "Edge1"))
        self.wait_for(lambda: "Audit" in self.names(), "the audit of what was clicked")
        self.select((line, "Edge1"))
        self.click(form.add)
        self.assertEqual(self.doc.Audit.EdgeCount, 6)
        self.assertIn("Profile.Edge2 – Profile.Edge3", self.texts(form, JOIN))
        self.select((line, ""))
        self.click(form.replace)
        self.assertEqual((self.doc.Audit.EdgeCount, self.doc.Audit.Joins), (1, 0))
        self.assertEqual(self.texts(form, JOIN), [])
        self.finish("Cancel")

    def test_an_object_without_edges_is_refused(self):
        form = self.run_on((self.profile, ""))
        self.select((self.doc.Audit, ""))
        self.click(form.replace)
        self.assertIn("no edges", form.advice.text())
        self.assertEqual(self.doc.Audit.EdgeCount, 5)
        self.finish("Cancel")

    def test_editing(self):
        obj = make_audit(self.doc, [self.profile])
        form = self.edit(obj)
        form.options.required.setValue(2)
        self.pump()
        self.assertEqual((obj.Required, obj.OutOfTolerance), (2, 2))
        self.finish("Cancel")
        self.assertEqual((obj.Required, obj.OutOfTolerance), (1, 0))

    def test_deleting_the_object_or_closing_the_document_ends_the_panel(self):
        obj = make_audit(self.doc, [self.profile])
        self.click_row(self.edit(obj), 0)
        self.doc.removeObject(obj.Name)
        self.wait_for(lambda: self.form() is None, "the panel to close")
        self.assertEqual(self.drawn("audit_deleted", colors.SIDES[0]), 0)
        obj = make_audit(self.doc, [self.profile])
        self.click_row(self.edit(obj), 0)
        FreeCAD.closeDocument(self.doc.Name)
        self.wait_for(lambda: self.form() is None, "the panel to close")

    def test_a_copy_lives_on_its_own(self):
        obj = make_audit(self.doc, [self.profile], required=2)
        copy = self.doc.copyObject(obj, False)
        obj.Required = 1
        self.doc.recompute()
        self.assertEqual((copy.Required, copy.OutOfTolerance, obj.OutOfTolerance), (2, 2, 0))
        self.pump()
        self.assertEqual(copy.ViewObject.Proxy._joins.labels, 2)

    def test_looking_changes_nothing(self):
        obj = make_audit(self.doc, [self.profile])
        undos = self.doc.UndoCount
        form = self.edit(obj)
        self.click_row(form, 0)
        self.finish("Ok")
        self.assertEqual(self.doc.UndoCount, undos)
        self.assertNotIn("Touched", obj.State)

    def test_dark(self):
        self.darken()
        form = self.run_on((self.profile, ""))
        form.options.required.setValue(3)
        self.pump()
        self.click_row(form, 0)
        self.screenshot("audit_dark")
        self.finish("Cancel")


class ExportTest(AuditCase):
    def setUp(self):
        super().setUp()
        self.obj = make_audit(self.doc, [self.profile])
        self.export_form = self.edit(self.obj)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def save(self, kind, path):
        asked, AuditPanel.ask_path = AuditPanel.ask_path, lambda panel, kind: path
        try:
            self.click(getattr(self.export_form, kind))
        finally:
            AuditPanel.ask_path = asked

    def test_csv_and_json(self):
        path = os.path.join(self.folder, "joins.csv")
        self.save("csv", path)
        with open(path, encoding="utf-8") as file:
            self.assertEqual(len(file.readlines()), 1 + self.obj.Joins)
        path = os.path.join(self.folder, "joins.json")
        self.save("json", path)
        with open(path, encoding="utf-8") as file:
            self.assertEqual(json.load(file)["summary"]["joins"], self.obj.Joins)
        self.assertIn(path, self.export_form.advice.text())

    def test_page_with_and_without_the_3d_view(self):
        path = os.path.join(self.folder, "joins.html")
        self.save("page", path)
        with open(path, encoding="utf-8") as file:
            page = file.read()
        self.assertIn("<title>Audit of Profile</title>", page)
        self.assertIn("The 3D view", page)
        self.assertIn("data:image/png", page)
        self.export_form.with_view.setChecked(False)
        self.save("page", path)
        with open(path, encoding="utf-8") as file:
            self.assertNotIn("The 3D view", file.read())

    def test_what_cannot_be_written_is_said(self):
        self.save("csv", os.path.join(self.folder, "missing", "joins.csv"))
        self.assertIn("cannot be written: No such file", self.export_form.advice.text())
        for kind in ("json", "page"):
            self.save(kind, self.folder)
            self.assertIn("cannot be written", self.export_form.advice.text())

    def test_no_answer_writes_nothing(self):
        self.save("csv", "")
        self.assertEqual((self.export_form.advice.text(), os.listdir(self.folder)), ("", []))
