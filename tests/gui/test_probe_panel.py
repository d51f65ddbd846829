"""The panel of a Probe: its buttons, numbers and readings."""

import samples
from osculate.features import make_probe
from probe_case import ProbeCase


class PanelTest(ProbeCase):
    def test_ok_keeps_the_probe_in_one_step_of_undo(self):
        undos = self.doc.UndoCount
        form = self.run_on((self.wave, "Edge1"))
        self.click(form.boxes["DeCasteljau"])
        self.type_number(form.position.box, "30")
        self.screenshot("probe_panel")
        self.darken()
        self.screenshot("probe_panel_dark")
        self.finish("Ok")
        self.assertAlmostEqual(self.doc.Probe.Position, 0.3, delta=1e-12)
        self.assertTrue(self.doc.Probe.DeCasteljau)
        self.assertEqual(self.doc.UndoCount, undos + 1)
        self.doc.undo()
        self.assertEqual(self.names(), ["Wave"])

    def test_cancel_leaves_the_document_as_it_was(self):
        self.run_on((self.wave, "Edge1"))
        self.finish("Cancel")
        self.assertEqual(self.names(), ["Wave"])
        self.assertLess(self.drawn("probe_cancelled"), 20)
        probe = make_probe(self.doc, [self.wave], position=0.1)
        form = self.edit(probe)
        form.position.slider.setValue(700)
        self.pump()
        self.assertAlmostEqual(probe.Position, 0.7, delta=1e-9)
        self.finish("Cancel")
        self.assertAlmostEqual(probe.Position, 0.1, delta=1e-12)

    def test_arc_length_and_parameter_are_typed(self):
        form = self.run_on((self.wave, "Edge1"))
        probe = self.doc.Probe
        self.type_number(form.arc_length, "20")
        self.assertAlmostEqual(probe.ArcLength.Value, 20.0, delta=1e-9)
        self.type_number(form.parameter, "0.25")
        self.assertAlmostEqual(probe.Parameter, 0.25, delta=1e-9)
        expected = self.wave.Shape.Edges[0].valueAt(0.25)
        self.assertLess((probe.Point - expected).Length, 1e-9)
        self.finish("Ok")

    def test_buttons_walk_along_the_special_points(self):
        form = self.run_on((self.wave, "Edge1"))
        probe = self.doc.Probe  # at the inflection, by symmetry
        self.assertEqual(probe.At, ["inflection"])
        seen = []
        while form.after.isEnabled():
            self.click(form.after)
            seen += probe.At
        self.assertEqual(seen, ["vertex", "end"])
        self.click(form.before)
        self.assertEqual((probe.At, form.special.text().split(" ")[0]), (["vertex"], "vertex"))
        self.finish("Ok")

    def test_readings_of_both_sides(self):
        line, arc = samples.line_and_arc(self.doc)
        form = self.run_on((line, "Edge1"), (arc, "Edge1"))
        self.click(form.before)
        self.click(form.before)
        self.click(form.after)
        self.assertEqual(self.doc.Probe.At, ["join"])
        self.assertIn("before", form.table.text())
        self.assertIn("0.05", form.table.text())
        self.assertIn("on edge 2", form.edge.text())
        self.assertEqual(form.missing.text(), "before: straight: no normal, no circle, no torsion")
        self.fit()
        self.screenshot("probe_join_panel")
        self.finish("Ok")

    def test_on_a_line_it_says_what_is_missing(self):
        line, _ = samples.line_and_arc(self.doc)
        form = self.run_on((line, "Edge1"))
        self.assertIn("straight", form.missing.text())
        self.finish("Ok")
