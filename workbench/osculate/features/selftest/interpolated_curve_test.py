"""Tests of the document object InterpolatedCurve."""

import math
import os
import tempfile

import FreeCAD
import Part

import osculate
from osculate.features import make_interpolated_curve
from osculate.features.interpolated_curve import InterpolatedCurve
from osculate.features.selftest.feature_case import FeatureCase

V = FreeCAD.Vector
POINTS = ((0, 0, 0), (20, 15, 0), (40, 0, 5), (55, 20, 0), (80, 10, 0))


class InterpolatedCurveTest(FeatureCase):
    def make(self, **options):
        options = options or {"points": POINTS}
        return make_interpolated_curve(self.doc, **options)

    def assert_runs_through(self, obj, points):
        for point in points:
            self.assertLess(obj.Shape.distToShape(Part.Vertex(V(*point)))[0], 1e-9)

    def polyline(self):
        return self.add("Polyline", Part.makePolygon([V(*point) for point in POINTS]))

    def test_is_the_curve_of_the_api(self):
        obj = self.make(points=POINTS, tension=3.0, tensions=(None, 10.0))
        self.assertEqual(obj.Status, "OK")
        curve = osculate.nu_spline(POINTS, tension=[3.0, 10.0, 3.0, 3.0, 3.0])
        self.assertEqual([tuple(pole) for pole in obj.Shape.Edges[0].Curve.getPoles()],
                         [tuple(pole) for pole in curve.poles.tolist()])
        self.assert_runs_through(obj, POINTS)
        self.assertEqual(obj.Continuity, ["G2"] * 3)

    def test_without_tension_it_is_smooth_in_its_parameter(self):
        obj = self.make()
        self.assertEqual(set(list(obj.Shape.Edges[0].Curve.getMultiplicities())[1:-1]), {1})

    def test_large_tension_comes_near_the_polygon(self):
        length = self.polyline().Shape.Length
        lengths = [self.make(points=POINTS, tension=tension).Shape.Length
                   for tension in (0.0, 10.0, 1e4)]
        self.assertGreater(lengths[0], lengths[1])
        self.assertGreater(lengths[1], lengths[2])
        self.assertAlmostEqual(lengths[2], length, delta=1e-3 * length)

    def test_vertices_are_followed(self):
        wire = self.polyline()
        obj = self.make(vertices=[(wire, f"Vertex{number}") for number in range(1, 6)])
        self.assert_runs_through(obj, POINTS)
        wire.Placement = FreeCAD.Placement(V(5, 6, 7), FreeCAD.Rotation(V(0, 0, 1), 90))
        self.doc.recompute()
        self.assert_runs_through(obj, [tuple(wire.Placement.multVec(V(*point)))
                                       for point in POINTS])

    def test_closed(self):
        obj = self.make(points=POINTS, ends="closed", tension=1.0)
        self.assertTrue(obj.Shape.isClosed())
        self.assertEqual(set(obj.Continuity), {"G2"})

    def test_other_ends_and_spacings(self):
        shapes = [self.make(points=POINTS, ends=ends, spacing=spacing).Shape.Length
                  for ends, spacing in (("natural", "centripetal"), ("bessel", "centripetal"),
                                        ("natural", "chordal"), ("natural", "uniform"))]
        self.assertEqual(len({round(length, 6) for length in shapes}), 4)

    def test_given_directions(self):
        obj = self.make(points=POINTS, ends="tangents", tangents=((0, 1, 0), (0, 0, 1)))
        edge = obj.Shape.Edges[0]
        for parameter, tangent in zip(edge.ParameterRange, (V(0, 1, 0), V(0, 0, 1))):
            self.assertLess(edge.tangentAt(parameter).getAngle(tangent), 1e-9)

    def test_what_cannot_be_keeps_the_last_good_shape(self):
        obj = self.make()
        length = obj.Shape.Length
        for points in ([V(0, 0, 0)], [V(0, 0, 0), V(0, 0, 0), V(1, 0, 0)]):
            obj.Points = points
            self.doc.recompute()
            self.assertIn("points", obj.Status)
            self.assertFalse(obj.isValid())
            self.assertEqual(obj.Shape.Length, length)
        obj.Points = [V(*point) for point in POINTS]
        self.doc.recompute()
        self.assertEqual(obj.Status, "OK")

    def test_deleted_vertex_stands_in_the_status(self):
        wire = self.polyline()
        obj = self.make(vertices=[(wire, "Vertex1"), (wire, "Vertex2"), (wire, "Vertex5")])
        wire.Shape = Part.makePolygon([V(0, 0, 0), V(1, 0, 0)])
        self.doc.recompute()
        self.assertIn("Polyline has no Vertex5", obj.Status)

    def test_bad_arguments_change_nothing(self):
        for options in ({"tension": -1.0}, {"tension": math.nan}, {"tensions": (1.0, -2.0)},
                        {"ends": "open"}, {"spacing": "even"}, {"ends": "tangents"},
                        {"tangents": ((1, 0, 0),) * 2},
                        {"vertices": [(self.line, "Vertex1")]}):
            with self.subTest(options), self.assertRaises(ValueError):
                self.make(points=POINTS, **options)
        self.assertEqual(len(self.doc.Objects), 2)

    def test_saving_and_loading(self):
        obj = self.make(points=POINTS, tension=2.0, tensions=(None, 5.0))
        before = [tuple(pole) for pole in obj.Shape.Edges[0].Curve.getPoles()]
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "interpolated.FCStd")
            self.doc.saveAs(path)
            FreeCAD.closeDocument(self.doc.Name)
            self.doc = FreeCAD.openDocument(path)
        obj = self.doc.InterpolatedCurve
        self.assertIsInstance(obj.Proxy, InterpolatedCurve)
        obj.touch()
        self.doc.recompute()
        for pole, expected in zip(obj.Shape.Edges[0].Curve.getPoles(), before):
            self.assertTrue(pole.isEqual(V(*expected), 1e-9))

    def test_is_an_ordinary_shape(self):
        obj = self.make()
        extrusion = self.doc.addObject("Part::Extrusion", "Extrusion")
        extrusion.Base, extrusion.Dir, extrusion.LengthFwd = obj, V(0, 0, 1), 10.0
        self.doc.recompute()
        self.assertEqual(len(extrusion.Shape.Faces), 1)
