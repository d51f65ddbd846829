"""Subdivide, Raise degree, Attach neighbour, Project from 4D."""

from osculate import BezierTetrahedron, solids
from osculate.features.bezier_solid import is_solid
from solid_case import SolidCase


class PartsCase(SolidCase):
    def made(self, source):
        return [obj for obj in self.doc.Objects if is_solid(obj) and obj != source]

    def values_made(self, source):
        return [obj.Proxy.value for obj in self.made(source)]


class SubdivideTest(PartsCase):
    command = "Osculate_SubdivideSolid"

    def test_all_ways(self):
        obj = self.solid(solids.random(3, 2))
        value = obj.Proxy.value
        form = self.run_on_objects(obj)
        self.assertEqual(self.values_made(obj), value.subdivided())
        self.assertFalse(obj.Visibility)
        self.type_number(form.fields["place"].boxes[1], "3")
        self.assertEqual(self.values_made(obj), value.subdivided((1 / 6, 3 / 6, 1 / 6, 1 / 6)))
        self.fit()
        self.screenshot("solid_subdivide")
        self.choose(form.fields["how"].box, "refined")
        self.assertEqual(self.values_made(obj), value.refined())
        self.choose(form.fields["how"].box, "halves")
        self.choose(form.fields["edge"].box, "1–3")
        self.assertEqual(self.values_made(obj), list(value.bisected(1, 3)))
        self.finish("Ok")
        self.assertAlmostEqual(sum(part.Volume.Value for part in self.made(obj)) / obj.Volume.Value,
                               1.0, delta=1e-9)
        self.doc.undo()
        self.assertEqual(([obj], True), (self.doc.Objects, obj.Visibility))

    def test_bad_place_and_cancel(self):
        obj = self.solid()
        before = self.as_it_was()
        form = self.run_on_objects(obj)
        self.type_number(form.fields["place"].boxes[0], "-1")
        self.assertIn("Shares must be 0 or more", form.trouble.text())
        self.press("Ok")
        self.assertIsNotNone(self.form())
        self.finish("Cancel")
        self.assertEqual(self.as_it_was(), before)

    def test_inside_a_part(self):
        obj = self.solid()
        part = self.doc.addObject("App::Part", "Part")
        part.addObject(obj)
        self.doc.recompute()
        self.run_on_objects(obj)
        self.finish("Ok")
        for piece in self.made(obj):
            self.assertEqual(piece.getParentGeoFeatureGroup(), part)


class ElevateTest(PartsCase):
    def test_raises_and_is_one_step(self):
        first, second = self.solid(), self.solid(solids.random(3, 2))
        expected = [obj.Proxy.value.elevated() for obj in (first, second)]
        self.run_command("Osculate_ElevateSolid", first, second)
        self.assertEqual([first.Proxy.value, second.Proxy.value], expected)
        self.doc.undo()
        self.assertEqual((len(first.Points), len(second.Points)), (10, 20))

    def test_not_beyond_the_highest_degree(self):
        obj = self.solid(solids.random(12, 1))
        self.select((obj, ""))
        self.assertFalse(self.is_active("Osculate_ElevateSolid"))


class AttachTest(PartsCase):
    command = "Osculate_AttachSolid"

    def test_orders_and_faces(self):
        value = solids.random(3, 2)
        obj = self.solid(BezierTetrahedron(3, value.points))
        form = self.run_on_objects(obj)
        for face, order in ((0, 1), (2, 0), (3, 2), (1, 3)):
            self.choose(form.fields["face"].box, face)
            form.fields["order"].box.setValue(order)
            self.pump()
            report = obj.Proxy.value.contact(self.values_made(obj)[0])
            self.assertEqual((report.faces[0], report.order), (face, order), form.trouble.text())
            self.assertFalse(report.overlaps)
        self.finish("Ok")
        self.doc.undo()
        self.assertEqual(self.doc.Objects, [obj])

    def test_corner_at_a_place(self):
        corners = ((0, 0, 0), (50, 0, 0), (0, 50, 0), (0, 0, 50))
        obj = self.solid(solids.tetrahedron(*corners).elevated())
        form = self.run_on_objects(obj)
        self.assertFalse(form.fields["point"].widget.isVisible())
        before = self.values_made(obj)[0].evaluate([1, 0, 0, 0])
        self.choose(form.fields["corner"].box, "place")
        self.assertTrue(form.fields["point"].widget.isVisible())
        after = self.values_made(obj)[0].evaluate([1, 0, 0, 0])
        self.assertLess(abs(after - before).max(), 1e-9)  # it begins where the corner was
        for box, number in zip(form.fields["point"].row.boxes, ("60", "70", "80")):
            self.type_number(box, number)
        self.assertEqual(self.values_made(obj)[0].evaluate([1, 0, 0, 0]).tolist(), [60, 70, 80])
        self.fit()
        self.screenshot("solid_attach")
        self.finish("Cancel")
        self.assertEqual(self.doc.Objects, [obj])

    def test_what_cannot_be_is_said(self):
        obj = self.solid(solids.random(3, 2))
        form = self.run_on_objects(obj)
        self.choose(form.fields["face"].box, 3)
        made = self.values_made(obj)
        form.fields["order"].box.setValue(2)
        self.pump()
        self.assertIn("forces a weight of -0.318", form.trouble.text())
        self.assertEqual(self.values_made(obj), made)  # the last good one stays
        self.type_number(form.fields["reach"].box, "0.3")
        self.assertEqual(form.trouble.text(), "")
        self.assertEqual(obj.Proxy.value.contact(self.values_made(obj)[0]).order, 2)


class ProjectTest(PartsCase):
    command = "Osculate_ProjectSolid"

    def test_parallel_and_perspective(self):
        obj = self.solid(solids.random(3, 4, 4))
        value = obj.Proxy.value
        form = self.run_on_objects(obj)
        self.assertEqual(self.values_made(obj), [value.project()])
        self.type_number(form.fields["direction"].boxes[0], "1")
        self.assertEqual(self.values_made(obj), [value.project((1, 0, 0, 1))])
        self.choose(form.fields["how"].box, "perspective")
        self.assertEqual(form.trouble.text(), "")
        for box, number in zip(form.fields["centre"].boxes, ("10", "20", "30", "400")):
            self.type_number(box, number)
        self.assertEqual(self.values_made(obj), [value.project((1, 0, 0, 1), (10, 20, 30, 400))])
        self.darken()
        self.fit()
        self.screenshot("solid_project_dark")
        for box in (form.fields["direction"].boxes[0], form.fields["direction"].boxes[3]):
            self.type_number(box, "0")
        self.assertIn("direction", form.trouble.text())
        self.finish("Cancel")
        self.assertEqual(([obj], True), (self.doc.Objects, obj.Visibility))

    def test_only_from_four_dimensions(self):
        self.select((self.solid(), ""))
        self.assertFalse(self.is_active(self.command))
