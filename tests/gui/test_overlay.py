"""What is drawn in the 3D view, read from its pixels and from its scene."""

from osculate.gui import colors, preferences

import FreeCADGui
import samples
from gui_case import DARK, LIGHT, GuiCase


class OverlayTest(GuiCase):
    def setUp(self):
        super().setUp()
        self.first, self.second = samples.space_curves(self.doc)
        self.fit()

    def show(self):
        return self.analyze((self.first, "Edge1"), (self.second, "Edge1"))

    def children(self):
        return self.view().getSceneGraph().getNumChildren()

    def test_everything_is_drawn_on_light_and_dark(self):
        self.show()
        for name, background in (("light", LIGHT), ("dark", DARK)):
            self.set_background(background)
            image = self.image(f"overlay_{name}")
            for color, least in ((colors.ORDERS[1], 400), ("#ffffff", 1500),
                                 *((color, 300) for color in colors.SIDES),
                                 *((color, 60) for color in colors.FRAME)):
                with self.subTest(background=name, color=color):
                    self.assertGreater(self.count_pixels(image, color), least)
        self.screenshot("overlay_panel")

    def test_label_takes_the_colour_of_the_order(self):
        first, second = samples.cut_curve(self.doc)
        self.analyze((first, "Edge1"), (second, "Edge1"))
        self.fit()
        image = self.image("overlay_g4")
        self.assertGreater(self.count_pixels(image, colors.ORDERS[4]), 400)
        self.assertEqual(self.count_pixels(image, colors.ORDERS[1]), 0)

    def test_follows_an_edit(self):
        self.show()
        self.assertEqual(self.count_pixels(self.image("before_edit"), colors.GAP), 0)
        self.second.Placement.Base.y = 2.0
        self.pump()
        self.assertGreater(self.count_pixels(self.image("after_edit"), colors.GAP), 300)

    def test_closing_leaves_no_trace(self):
        FreeCADGui.Selection.clearSelection()
        before, plain = self.children(), self.image("plain")
        self.show()
        self.assertEqual(self.children(), before + 1)
        self.close_panel()
        FreeCADGui.Selection.clearSelection()
        self.assertEqual(self.children(), before)
        self.assertEqual(self.image("closed"), plain)

    def test_is_in_every_view_even_a_new_one_and_leaves_all(self):
        self.show()
        FreeCADGui.runCommand("Std_ViewCreate")
        self.second.Placement.Base.y = 2.0
        self.pump()
        document = FreeCADGui.getDocument(self.doc.Name)
        scenes = [view.getSceneGraph()
                  for view in document.mdiViewsOfType("Gui::View3DInventor")]
        self.assertGreater(len(scenes), 1)
        self.assertTrue(all(self.overlays_in(scene) for scene in scenes))
        self.close_panel()
        self.assertFalse(any(self.overlays_in(scene) for scene in scenes))

    @staticmethod
    def overlays_in(scene):
        return [child for child in scene.getChildren()
                if child.getName().getString() == "OsculateOverlay"]

    def test_frame_keeps_its_size_on_the_screen(self):
        self.show()
        height = self.view().getCameraNode().height
        near = self.count_pixels(self.image("frame_near"), colors.FRAME[1])
        height.setValue(3.0 * height.getValue())
        far = self.count_pixels(self.image("frame_far"), colors.FRAME[1])
        self.assertGreater(far, 0.6 * near)

    def test_perspective(self):
        self.show()
        orthographic = self.count_pixels(self.image("orthographic"), colors.FRAME[1])
        self.view().setCameraType("Perspective")
        self.view().fitAll()
        perspective = self.count_pixels(self.image("perspective"), colors.FRAME[1])
        self.assertGreater(perspective, 0.5 * orthographic)
        self.assertLess(perspective, 2.0 * orthographic)

    def fitted_height(self):
        self.fit()
        return self.view().getCameraNode().height.getValue()

    def test_frames_and_labels_do_not_count_where_a_view_is_fitted(self):
        before = self.fitted_height()
        preferences.save(preferences.Preferences(show_polygons=False, frame_pixels=300))
        self.show()
        self.assertAlmostEqual(self.fitted_height(), before, delta=0.01)

    def test_control_polygons_count_where_a_view_is_fitted(self):
        before = self.fitted_height()
        self.show()
        with_poles = self.fitted_height()
        self.assertGreater(with_poles, before)
        self.assertAlmostEqual(self.fitted_height(), with_poles, places=4)

    def test_cannot_be_picked(self):
        self.show()
        x, y = self.view().getPointOnScreen(self.first.Shape.Vertexes[1].Point)
        picked = self.view().getObjectInfo((x, y))
        self.assertIn(picked["Object"], ("Arriving", "Leaving"))

    def test_preferences_choose_parts_and_colours(self):
        preferences.save(preferences.Preferences(
            show_frames=False, show_polygons=False, side_colors=("#00aaaa", "#aaaa00")))
        self.show()
        image = self.image("overlay_preferences")
        self.assertEqual(self.count_pixels(image, colors.FRAME[1]), 0)
        self.assertEqual(self.count_pixels(image, colors.SIDES[0]), 0)
        self.assertGreater(self.count_pixels(image, "#00aaaa"), 200)
        self.assertGreater(self.count_pixels(image, "#aaaa00"), 200)
