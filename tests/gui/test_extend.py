"""The command Extend and its panel, used with mouse and keyboard."""

import FreeCAD
import FreeCADGui
import Part

import samples
from construct_case import ConstructCase
from osculate.gui.construct.extend_form import ExtendForm

V = FreeCAD.Vector


class ExtendCase(ConstructCase):
    form_type = ExtendForm
    command = "Osculate_Extend"

    def setUp(self):
        super().setUp()
        self.edge = samples.add_edge(
            self.doc, "Cubic", samples.bezier((0, 0, 0), (20, 0, 0), (40, 10, 0), (50, 20, 10)))
        self.goal = self.doc.addObject("Part::Feature", "Goal")
        self.goal.Shape = Part.Vertex(90, 30, 0)
        self.doc.recompute()
        self.fit()

    def extend(self):
        return self.run_on((self.edge, "Edge1"))

    def select_at(self, obj, sub, point):
        """As a click in the 3D view does."""
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(self.doc.Name, obj.Name, sub, *point)
        self.pump()


class StartTest(ExtendCase):
    def test_a_selected_edge_is_continued_at_once(self):
        form = self.extend()
        obj = self.doc.ExtendedCurve
        self.assertEqual((obj.Status, obj.End), ("OK", "end"))
        self.assertEqual(form.edge.name.text(), "Cubic.Edge1")
        self.assertFalse(form.advice.isVisible())
        self.screenshot("extend_panel")

    def test_an_edge_is_asked_for(self):
        form = self.run_on()
        self.assertIn("Select the edge", form.advice.text())
        self.assertFalse(form.order.isVisible())
        self.screenshot("extend_asks")
        self.select((self.edge, "Edge1"))
        self.assertEqual(self.doc.ExtendedCurve.Status, "OK")

    def test_the_end_near_the_click_is_continued(self):
        for point, end in (((5, 0.2, 0), "start"), ((48, 17, 8), "end")):
            self.select_at(self.edge, "Edge1", point)
            FreeCADGui.runCommand(self.command)
            self.shown_form()
            self.assertEqual(self.doc.ExtendedCurve.End, end)
            self.finish("Cancel")

    def test_a_selected_vertex_is_continued(self):
        self.run_on((self.edge, "Vertex1"))
        self.assertEqual(self.doc.ExtendedCurve.End, "start")

    def test_two_edges_are_refused(self):
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        form = self.run_on((box, "Edge1"), (box, "Edge2"))
        self.assertIn("2 edges", form.advice.text())
        self.finish("Cancel")


class EndTest(ExtendCase):
    def test_ok_is_one_step_of_undo(self):
        undos = self.doc.UndoCount
        form = self.extend()
        self.click(form.order.buttons[2])
        self.type_number(form.length.box, "25")
        self.finish("Ok")
        self.assertEqual(self.doc.UndoCount, undos + 1)
        self.assertAlmostEqual(self.doc.ExtendedCurve.Shape.Length, 25.0, delta=1e-6)
        self.doc.undo()
        self.assertEqual(self.names(), ["Cubic", "Goal"])

    def test_cancel_leaves_the_document_as_it_was(self):
        undos = self.doc.UndoCount
        self.extend()
        self.finish("Cancel")
        self.assertEqual((self.names(), self.doc.UndoCount), (["Cubic", "Goal"], undos))

    def test_editing_and_cancel(self):
        self.extend()
        self.finish("Ok")
        obj = self.doc.ExtendedCurve
        before = obj.Shape.Length
        form = self.edit(obj)
        self.type_number(form.length.box, "12")
        self.assertNotEqual(obj.Shape.Length, before)
        self.finish("Cancel")
        self.assertEqual((obj.Shape.Length, obj.WantedLengthFixed), (before, False))


class FormTest(ExtendCase):
    def setUp(self):
        super().setUp()
        self.form_ = self.extend()
        self.obj = self.doc.ExtendedCurve

    def ends_at(self, point):
        edge = self.obj.Shape.Edges[-1]
        return edge.valueAt(edge.LastParameter).isEqual(V(*point), 1e-6)

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
