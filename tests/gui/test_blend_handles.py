"""The handles of a blend in the 3D view, used with the mouse."""

import math
import time

import FreeCAD
import FreeCADGui

from gui_case import DARK, LIGHT, QTest
from handle_case import HandleUser
from osculate.gui import colors
from osculate.gui.canvas import widgets_of
from osculate.gui.construct.blend_handles import handles_of
from osculate.gui.overlays.screen import Screen
from osculate.gui.qt import Qt, QtCore
from test_blend import BlendCase

FIRST, SECOND, FIRST_CHANGE = ("First", 1), ("Second", 1), ("First", 2)


class HandleCase(HandleUser, BlendCase):
    def setUp(self):
        super().setUp()
        self.form_ = self.blend_both()
        self.obj = self.doc.BlendCurve

    def handles(self):
        return handles_of(self.obj, self.obj.Proxy.result, colors.SIDES)


class DragTest(HandleCase):
    def test_screen_agrees_with_freecad(self):
        for camera in ("Orthographic", "Perspective"):
            self.view().setCameraType(camera)
            self.view().viewIsometric()
            self.view().fitAll()
            for point in ((0, 0, 0), (50, 20, 0), (100, 30, 0)):
                seen = self.view().getPointOnScreen(*map(float, point))
                for mine, theirs in zip(Screen(self.view()).pixel_of(point), seen):
                    self.assertAlmostEqual(mine, theirs, delta=1.0)

    def test_dragging_sets_and_fixes_the_number_live(self):
        lengths = []
        start, target = self.place(FIRST), self.place(FIRST, 30.0)
        self.press_at(start)
        for share in (0.25, 0.5, 0.75, 1.0):
            self.move_to(start + (target - start) * share)
            lengths.append(self.obj.Shape.Length)
        self.screenshot("handles_dragging")
        self.let_go_at(target)
        self.assertEqual(len(set(lengths)), 4)
        chord = (self.obj.Shape.Vertexes[1].Point - self.obj.Shape.Vertexes[0].Point).Length
        pixel = 2.0 * self.view().getCameraNode().height.getValue() / self.canvas.height()
        self.assertAlmostEqual(self.obj.FirstBeta1, 3.0 * 30.0 / chord, delta=3.0 * pixel / chord)
        self.assertTrue(self.obj.FirstBeta1Fixed)
        self.assertTrue(self.form_.ends[0].numbers[0].lock.isChecked())
        self.assertEqual(FreeCADGui.Selection.getSelectionEx(), [])

    def test_handle_does_not_jump_when_it_is_taken_or_let_go(self):
        beta = self.obj.FirstBeta1
        place = self.place(FIRST) + QtCore.QPoint(5, 5)
        self.press_at(place)
        self.move_to(place)
        self.assertAlmostEqual(self.obj.FirstBeta1, beta, delta=1e-5)
        self.let_go_at(place)

    def test_a_drag_is_one_step_and_all_is_one_undo(self):
        undos = self.doc.UndoCount  # with the one that is going on
        chosen = self.obj.FirstBeta1
        self.drag(FIRST, 25.0)
        self.drag(SECOND, 25.0)
        self.click(self.form_.back)
        self.assertFalse(self.obj.SecondBeta1Fixed)
        self.assertTrue(self.obj.FirstBeta1Fixed)
        self.click(self.form_.back)
        self.assertAlmostEqual(self.obj.FirstBeta1, chosen, delta=1e-6)
        self.click(self.form_.forward)
        self.finish("Ok")
        self.assertEqual(self.doc.UndoCount, undos)
        self.doc.undo()
        self.assertEqual(self.names(), ["Left", "Right"])

    def test_the_change_of_speed_has_its_own_handle(self):
        chord = (self.obj.Shape.Vertexes[1].Point - self.obj.Shape.Vertexes[0].Point).Length
        handle = self.handle(FIRST_CHANGE)
        self.drag(FIRST_CHANGE, handle.distance - 0.1 * chord)
        self.assertTrue(self.obj.FirstBeta2Fixed)
        self.assertFalse(self.obj.FirstBeta1Fixed)
        self.assertAlmostEqual(self.handle(FIRST_CHANGE).distance, handle.distance - 0.1 * chord,
                               delta=0.5)

    def test_cannot_be_pushed_through_the_end(self):
        self.drag(FIRST, -40.0)
        self.assertEqual(self.obj.FirstBeta1, 0.02)
        self.assertEqual(self.obj.Status, "OK")

    def test_double_click_lets_it_be_chosen_again(self):
        chosen = self.obj.FirstBeta1
        self.drag(FIRST, 30.0)
        QTest.mouseDClick(self.canvas, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier,
                          self.place(FIRST))
        self.pump()
        self.assertFalse(self.obj.FirstBeta1Fixed)
        self.assertAlmostEqual(self.obj.FirstBeta1, chosen, delta=1e-6)

    def test_escape_takes_a_drag_back(self):
        chosen = self.obj.FirstBeta1
        target = self.place(FIRST, 30.0)
        self.press_at(self.place(FIRST))
        self.move_to(target)
        QTest.keyClick(self.canvas, Qt.Key.Key_Escape)
        self.pump()
        self.assertIsNotNone(self.form())
        self.assertFalse(self.obj.FirstBeta1Fixed)
        self.assertAlmostEqual(self.obj.FirstBeta1, chosen, delta=1e-6)
        self.let_go_at(target)
        self.assertFalse(self.obj.FirstBeta1Fixed)

    def test_keys_step_back_and_forward(self):
        self.drag(FIRST, 30.0)
        dragged = self.obj.FirstBeta1
        for widget in (self.canvas, self.form_.fair):
            QTest.keyClick(widget, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
            self.pump()
            self.assertFalse(self.obj.FirstBeta1Fixed)
            QTest.keyClick(widget, Qt.Key.Key_Y, Qt.KeyboardModifier.ControlModifier)
            self.pump()
            self.assertAlmostEqual(self.obj.FirstBeta1, dragged, delta=1e-9)

    def test_in_perspective_and_from_the_side(self):
        self.view().setCameraType("Perspective")
        self.view().viewIsometric()
        self.view().fitAll()
        self.pump()
        self.drag(FIRST, 30.0)
        self.assertAlmostEqual(self.handle(FIRST).distance, 30.0, delta=1.0)

    def test_order_zero_has_no_handles(self):
        self.click(self.form_.ends[0].order.buttons[0])
        keys = {handle.key for handle in handles_of(self.obj, self.obj.Proxy.result, colors.SIDES)}
        self.assertEqual(keys, {("Second", 1), ("Second", 2)})
        self.click(self.form_.ends[1].order.buttons[1])
        keys = {handle.key for handle in handles_of(self.obj, self.obj.Proxy.result, colors.SIDES)}
        self.assertEqual(keys, {("Second", 1)})

    def test_a_fixed_handle_stays_where_the_order_changes(self):
        self.drag(FIRST, 30.0)
        distance = self.handle(FIRST).distance
        for order in (4, 1, 2):
            self.click(self.form_.ends[0].order.buttons[order])
            self.assertAlmostEqual(self.handle(FIRST).distance, distance, delta=1e-9)

    def test_a_step_of_a_drag_takes_less_than_a_60th_of_a_second(self):
        for end in self.form_.ends:
            self.click(end.order.buttons[4])
        panel = self.form_.panel
        took, count = math.inf, 20
        for step in range(count):
            started = time.process_time()
            panel.handles.moved.emit(FIRST, 20.0 + 0.2 * step)
            took = min(took, time.process_time() - started)
        print(f"[{1e3 * took:.1f} ms] ", end="")
        self.assertLess(took, 1.0 / 60.0)


class LookTest(HandleCase):
    def test_are_seen_on_light_and_dark(self):
        for name, background in (("light", LIGHT), ("dark", DARK)):
            self.set_background(background)
            image = self.image(f"handles_{name}")
            for color in (*colors.SIDES, colors.MADE):
                self.assertGreater(self.count_pixels(image, color), 150)

    def test_closing_leaves_no_trace(self):
        scene = self.view().getSceneGraph()
        self.finish("Ok")
        children = [child.getName().getString() for child in scene.getChildren()]
        self.assertNotIn("OsculateOverlay", children)
        self.assertEqual(self.count_pixels(self.image("handles_gone"), colors.SIDES[0]), 0)
        self.fit()
        self.move_to(QtCore.QPoint(100, 100), Qt.MouseButton.NoButton)

    def test_the_knob_at_the_mouse_says_its_number(self):
        before = self.image("handle_cool")
        self.move_to(self.place(FIRST), Qt.MouseButton.NoButton)
        self.assertNotEqual(self.image("handle_hot"), before)
        self.assertEqual(self.canvas.cursor().shape(), Qt.CursorShape.PointingHandCursor)
        self.move_to(QtCore.QPoint(5, 5), Qt.MouseButton.NoButton)
        self.assertNotEqual(self.canvas.cursor().shape(), Qt.CursorShape.PointingHandCursor)

    def test_works_in_a_second_view(self):
        FreeCADGui.runCommand("Std_ViewCreate")
        self.pump()
        self.click(self.form_.symmetric)  # shows the handles anew
        _, self.canvas = widgets_of(self.view())
        self.fit()
        self.drag(FIRST, 30.0)
        self.assertAlmostEqual(self.handle(FIRST).distance, 30.0, delta=1.0)

    def test_the_curve_inside_a_part_has_its_handles_at_its_ends(self):
        self.finish("Ok")
        part = self.doc.addObject("App::Part", "Part")
        part.Placement.Base = FreeCAD.Vector(0, 0, 40)
        part.addObject(self.obj)
        self.obj.touch()
        self.doc.recompute()
        self.obj.ViewObject.doubleClicked()
        self.wait_for(lambda: self.form() is not None, "the panel")
        self.assertEqual(self.handle(FIRST).origin, (50.0, 20.0, 0.0))
