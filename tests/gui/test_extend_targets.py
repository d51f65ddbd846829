"""Where an extension ends: points, directions, curvatures, in its panel."""

import FreeCAD

import samples
from test_extend import OpenCase

V = FreeCAD.Vector


class TargetTest(OpenCase):
    def ends_at(self, point):
        edge = self.obj.Shape.Edges[-1]
        return edge.valueAt(edge.LastParameter).isEqual(V(*point), 1e-6)

    def test_targets_begin_where_the_curve_is(self):
        self.click(self.form_.order.buttons[2])
        before = self.obj.Shape.Edges[0].valueAt(1.0)
        targets = self.form_.targets
        self.choose(targets.point, "position")
        self.click(targets.direction)
        self.choose(targets.curvature, "magnitude")
        self.assertEqual(self.obj.Status, "OK")
        self.assertTrue(self.ends_at(before))
        self.screenshot("extend_targets")
        self.type_number(targets.position.boxes[0], "95")
        self.type_number(targets.vector.boxes[2], "0")
        self.type_number(targets.magnitude, "0")
        self.assertEqual(self.obj.Status, "OK")
        self.assertTrue(self.ends_at((95, before.y, before.z)))
        self.assertAlmostEqual(self.obj.Shape.Edges[0].tangentAt(1.0).z, 0.0, delta=1e-6)
        self.assertAlmostEqual(self.obj.Shape.Edges[0].curvatureAt(1.0), 0.0, delta=1e-6)

    def test_a_vertex_is_picked_and_followed(self):
        self.click(self.form_.order.buttons[2])
        self.click(self.form_.targets.pick)
        self.assertIn("Click a vertex", self.form_.advice.text())
        self.select((self.goal, "Vertex1"))
        self.assertEqual((self.obj.PointTarget, self.obj.Status), ("vertex", "OK"))
        self.assertFalse(self.form_.targets.pick.isChecked())
        self.assertEqual(self.form_.targets.vertex.toolTip(), "Goal.Vertex1")
        self.assertTrue(self.ends_at((90, 30, 0)))
        self.screenshot("extend_vertex")
        self.goal.Placement.Base.z = 4.0
        self.doc.recompute()
        self.pump()
        self.assertTrue(self.ends_at((90, 30, 4)))

    def test_a_place_is_picked(self):
        line, _ = samples.line_and_arc(self.doc)
        line.Placement.Base.y = 50.0
        self.doc.recompute()
        self.click(self.form_.order.buttons[1])
        self.click(self.form_.targets.pick)
        self.select_at(line, "Edge1", (30, 50, 0))
        self.assertEqual(self.obj.PointTarget, "position")
        self.assertTrue(self.ends_at((30, 50, 0)))

    def test_its_own_vertex_is_refused(self):
        self.click(self.form_.targets.pick)
        self.select((self.obj, "Vertex2"))
        self.assertIn("cannot use its edges", self.form_.advice.text())
        self.assertEqual(self.obj.PointTarget, "none")
        self.click(self.form_.targets.pick)
        self.assertFalse(self.form_.advice.isVisible())

    def test_choosing_a_vertex_asks_for_one(self):
        self.choose(self.form_.targets.point, "vertex")
        self.assertTrue(self.form_.targets.pick.isChecked())
        self.assertEqual(self.form_.targets.point.currentData(), "none")
