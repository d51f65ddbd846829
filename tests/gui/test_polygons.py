"""The object ControlPolygons: drawn, edited in its panel, following its curves, gone with them."""

import FreeCAD
import Part

import samples
from construct_case import ConstructCase
from drawn_case import nodes_of
from osculate.features import make_control_polygons
from osculate.gui import colors
from osculate.gui.polygons.polygons_form import PolygonsForm

V = FreeCAD.Vector
LEGS, ENDS = colors.POLYGON, colors.POLYGON_ENDS
FIRST, SECOND = colors.DIFFERENCES


def wave(doc):
    """A cubic whose polygon is far from it."""
    return samples.add_edge(doc, "Wave", samples.bezier((0, 0, 0), (30, 60, 0), (60, -60, 0),
                                                        (90, 0, 0)))


class PolygonsCase(ConstructCase):
    form_type = PolygonsForm
    command = "Osculate_ControlPolygons"

    def setUp(self):
        super().setUp()
        self.wave = wave(self.doc)
        self.ellipse = self.doc.addObject("Part::Feature", "Ellipse")
        self.ellipse.Shape = Part.Ellipse(V(50, 0, 0), 70, 40).toShape()
        self.doc.recompute()
        self.fit()

    def drawn(self, name, color=LEGS):
        """How many pixels of a colour the 3D view has."""
        self.pump()  # the camera's planes follow what is drawn
        return self.count_pixels(self.image(name), color, 8)


class DrawnTest(PolygonsCase):
    def setUp(self):
        super().setUp()
        self.polygons = make_control_polygons(self.doc, [self.wave, self.ellipse])
        self.fit()

    def test_is_seen_with_its_legend_on_light_and_dark(self):
        light = self.drawn("polygons_light")
        self.assertGreater(light, 500)
        self.assertGreater(self.drawn("polygons_light", ENDS), 200)
        self.darken()
        self.assertGreater(self.drawn("polygons_dark"), 0.7 * light)
        self.screenshot("polygons_dark_screen")

    def test_weights_and_differences_on_demand(self):
        self.assertLess(self.drawn("polygons_plain", FIRST), 20)
        self.polygons.Weights = True
        self.polygons.FirstDifferences = True
        self.assertGreater(self.drawn("polygons_first", FIRST), 200)
        self.assertLess(self.drawn("polygons_first", SECOND), 20)
        self.polygons.SecondDifferences = True
        self.assertGreater(self.drawn("polygons_second", SECOND), 200)
        self.polygons.DifferenceScale = "derivatives"
        self.assertGreater(self.drawn("polygons_derivatives", SECOND), 100)
        self.darken()
        self.drawn("polygons_derivatives_dark")
        self.polygons.FirstDifferences = self.polygons.SecondDifferences = False
        self.assertLess(self.drawn("polygons_without", FIRST), 20)

    def test_hidden_polygons_draw_and_compute_nothing(self):
        self.polygons.Visibility = False
        self.pump()
        self.assertLess(self.drawn("polygons_hidden"), 20)
        before = self.polygons.Proxy.result
        self.wave.Placement.Base.z = 3.0
        self.pump()
        self.assertIs(self.polygons.Proxy.result, before)
        self.polygons.Visibility = True
        self.pump()
        self.assertIsNot(self.polygons.Proxy.result, before)
        self.assertGreater(self.drawn("polygons_shown_again"), 500)

    def test_go_when_they_are_deleted_and_come_back_by_undo(self):
        self.doc.openTransaction("Delete")
        self.doc.removeObject(self.polygons.Name)
        self.doc.commitTransaction()
        self.pump()
        self.assertLess(self.drawn("polygons_deleted"), 20)
        self.doc.undo()
        self.pump()
        self.assertGreater(self.drawn("polygons_undone"), 500)

    def test_follow_their_curve_without_a_recompute(self):
        before = self.polygons.Proxy.result
        self.wave.Shape = samples.bezier((0, 0, 0), (30, 90, 0), (60, -20, 0),
                                         (90, 0, 0)).toShape()
        self.wait_for(lambda: self.polygons.Proxy.result is not before, "the polygons to follow")
        self.assertEqual(self.polygons.Proxy.result.poles[1].tolist(), [30, 90, 0])

    def test_survive_saving_and_loading(self):
        path = f"{FreeCAD.getTempPath()}osculate_polygons.FCStd"
        self.doc.saveAs(path)
        FreeCAD.closeDocument(self.doc.Name)
        self.doc = FreeCAD.openDocument(path)
        self.pump()
        self.fit()
        self.assertGreater(self.drawn("polygons_loaded"), 500)
        self.assertNotIn("Touched", self.doc.ControlPolygons.State)

    def test_many_weights_are_cut_and_told(self):
        self.polygons.Weights = True
        self.assertEqual(self.polygons.ViewObject.Proxy._drawing.hidden_weights, 0)
        many = self.doc.addObject("Part::Feature", "Many")
        many.Shape = Part.makeCompound([Part.Circle(V(3 * i, 9 * j), V(0, 0, 1), 1).toShape()
                                        for i in range(10) for j in range(10)])
        self.polygons.Sources = [(many, "")]
        self.doc.recompute()
        self.assertGreater(self.polygons.ViewObject.Proxy._drawing.hidden_weights, 100)
        self.assertLess(len(nodes_of(self.polygons, "Image")), 310)


class PanelTest(PolygonsCase):
    def test_ok_keeps_the_polygons_in_one_step_of_undo(self):
        undos = self.doc.UndoCount
        form = self.run_on((self.wave, "Edge1"), (self.ellipse, "Edge1"))
        self.click(form.boxes["FirstDifferences"])
        self.click(form.boxes["Weights"])
        self.screenshot("polygons_panel")
        self.darken()
        self.screenshot("polygons_panel_dark")
        self.finish("Ok")
        obj = self.doc.ControlPolygons
        self.assertEqual((obj.FirstDifferences, obj.SecondDifferences, obj.Weights),
                         (True, False, True))
        self.assertEqual(self.doc.UndoCount, undos + 1)
        self.doc.undo()
        self.assertEqual(self.names(), ["Wave", "Ellipse"])

    def test_cancel_leaves_the_document_as_it_was(self):
        self.run_on((self.wave, "Edge1"))
        self.assertIn("ControlPolygons", self.names())
        self.finish("Cancel")
        self.assertEqual(self.names(), ["Wave", "Ellipse"])
        self.assertLess(self.drawn("polygons_cancelled"), 20)

    def test_a_double_click_edits_and_cancel_takes_back(self):
        obj = make_control_polygons(self.doc, [self.wave])
        form = self.edit(obj)
        self.assertFalse(form.scaling.isEnabled())
        self.click(form.boxes["SecondDifferences"])
        self.assertTrue(form.scaling.isEnabled())
        self.choose(form.scaling, "derivatives")
        self.assertEqual((obj.SecondDifferences, obj.DifferenceScale), (True, "derivatives"))
        self.finish("Cancel")
        self.assertEqual((obj.SecondDifferences, obj.DifferenceScale), (False, "plain"))

    def test_takes_another_selection(self):
        form = self.run_on()
        self.assertIn("Select edges", form.advice.text())
        self.select((self.wave, ""))
        self.wait_for(lambda: "ControlPolygons" in self.names(), "the polygons")
        self.select((self.ellipse, "Edge1"))
        self.click(form.add)
        self.assertEqual(self.doc.ControlPolygons.EdgeCount, 2)
        self.assertIn("rational", form.table.text())
        self.finish("Cancel")
