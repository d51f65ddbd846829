"""The page in FreeCAD's preferences."""

import samples
from gui_case import GuiCase
from osculate.gui import preferences
from osculate.gui.preferences_page import PreferencesPage


class PreferencesTest(GuiCase):
    def test_page_shows_and_keeps_every_setting(self):
        chosen = preferences.Preferences(
            preset="catia-v5", order=3, follow_selection=False, show_frames=False,
            show_polygons=False, frame_pixels=55, label_points=14,
            side_colors=("#123456", "#654321"))
        preferences.save(chosen)
        page = PreferencesPage()
        page.loadSettings()
        preferences.save(preferences.Preferences())
        page.saveSettings()
        self.assertEqual(preferences.load(), chosen)

    def test_panel_starts_with_them(self):
        preferences.save(preferences.Preferences(preset="rhino", order=2))
        form = self.run_command()
        self.assertEqual(form.tolerances.preset.currentText(), "rhino")
        self.assertEqual(form.tolerances.order.value(), 2)

    def test_panel_that_does_not_follow_takes_what_is_selected_first(self):
        preferences.save(preferences.Preferences(follow_selection=False))
        line, arc = samples.line_and_arc(self.doc)
        first, second = samples.cut_curve(self.doc)
        form = self.run_command()
        self.select((line, "Edge1"), (arc, "Edge1"))
        self.assertIn("<b>G1</b>", form.banner.text.text())
        self.select((first, "Edge1"), (second, "Edge1"))
        self.assertIn("<b>G1</b>", form.banner.text.text())
        self.assertFalse(preferences.load().follow_selection)

    def test_page_starts_with_the_defaults(self):
        page = PreferencesPage()
        page.loadSettings()
        self.assertEqual(page.form.preset.currentText(), "osculate")
        self.assertGreater(page.form.preset.count(), 5)
        page.saveSettings()
        self.assertEqual(preferences.load(), preferences.Preferences())
