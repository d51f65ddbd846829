"""The panel in another language."""

import FreeCADGui

import samples
from gui_case import GuiCase


class GermanTest(GuiCase):
    def setUp(self):
        super().setUp()
        FreeCADGui.setLocale("German")
        self.pump()

    def tearDown(self):
        super().tearDown()
        FreeCADGui.setLocale("English")

    def test_panel_and_command(self):
        line, arc = samples.line_and_arc(self.doc)
        form = self.analyze((line, "Edge1"), (arc, "Edge1"))
        self.assertEqual(form.windowTitle(), "Übergang untersuchen")
        self.assertIn("<b>G1</b>, verfehlt G2 um 100 %", form.banner.text.text())
        self.assertIn("✗&nbsp;verfehlt", form.orders.text())
        action = FreeCADGui.Command.get("Osculate_AnalyzeJoin").getAction()[0]
        self.assertEqual(action.text(), "Übergang untersuchen")
        self.screenshot("german")
