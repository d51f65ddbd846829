"""The object CurvatureComb: drawn, edited in its panel, following its curves, gone with them."""

import FreeCAD
import Part
from pivy import coin

import samples
from construct_case import ConstructCase
from osculate.features import make_curvature_comb
from osculate.features.curvature_comb import scale_of
from osculate.gui import colors
from osculate.gui.canvas import widgets_of
from osculate.gui.comb.comb_form import CombForm
from osculate.gui.construct.blend_form import BlendForm
from osculate.gui.overlays import comb_nodes
from osculate.gui.qt import Qt, QtCore, QtGui, QtWidgets

V = FreeCAD.Vector
TOOTH = "#55a4dd"  # of curvature, which the white behind shines through
CURVATURE, TORSION = colors.QUANTITIES["curvature"], colors.QUANTITIES["torsion"]


def s_curve(doc):
    """A cubic with an inflection in the middle."""
    return samples.add_edge(doc, "Wave", samples.bezier((0, 0, 0), (30, 60, 0), (60, -60, 0),
                                                        (90, 0, 0)))


class CombCase(ConstructCase):
    form_type = CombForm
    command = "Osculate_CurvatureComb"

    def drawn(self, name, color=CURVATURE):
        """How many pixels of a colour the 3D view has."""
        return self.count_pixels(self.image(name), color, 12)

    def widest(self, obj):
        """The size of all that is drawn of a comb, in mm."""
        action = coin.SoGetBoundingBoxAction(coin.SbViewportRegion(900, 600))
        action.apply(obj.ViewObject.Proxy._drawing.node)
        return action.getBoundingBox().getSize().getValue()


class DrawnTest(CombCase):
    def setUp(self):
        super().setUp()
        self.wave = s_curve(self.doc)
        self.doc.recompute()
        self.comb = make_curvature_comb(self.doc, [self.wave])
        self.fit()

    def test_is_seen_with_its_legend_on_light_and_dark(self):
        light = self.drawn("comb_light")
        self.assertGreater(light, 1000)
        self.darken()
        self.assertGreater(self.drawn("comb_dark"), 0.7 * light)
        self.screenshot("comb_dark_screen")

    def test_hidden_comb_draws_nothing_and_computes_nothing(self):
        self.comb.Visibility = False
        self.pump()
        self.assertLess(self.drawn("comb_hidden"), 20)
        before = self.comb.Proxy.result
        self.wave.Placement.Base.z = 3.0
        self.pump()
        self.assertIs(self.comb.Proxy.result, before)
        self.comb.Visibility = True
        self.pump()
        self.assertIsNot(self.comb.Proxy.result, before)
        self.assertGreater(self.drawn("comb_shown_again"), 1000)

    def test_goes_when_it_is_deleted_and_comes_back_by_undo(self):
        self.doc.openTransaction("Delete")
        self.doc.removeObject(self.comb.Name)
        self.doc.commitTransaction()
        self.pump()
        self.assertLess(self.drawn("comb_deleted"), 20)
        self.doc.undo()
        self.pump()
        self.assertGreater(self.drawn("comb_undone"), 1000)
        self.doc.redo()
        self.pump()
        self.assertLess(self.drawn("comb_redone"), 20)

    def test_follows_its_curve_without_a_recompute(self):
        before = self.comb.Proxy.result
        self.wave.Shape = samples.bezier((0, 0, 0), (30, 90, 0), (60, -20, 0),
                                         (90, 0, 0)).toShape()
        self.wait_for(lambda: self.comb.Proxy.result is not before, "the comb to follow")
        self.assertEqual(len(self.comb.Proxy.result.lengths), 1)
        self.drawn("comb_followed")

    def test_parts_can_be_switched_off(self):
        whole = self.drawn("comb_whole")
        self.assertGreater(self.drawn("comb_whole", TOOTH), 500)
        self.comb.Teeth = False
        bare = self.drawn("comb_without_teeth")
        self.assertLess(self.drawn("comb_without_teeth", TOOTH), 200)
        self.comb.Envelope = False
        self.assertLess(self.drawn("comb_legend_alone"), 0.5 * min(bare, whole))
        self.comb.Legend = self.comb.Marks = False
        self.assertLess(self.drawn("comb_bare"), 20)

    def test_never_hides_the_shape(self):
        wide = self.widest(self.comb)
        self.comb.Factor = 1e6
        self.assertLess(max(self.widest(self.comb)), 2.5 * max(wide))
        self.assertGreater(self.comb.ViewObject.Proxy._drawing.cut, 10)

    def test_jumps_stay_jumps(self):
        line, arc = samples.line_and_arc(self.doc)
        wire = self.doc.addObject("Part::Feature", "Wire")
        wire.Shape = Part.Wire([*line.Shape.Edges, *arc.Shape.Edges])
        curve = Part.BSplineCurve()
        root = 0.5 ** 0.5
        curve.buildFromPolesMultsKnots(
            [V(10, 0), V(10, 10), V(0, 10), V(-20, 10), V(-20, -10)], [3, 2, 3], [0, 1, 2], False,
            2, [1, root, 1, root, 1])
        spline = samples.add_edge(self.doc, "TwoArcs", curve)
        self.doc.recompute()
        obj = make_curvature_comb(self.doc, [spline])
        for other in (self.wave, self.comb, line, arc, wire):
            other.Visibility = False
        self.fit()
        self.assertEqual(obj.ViewObject.Proxy._drawing.jumps, 1)
        self.assertGreater(self.drawn("comb_jump", comb_nodes.JUMP_COLOR), 30)

    def test_survives_saving_and_loading(self):
        path = f"{FreeCAD.getTempPath()}osculate_comb.FCStd"
        self.doc.saveAs(path)
        FreeCAD.closeDocument(self.doc.Name)
        self.doc = FreeCAD.openDocument(path)
        self.pump()
        self.fit()
        self.assertGreater(self.drawn("comb_loaded"), 1000)
        self.assertNotIn("Touched", self.doc.CurvatureComb.State)

    def test_legends_of_two_combs_stand_side_by_side(self):
        one = self.count_pixels(self.image("comb_one"), "#16202b", 12)
        make_curvature_comb(self.doc, [self.wave], quantity="curvature_rate")
        self.pump()
        self.assertGreater(self.count_pixels(self.image("comb_two"), "#16202b", 12), 1.7 * one)


class PanelTest(CombCase):
    def setUp(self):
        super().setUp()
        self.wave = s_curve(self.doc)
        self.helix = self.doc.addObject("Part::Feature", "Helix")
        self.helix.Shape = Part.makeHelix(30, 90, 20)
        self.doc.recompute()
        self.fit()

    def test_ok_keeps_the_comb_in_one_step_of_undo(self):
        undos = self.doc.UndoCount
        self.run_on((self.wave, "Edge1"))
        self.screenshot("comb_panel")
        self.choose_quantity("curvature_rate")
        self.finish("Ok")
        self.assertEqual(self.names(), ["Wave", "Helix", "CurvatureComb"])
        self.assertEqual(self.doc.UndoCount, undos + 1)
        self.doc.undo()
        self.assertEqual(self.names(), ["Wave", "Helix"])

    def test_cancel_leaves_the_document_as_it_was(self):
        self.run_on((self.wave, "Edge1"))
        self.assertIn("CurvatureComb", self.names())
        self.finish("Cancel")
        self.assertEqual(self.names(), ["Wave", "Helix"])
        self.assertLess(self.drawn("comb_cancelled"), 20)

    def test_asks_for_a_selection_and_takes_a_click(self):
        form = self.run_on()
        self.assertIn("Select edges", form.advice.text())
        self.assertEqual(self.names(), ["Wave", "Helix"])
        self.select((self.helix, ""))
        self.wait_for(lambda: "CurvatureComb" in self.names(), "the comb of what was clicked")
        self.assertEqual(self.doc.CurvatureComb.EdgeCount, len(self.helix.Shape.Edges))
        self.select((self.wave, "Edge1"))
        self.click(form.add)
        self.assertEqual(self.doc.CurvatureComb.EdgeCount, len(self.helix.Shape.Edges) + 1)
        self.select((self.wave, "Edge1"))
        self.click(form.replace)
        self.assertEqual(self.doc.CurvatureComb.EdgeCount, 1)
        self.finish("Cancel")

    def test_quantity_changes_colour_and_legend(self):
        self.run_on((self.helix, ""))
        self.choose_quantity("torsion")
        self.view().viewIsometric()
        self.view().fitAll()
        self.assertGreater(self.drawn("comb_torsion", TORSION), 500)
        self.darken()
        self.screenshot("comb_panel_dark")
        self.finish("Ok")

    def test_slider_scales_and_flip_turns_over(self):
        form = self.run_on((self.wave, "Edge1"))
        obj = self.doc.CurvatureComb
        before = scale_of(obj)
        form.scale.setValue(30)
        self.assertAlmostEqual(scale_of(obj), before * 10 ** 0.3, delta=1e-6 * before)
        self.click(form.flip)
        self.assertAlmostEqual(scale_of(obj), -before * 10 ** 0.3, delta=1e-6 * before)
        self.click(form.automatic)  # what is seen stays
        self.assertFalse(obj.AutoScale)
        self.assertAlmostEqual(scale_of(obj), -before * 10 ** 0.3, delta=1e-6 * before)
        form.scale.setValue(-40)
        self.assertAlmostEqual(scale_of(obj), -before * 10 ** -0.4, delta=1e-6 * before)
        self.finish("Cancel")

    def test_check_boxes_switch_parts(self):
        form = self.run_on((self.wave, "Edge1"))
        for name in ("Teeth", "Marks"):
            self.click(form.boxes[name])
            self.assertFalse(getattr(self.doc.CurvatureComb, name))
        self.click(form.boxes["Teeth"])
        self.assertTrue(self.doc.CurvatureComb.Teeth)
        self.finish("Ok")

    def test_ctrl_and_wheel_in_the_view_scale(self):
        self.run_on((self.wave, "Edge1"))
        obj = self.doc.CurvatureComb
        before, height = scale_of(obj), self.camera_height()
        self.wheel(120, Qt.KeyboardModifier.ControlModifier)
        self.assertAlmostEqual(scale_of(obj), 1.12 * before, delta=1e-6 * before)
        self.assertEqual(self.camera_height(), height)
        self.finish("Ok")
        after = scale_of(obj)
        self.wheel(120, Qt.KeyboardModifier.ControlModifier)
        self.assertEqual(scale_of(obj), after)  # the panel is closed: the wheel is FreeCAD's

    def test_a_double_click_edits_it(self):
        comb = make_curvature_comb(self.doc, [self.wave])
        form = self.edit(comb)
        form.density.setValue(60)
        self.pump()
        self.assertEqual(comb.Density, 60)
        self.finish("Cancel")
        self.assertEqual(comb.Density, 24)

    def test_a_comb_cannot_hang_on_what_follows_from_it(self):
        comb = make_curvature_comb(self.doc, [self.wave])
        form = self.edit(comb)
        self.select((comb, ""))
        self.click(form.replace)
        self.assertNotEqual(form.advice.text(), "")
        self.finish("Cancel")
        self.assertEqual(comb.EdgeCount, 1)

    def choose_quantity(self, name):
        box = self.form().quantity
        index = list(colors.QUANTITIES).index(name)
        box.setCurrentIndex(index)
        box.activated.emit(index)
        self.pump()

    def camera_height(self):
        return self.view().getCameraNode().height.getValue()

    def wheel(self, angle, modifiers):
        graphics, canvas = widgets_of(self.view())
        for widget in (canvas, graphics):
            place = QtCore.QPointF(widget.rect().center())
            event = QtGui.QWheelEvent(
                place, QtCore.QPointF(widget.mapToGlobal(widget.rect().center())),
                QtCore.QPoint(0, 0), QtCore.QPoint(0, angle), Qt.MouseButton.NoButton, modifiers,
                Qt.ScrollPhase.NoScrollPhase, False)
            if QtWidgets.QApplication.sendEvent(widget, event) and event.isAccepted():
                break
        self.pump()


class PorcupineTest(CombCase):
    form_type = BlendForm
    command = "Osculate_Blend"

    def test_combs_of_the_blend_and_both_edges_are_drawn_on_demand(self):
        first, second = samples.blend_ends(self.doc)
        self.fit()
        form = self.run_on((first, "Edge1"), (second, "Edge1"))
        self.assertLess(self.drawn("porcupine_off"), 20)
        self.click(form.combs)
        self.assertGreater(self.drawn("porcupine_on"), 500)
        self.screenshot("porcupine")
        form.ends[0].order.buttons[1].click()
        self.pump()
        self.drawn("porcupine_g1")
        self.click(form.combs)
        self.assertLess(self.drawn("porcupine_off_again"), 20)
        self.finish("Cancel")
        self.assertLess(self.drawn("porcupine_gone"), 20)
