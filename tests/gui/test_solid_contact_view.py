"""How the contact of two Bézier solids is drawn."""

from drawn_case import DrawnCase, nodes_of, show
from gui_case import DARK, LIGHT
from osculate import solids
from osculate.features import make_bezier_solid, make_solid_contact
from osculate.gui import colors
from osculate.gui.solid.contact_node import color_of_layer, description, layers_of

APEX = (-0.6, 0.5, 0.5, 0.6)


class ContactTest(DrawnCase):
    def setUp(self):
        super().setUp()
        value = solids.random(3, 1)
        self.first = make_bezier_solid(self.doc, value)
        self.second = make_bezier_solid(self.doc, value.join(APEX, 1))
        self.contact = make_solid_contact(self.doc, self.first, self.second)
        for solid in (self.first, self.second):
            solid.ViewObject.ShowNet = False
        self.look()

    def report(self):
        return self.contact.Proxy.report

    def test_layers_are_seen_in_the_colours_of_their_orders(self):
        self.assertEqual(self.report().order, 1)
        for name, background in (("light", LIGHT), ("dark", DARK)):
            self.set_background(background)
            image = self.image(f"contact_{name}")
            for color, least in ((colors.of_order(0), 300), (colors.of_order(1), 600),
                                 (colors.ERROR, 200)):
                with self.subTest(background=name, color=color):
                    self.assertGreater(self.count_pixels(image, color), least)

    def test_layers_are_counted_from_the_face(self):
        layers = layers_of(3, 0, 1)
        self.assertEqual([len(layer) for layer in layers], [10, 6, 3])
        self.assertEqual([color_of_layer(layer, 1) for layer in range(3)],
                         [colors.of_order(0), colors.of_order(1), colors.ERROR])
        self.assertEqual(len(layers_of(3, 0, 3)), 4)  # all match, there is no next one

    def test_says_the_deviation_and_by_how_much_the_next_order_is_missed(self):
        text = description(self.report(), 100.0)
        self.assertIn("deviation ≈ 0", text)
        self.assertNotIn("≈", description(self.report(), 1e-6))  # for solids that small it is none
        self.assertIn("C2 misses by", text)

    def drawn(self):
        """The points of all lines and disks of the contact."""
        return [point.getValue() for node in nodes_of(self.contact, "Coordinate3")
                for point in node.point.getValues()]

    def test_follows_an_edit(self):
        before = self.drawn()
        points = self.second.Points
        points[5] = points[5] * 1.05
        self.second.Points = points
        self.doc.recompute()
        self.assertNotEqual(self.drawn(), before)

    def test_faces_that_do_not_meet_show_their_gap(self):
        self.second.Points = [point * 1.2 for point in self.second.Points]
        self.doc.recompute()
        self.assertFalse(self.report().meets)
        self.look()
        image = self.image("contact_gap")
        self.assertGreater(self.count_pixels(image, colors.GAP), 600)
        self.assertEqual(self.count_pixels(image, colors.of_order(1)), 0)
        self.assertIn("mm", description(self.report(), 100.0))

    def test_of_different_degrees(self):
        before = len(nodes_of(self.contact, "SoMarkerSet"))
        self.assertEqual(before, 2 * 3)
        show(self.second, self.second.Proxy.value.elevated(1))
        self.assertEqual(self.report().degree, 4)
        coordinates = nodes_of(self.contact, "Coordinate3")
        self.assertIn(15, [node.point.getNum() for node in coordinates])  # the face at degree 4

    def test_is_there_after_loading_and_gone_with_an_error(self):
        obj = self.reloaded(self.contact)
        self.wait_for(lambda: nodes_of(obj, "SoMarkerSet"), "the drawing")
        self.doc.removeObject("BezierSolid001")
        self.doc.recompute()
        self.assertEqual(nodes_of(obj, "SoMarkerSet"), [])

    def test_does_not_count_where_something_is_picked(self):
        x, y = self.view().getPointOnScreen(self.first.Points[0])
        info = self.view().getObjectInfo((x, y + 3))
        self.assertNotEqual((info or {}).get("Object"), self.contact.Name)
