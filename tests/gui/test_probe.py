"""The object Probe: drawn, following its curves, gone with them."""

import FreeCAD
import Part

import samples
from drawn_case import nodes_of
from osculate.features import make_probe
from osculate.gui import colors
from probe_case import ProbeCase

V = FreeCAD.Vector
CIRCLE = colors.CIRCLE
TANGENT, NORMAL, BINORMAL = colors.FRAME
ALL = ("frame", "circle", "osculating plane", "normal plane", "rectifying plane", "read-out",
       "legend")


class DrawnTest(ProbeCase):
    def setUp(self):
        super().setUp()
        self.probe = make_probe(self.doc, [self.wave], position=0.25)
        self.fit()

    def test_is_seen_with_its_legend_on_light_and_dark(self):
        for color in (CIRCLE, TANGENT, NORMAL):
            self.assertGreater(self.drawn("probe_light", color), 60, color)
        self.darken()
        for color in (CIRCLE, TANGENT, NORMAL):
            self.assertGreater(self.drawn("probe_dark", color), 60, color)

    def test_parts_are_drawn_on_demand(self):
        self.probe.Circle = self.probe.Legend = False
        self.assertLess(self.drawn("probe_without_circle"), 20)
        self.probe.DeCasteljau = True
        self.assertGreater(self.drawn("probe_levels", colors.LEVELS[1]), 100)
        self.assertGreater(self.drawn("probe_levels", colors.LEVELS[2]), 50)
        self.probe.Legend = True
        self.drawn("probe_construction")
        self.probe.DeCasteljau = self.probe.Frame = self.probe.ReadOut = False
        self.probe.Legend = False
        self.assertLess(self.drawn("probe_bare", TANGENT), 20)

    def test_planes_are_translucent_squares(self):
        helix = self.doc.addObject("Part::Feature", "Helix")
        helix.Shape = Part.makeHelix(30, 60, 20)
        self.doc.recompute()
        probe = make_probe(self.doc, [helix], position=0.4, parts=ALL)
        self.wave.Visibility = self.probe.Visibility = False
        self.view().viewIsometric()
        self.view().fitAll()
        plain = self.drawn("probe_planes", NORMAL)
        self.assertGreater(plain, 60)
        self.darken()
        self.drawn("probe_planes_dark")
        probe.OsculatingPlane = probe.NormalPlane = probe.RectifyingPlane = False
        self.assertLess(self.drawn("probe_no_planes", NORMAL), plain)

    def test_what_does_not_exist_is_not_drawn(self):
        self.probe.Position = 0.5  # the inflection
        self.doc.recompute()
        self.assertEqual(self.probe.At, ["inflection"])
        self.assertLess(self.drawn("probe_inflection"), 20)
        self.assertLess(self.drawn("probe_inflection", NORMAL), 20)
        self.assertGreater(self.drawn("probe_inflection", TANGENT), 60)

    def test_both_sides_of_a_jump_are_shown(self):
        line, arc = samples.line_and_arc(self.doc)
        self.wave.Visibility = self.probe.Visibility = False
        probe = make_probe(self.doc, [line, arc])
        probe.Position = 50.0 / probe.TotalLength.Value
        self.doc.recompute()
        self.fit()
        self.assertEqual(len(probe.Proxy.result.sides), 2)
        self.assertGreater(self.drawn("probe_jump"), 100)

    def test_of_many_special_points_the_next_ones_are_marked(self):
        polygon = [V(i % 2, 0.2 * i, 0) for i in range(400)]
        many = self.doc.addObject("Part::Feature", "Many")
        many.Shape = Part.makePolygon(polygon)
        self.doc.recompute()
        probe = make_probe(self.doc, [many], parts=["marks"])
        self.assertEqual(len(probe.Proxy.probe.specials), 400)  # with the ends
        self.assertEqual(len(probe.Proxy.probe.special_points), 400)
        self.pump()
        self.assertLess(len(nodes_of(probe, "Image")), 310)

    def test_hidden_probe_draws_and_computes_nothing(self):
        self.probe.Visibility = False
        self.assertLess(self.drawn("probe_hidden"), 20)
        before = self.probe.Proxy.result
        self.wave.Placement.Base.z = 3.0
        self.pump()
        self.assertIs(self.probe.Proxy.result, before)
        self.probe.Visibility = True
        self.pump()
        self.assertAlmostEqual(self.probe.Proxy.result.point[2], 3.0)

    def test_follows_its_curve_without_a_recompute_and_goes_with_deletion(self):
        before = self.probe.Proxy.result
        self.wave.Shape = samples.bezier((0, 0, 0), (30, 90, 0), (60, -20, 0),
                                         (90, 0, 0)).toShape()
        self.wait_for(lambda: self.probe.Proxy.result is not before, "the probe to follow")
        self.doc.openTransaction("Delete")
        self.doc.removeObject(self.probe.Name)
        self.doc.commitTransaction()
        self.assertLess(self.drawn("probe_deleted"), 20)
        self.doc.undo()
        self.assertGreater(self.drawn("probe_undone"), 60)

    def test_survives_saving_and_loading(self):
        path = f"{FreeCAD.getTempPath()}osculate_probe.FCStd"
        self.doc.saveAs(path)
        FreeCAD.closeDocument(self.doc.Name)
        self.doc = FreeCAD.openDocument(path)
        self.pump()
        self.fit()
        self.assertGreater(self.drawn("probe_loaded"), 60)
        self.assertNotIn("Touched", self.doc.Probe.State)
