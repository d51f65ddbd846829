"""The panels in another language."""

import FreeCADGui

import samples
from gui_case import GuiCase
from osculate.gui.audit.audit_form import AuditForm
from osculate.gui.construct.blend_form import BlendForm
from osculate.gui.polygons.polygons_form import PolygonsForm
from osculate.gui.probe.probe_form import ProbeForm
from osculate.gui.solid_panel.solid_form import SolidForm


class GermanTest(GuiCase):
    def setUp(self):
        super().setUp()
        FreeCADGui.setLocale("German")
        self.pump()

    def tearDown(self):
        super().tearDown()
        FreeCADGui.setLocale("English")

    def test_menus(self):
        FreeCADGui.activateWorkbench("OsculateWorkbench")
        self.pump()
        for language, name in (("German", "Bézier-Körper"), ("English", "Bezier solids")):
            FreeCADGui.setLocale(language)
            self.pump()
            menus = [action.text().replace("&", "")
                     for action in FreeCADGui.getMainWindow().menuBar().actions()]
            self.assertIn(name, menus)
            self.assertIn("Osculate", menus)

    def test_panel_and_command(self):
        line, arc = samples.line_and_arc(self.doc)
        form = self.analyze((line, "Edge1"), (arc, "Edge1"))
        self.assertEqual(form.windowTitle(), "Übergang untersuchen")
        self.assertIn("<b>G1</b>, verfehlt G2 um 100 %", form.banner.text.text())
        self.assertIn("✗&nbsp;verfehlt", form.orders.text())
        action = FreeCADGui.Command.get("Osculate_AnalyzeJoin").getAction()[0]
        self.assertEqual(action.text(), "Übergang untersuchen")
        self.screenshot("german")

    def test_blend(self):
        self.form_type = BlendForm
        first, second = samples.blend_ends(self.doc)
        self.select((first, "Edge1"), (second, "Edge1"))
        FreeCADGui.runCommand("Osculate_Blend")
        self.wait_for(lambda: self.form() is not None and self.form().isVisible(), "the panel")
        self.pump()
        self.assertEqual(self.form().windowTitle(), "Überblenden")
        self.assertEqual(self.form().fair.text(), "Glätten")
        self.assertIn("Krümmungsänderung", self.form().energies.text())
        self.screenshot("german_blend")
        self.assertLessEqual(self.form().minimumSizeHint().width(), 340)  # or it would be cut

    def test_audit(self):
        self.form_type = AuditForm
        profile = samples.profile(self.doc)
        self.select((profile, ""))
        FreeCADGui.runCommand("Osculate_Audit")
        self.wait_for(lambda: self.form() is not None and self.form().isVisible(), "the panel")
        form = self.form()
        form.options.required.setValue(2)
        for section in form.sections:
            section.header.setChecked(True)
        self.pump()
        self.assertEqual(form.windowTitle(), "Prüfung aller Übergänge")
        self.assertIn("Übergänge von 5 Kanten, <b>2</b> unter G2", form.summary.text())
        self.screenshot("german_audit")
        self.assertLessEqual(form.minimumSizeHint().width(), 340)  # or it would be cut

    def test_what_is_drawn_along_edges(self):
        line, arc = samples.line_and_arc(self.doc)
        for command, kind, title in (("Probe", ProbeForm, "Sonde"),
                                     ("ControlPolygons", PolygonsForm, "Kontrollpolygone")):
            self.form_type = kind
            self.select((line, "Edge1"), (arc, "Edge1"))
            FreeCADGui.runCommand(f"Osculate_{command}")
            self.wait_for(lambda: self.form() is not None and self.form().isVisible(), "the panel")
            self.fit()
            self.assertEqual(self.form().windowTitle(), title)
            self.screenshot(f"german_{title}")
            self.assertLessEqual(self.form().minimumSizeHint().width(), 340)  # or it would be cut
            FreeCADGui.Control.closeDialog()
            self.pump()

    def test_solids(self):
        self.form_type = SolidForm
        FreeCADGui.runCommand("Osculate_BezierSolid")
        self.wait_for(lambda: self.form() is not None and self.form().isVisible(), "the panel")
        self.pump()
        form = self.form()
        self.assertEqual(form.windowTitle(), "Bézier-Körper")
        self.assertEqual([form.kind_box.itemText(index) for index in (0, 5)],
                         ["Tetraeder", "Kugeloktant"])
        self.assertIn("gültig", form.facts.text())
        for index in range(form.kind_box.count()):
            form.kind_box.setCurrentIndex(index)
            form.kind_box.activated.emit(index)
            self.pump()
            self.assertLessEqual(form.minimumSizeHint().width(), 340, form.kind.name)
        self.screenshot("german_solid")
