"""The handles of an extension in the 3D view, used with the mouse."""

from handle_case import HandleUser
from osculate.gui import colors
from osculate.gui.construct.extend_handles import handles_of
from test_extend import ExtendCase

SPEED, CHANGE, LENGTH = ("", 1), ("", 2), ("Length", 0)


class HandleTest(HandleUser, ExtendCase):
    def setUp(self):
        super().setUp()
        self.form_ = self.extend()
        self.obj = self.doc.ExtendedCurve
        self.click(self.form_.order.buttons[2])

    def handles(self):
        return handles_of(self.obj, self.obj.Proxy.result, colors.SIDES[0])

    def keys(self):
        return {handle.key for handle in self.handles()}

    def test_the_foremost_point_has_its_handle(self):
        """The curve rises towards the viewer, behind the camera of the view from the top."""
        place = self.place(LENGTH)
        picture = self.image("extend_foremost", self.view().getSize())
        around = picture.copy(place.x() - 15, place.y() - 15, 31, 31)
        self.assertGreater(self.count_pixels(around, colors.MADE), 60)

    def test_the_length_is_dragged(self):
        self.fit()
        before = self.obj.WantedLength.Value
        self.drag(LENGTH, 12.0)
        self.assertTrue(self.obj.WantedLengthFixed)
        self.assertGreater(self.obj.WantedLength.Value, before + 5.0)
        self.assertAlmostEqual(self.obj.Shape.Length, self.obj.WantedLength.Value, delta=1e-6)
        self.assertTrue(self.form_.length.lock.isChecked())
        self.screenshot("extend_handles")
        self.click(self.form_.back)
        self.assertFalse(self.obj.WantedLengthFixed)

    def test_the_speed_is_dragged(self):
        self.fit()
        handle = self.handle(SPEED)
        self.drag(SPEED, 0.8 * handle.distance)
        self.assertTrue(self.obj.Beta1Fixed)
        self.assertEqual(self.obj.Status, "OK")

    def test_a_tangential_coordinate_is_dragged(self):
        self.choose(self.form_.numbers, "tangential coordinates")
        self.assertEqual(self.keys(), {("Tangential", 1), ("Tangential", 2), LENGTH})
        self.fit()
        self.drag(("Tangential", 1), 12.0)
        self.assertAlmostEqual(self.obj.Tangential1.Value, 12.0, delta=1.0)
        self.assertTrue(self.obj.Tangential1Fixed)

    def test_which_there_are(self):
        self.assertEqual(self.keys(), {SPEED, CHANGE, LENGTH})
        self.choose(self.form_.targets.point, "position")
        self.assertEqual(self.keys(), {SPEED, CHANGE})
        self.choose(self.form_.targets.point, "none")
        self.choose(self.form_.continuation, "natural")
        self.assertEqual(self.keys(), {LENGTH})
        self.choose(self.form_.continuation, "parametric")
        self.assertEqual(self.keys(), set())
