"""The form of Blend: orders, numbers, ends, degree, fairness, steps."""

from test_blend import BlendCase


class FormTest(BlendCase):
    def setUp(self):
        super().setUp()
        self.form_ = self.blend_both()
        self.obj = self.doc.BlendCurve

    def test_orders(self):
        for order in (0, 4):
            self.click(self.form_.ends[0].order.buttons[order])
            self.assertEqual((self.obj.FirstOrder, self.obj.Status), (order, "OK"))
            self.assertEqual([row.box.isVisible() for row in self.form_.ends[0].numbers],
                             [k <= order for k in range(1, 9)])
        self.assertEqual(self.form_.degree.value(), 8)

    def test_fixing_and_freeing_a_number(self):
        row = self.form_.ends[0].numbers[1]
        chosen = self.obj.FirstBeta2
        self.click(row.lock)
        self.assertEqual((self.obj.FirstBeta2, self.obj.FirstBeta2Fixed), (chosen, True))
        self.type_number(row.box, "-2")
        self.assertEqual(self.obj.FirstBeta2, -2.0)
        self.click(row.lock)
        self.assertFalse(self.obj.FirstBeta2Fixed)
        self.assertAlmostEqual(self.obj.FirstBeta2, chosen, delta=1e-6)
        self.assertAlmostEqual(row.box.value(), chosen, delta=1e-5)

    def test_slider_changes_live_and_is_one_step(self):
        row = self.form_.ends[0].numbers[0]
        row.slider.setSliderDown(True)
        lengths = set()
        for place in (-200, 0, 200):
            row.slider.setValue(place)
            lengths.add(self.obj.Shape.Length)
        row.slider.setSliderDown(False)
        self.pump()
        self.assertEqual(len(lengths), 3)
        self.assertAlmostEqual(self.obj.FirstBeta1, 10.0 ** 0.2, delta=1e-9)
        self.click(self.form_.back)
        self.assertFalse(self.obj.FirstBeta1Fixed)
        self.assertFalse(self.form_.back.isEnabled())
        self.click(self.form_.forward)
        self.assertAlmostEqual(self.obj.FirstBeta1, 10.0 ** 0.2, delta=1e-9)

    def test_fixed_numbers_do_not_jump_with_the_order(self):
        self.type_number(self.form_.ends[0].numbers[0].box, "0.9")
        for order in (4, 2, 1, 3):
            self.click(self.form_.ends[0].order.buttons[order])
            self.assertEqual(self.form_.ends[0].numbers[0].box.value(), 0.9)

    def test_fair_frees_all_and_shows_what_it_gains(self):
        self.type_number(self.form_.ends[0].numbers[0].box, "3")
        worse = self.obj.Variation
        self.click(self.form_.fair)
        self.assertLess(self.obj.Variation, worse)
        self.assertFalse(self.obj.FirstBeta1Fixed)
        self.assertIn("−", self.form_.energies.text())
        self.screenshot("blend_fair")

    def test_flip_and_nearest(self):
        end = self.form_.ends[0].end
        self.click(end)
        self.assertEqual((self.obj.FirstEnd, self.obj.EndsMade), ("start", "start-start"))
        end.actions_["nearest"].trigger()
        self.pump()
        self.assertEqual(self.obj.EndsMade, "end-start")

    def test_place_inside(self):
        end = self.form_.ends[0]
        end.end.actions_["inside-forward"].trigger()
        self.pump()
        self.assertTrue(end.position.isVisible())
        end.position.box.setValue(25.0)
        self.pump()
        self.assertEqual((self.obj.FirstPosition, self.obj.Status), (0.25, "OK"))
        self.screenshot("blend_inside")
        self.click(end.end)
        self.assertEqual(self.obj.FirstEnd, "inside-backward")

    def test_degree(self):
        before = self.obj.Variation
        self.form_.degree.setValue(10)
        self.pump()
        self.assertEqual((self.obj.Degree, self.obj.CurveDegree), (10, 10))
        self.assertLessEqual(self.obj.Variation, before * (1 + 1e-9))
        self.click(self.form_.ends[0].order.buttons[4])
        self.assertEqual(self.obj.CurveDegree, 10)
        self.form_.degree.setValue(8)
        self.pump()
        self.assertEqual((self.obj.Degree, self.obj.CurveDegree), (0, 8))

    def test_degree_that_the_orders_outgrow(self):
        self.form_.degree.setValue(8)
        for end in self.form_.ends:
            self.click(end.order.buttons[4])
        self.assertEqual(self.obj.Status, "OK")
        self.assertEqual(self.form_.degree.value(), 9)

    def test_follows_the_model(self):
        self.first.Placement.Base.z = 5.0
        self.pump()
        self.assertAlmostEqual(self.obj.Shape.Edges[0].valueAt(0.0).z, 5.0, delta=1e-9)
        self.doc.recompute()
        self.pump()
        self.assertNotIn("Touched", self.obj.State)

    def test_dark(self):
        self.darken()
        self.screenshot("blend_dark")
