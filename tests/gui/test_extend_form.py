"""The form of Extend: orders, length, numbers, degree, fairness."""

import FreeCAD

from test_extend import OpenCase

V = FreeCAD.Vector


class FormTest(OpenCase):
    def test_orders(self):
        for order in (0, 2):
            self.click(self.form_.order.buttons[order])
            self.assertEqual((self.obj.Order, self.obj.Status), (order, "OK"))
            self.assertEqual([row.box.isVisible() for row in self.form_.beta.rows],
                             [k <= order for k in range(1, 9)])

    def test_end(self):
        self.click(self.form_.end)
        self.assertEqual(self.obj.End, "start")
        self.assertTrue(self.obj.Shape.Edges[0].valueAt(0.0).isEqual(V(0, 0, 0), 1e-9))

    def test_length(self):
        self.click(self.form_.order.buttons[2])
        self.type_number(self.form_.length.box, "30")
        self.assertAlmostEqual(self.obj.Shape.Length, 30.0, delta=1e-6)
        self.click(self.form_.length.lock)
        self.assertFalse(self.obj.WantedLengthFixed)
        slider = self.form_.length.slider
        slider.setSliderDown(True)
        lengths = set()
        for place in (-300, 0, 300):
            slider.setValue(place)
            lengths.add(round(self.obj.Shape.Length, 3))
        slider.setSliderDown(False)
        self.pump()
        self.assertEqual(len(lengths), 3)
        self.click(self.form_.back)
        self.assertFalse(self.obj.WantedLengthFixed)

    def test_continuations(self):
        for name, letter in (("parametric", "C"), ("re-parametrised", "C"), ("natural", "G")):
            self.choose(self.form_.continuation, name)
            self.assertEqual((self.obj.Continuation, self.obj.Status), (name, "OK"))
            self.assertEqual(self.form_.order.buttons[2].text(), letter + "2")
            self.assertEqual(self.form_.parameter.box.isVisible(), name == "re-parametrised")
            self.assertFalse(self.form_.beta.rows[0].box.isVisible())
            self.screenshot(f"extend_{name}")
        self.assertFalse(self.form_.target_section.isVisible())

    def test_parameter(self):
        self.click(self.form_.order.buttons[3])
        self.choose(self.form_.continuation, "re-parametrised")
        whole = self.obj.Shape.Length
        self.type_number(self.form_.parameter.box, "0.5")
        self.assertLess(self.obj.Shape.Length, whole)
        self.assertEqual(self.obj.Parameter, 0.5)

    def test_tangential_coordinates(self):
        self.click(self.form_.order.buttons[2])
        self.click(self.form_.number_section.header)
        self.choose(self.form_.numbers, "tangential coordinates")
        row = self.form_.tangential.rows[0]
        self.assertTrue(row.box.isVisible())
        self.assertFalse(self.form_.beta.rows[0].box.isVisible())
        self.type_number(row.box, "8")
        pole = self.obj.Shape.Edges[0].Curve.getPole(2)
        tangent = self.edge.Shape.Edges[0].tangentAt(1.0)
        self.assertAlmostEqual((pole - V(50, 20, 10)).dot(tangent), 8.0, delta=1e-9)
        self.screenshot("extend_tangential")

    def test_under_determined_is_said_and_fair_mends_it(self):
        self.click(self.form_.order.buttons[2])
        self.choose(self.form_.fairness, "none")
        self.assertIn("under-determined", self.form_.trouble.text())
        self.screenshot("extend_trouble")
        self.click(self.form_.fair)
        self.assertEqual((self.obj.Status, self.obj.Fairness), ("OK", "mvc"))

    def test_fixing_a_number_and_degree(self):
        self.click(self.form_.order.buttons[2])
        row = self.form_.beta.rows[0]
        self.type_number(row.box, "0.8")
        self.assertEqual((self.obj.Beta1, self.obj.Beta1Fixed), (0.8, True))
        self.form_.degree.setValue(5)
        self.pump()
        self.assertEqual((self.obj.Degree, self.obj.CurveDegree), (5, 5))
        self.form_.degree.setValue(0)
        self.pump()
        self.assertIn("least", self.form_.degree.text())
        self.click(row.lock)
        self.assertFalse(self.obj.Beta1Fixed)

    def test_together_with_the_edge(self):
        self.click(self.form_.include)
        self.assertEqual(len(self.obj.Shape.Edges), 2)
        self.assertEqual(self.obj.Shape.ShapeType, "Wire")

    def test_dark(self):
        self.click(self.form_.order.buttons[2])
        self.darken()
        self.screenshot("extend_dark")
