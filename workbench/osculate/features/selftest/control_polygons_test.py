"""Tests of the document object ControlPolygons."""

import FreeCAD
import numpy
import Part

from osculate.features import make_control_polygons
from osculate.features.control_polygons import ControlPolygons, arrows_of
from osculate.features.selftest.feature_case import FeatureCase

V = FreeCAD.Vector


def spline():
    """A cubic with three spans."""
    curve = Part.BSplineCurve()
    curve.buildFromPolesMultsKnots([V(0, 0), V(10, 20), V(20, 0), V(40, 10, 5), V(50, 0), V(70, 5)],
                                   [4, 1, 1, 4], [0, 1, 2, 4], False, 3)
    return curve.toShape()


class ControlPolygonsTest(FeatureCase):
    """The line and the arc of radius 20 that touches it, and a cubic B-spline."""

    def setUp(self):
        super().setUp()
        self.spline = self.add("Spline", spline())

    def polygons(self, *sources, **options):
        return make_control_polygons(self.doc, sources or (self.line, self.arc, self.spline),
                                     **options)

    def test_says_what_the_curves_are_made_of(self):
        obj = self.polygons()
        self.assertEqual((obj.Status, obj.EdgeCount, obj.Warnings), ("OK", 3, []))
        self.assertEqual((obj.Segments, obj.RationalSegments, obj.Poles), (5, 1, 2 + 3 + 12))
        self.assertEqual(obj.Degrees, [1, 2, 3])

    def test_poles_of_a_quarter_of_a_circle(self):
        found = self.polygons(self.arc).Proxy.result
        expected = [(50, 0, 0), (70, 0, 0), (70, 20, 0)]
        numpy.testing.assert_allclose(found.poles, expected, atol=1e-12)
        self.assertAlmostEqual(found.weights[1] / found.weights[0], 0.5 ** 0.5, delta=1e-14)

    def test_placement_of_a_part_around_counts(self):
        part = self.doc.addObject("App::Part", "Part")
        part.addObject(self.line)
        part.Placement.Base = V(0, 0, 7)
        self.doc.recompute()
        poles = self.polygons((part, "Line.Edge1")).Proxy.result.poles
        numpy.testing.assert_allclose(poles, [(0, 0, 7), (50, 0, 7)], atol=1e-12)

    def test_differences_are_plain_or_poles_of_derivatives(self):
        polygons = self.polygons().Proxy.result
        plain, factor = arrows_of(polygons, 1, "plain")
        self.assertEqual((factor, len(plain.vectors)), (1.0, 1 + 2 + 9))
        found, factor = arrows_of(polygons, 1, "derivatives")
        self.assertEqual(len(found.vectors), 1 + 9)  # none of the arc, which is rational
        numpy.testing.assert_allclose(found.vectors[1:], 3.0 * plain.vectors[3:], atol=1e-12)
        longest = factor * numpy.linalg.norm(found.vectors, axis=1).max()
        self.assertLess(longest, 0.25 * 80)
        self.assertGreater(longest, 0.05 * 70)

    def test_second_differences_of_a_line_do_not_exist(self):
        polygons = self.polygons(self.line).Proxy.result
        for scaling in ("plain", "derivatives"):
            self.assertEqual(len(arrows_of(polygons, 2, scaling)[0].vectors), 0)

    def test_follows_edits_and_knows_it(self):
        obj = self.polygons(self.arc)
        self.assertFalse(obj.Proxy.follow(obj))
        self.arc.Shape = spline()  # and no recompute
        self.assertTrue(obj.Proxy.follow(obj))
        self.assertEqual(len(obj.Proxy.result.counts), 3)
        self.doc.recompute()
        self.assertEqual((obj.Segments, obj.RationalSegments), (3, 0))

    def test_look_asks_for_no_recompute(self):
        obj = self.polygons()
        obj.Weights = obj.FirstDifferences = obj.SecondDifferences = True
        obj.DifferenceScale = "derivatives"
        self.assertNotIn("Touched", obj.State)

    def test_deleted_edges(self):
        obj = self.polygons(self.line, self.arc)
        self.doc.removeObject(self.line.Name)
        self.doc.recompute()
        self.assertEqual((obj.Status, obj.Segments), ("OK", 1))
        self.doc.removeObject(self.arc.Name)
        obj.touch()
        self.doc.recompute()
        self.assertIn("No edge is linked", obj.Status)
        self.assertIsNone(obj.Proxy.result)

    def test_wrong_options_leave_the_document_alone(self):
        with self.assertRaisesRegex(ValueError, "difference_scale: must be one of plain"):
            self.polygons(difference_scale="long")
        self.assertEqual(len(self.doc.Objects), 3)

    def test_survives_saving_and_loading(self):
        obj = self.polygons(self.spline, weights=True, difference_scale="derivatives")
        obj.SecondDifferences = True
        doc = self.save_and_load()
        loaded = doc.ControlPolygons
        self.assertIsInstance(loaded.Proxy, ControlPolygons)
        self.assertNotIn("Touched", loaded.State)
        self.assertEqual((loaded.Weights, loaded.FirstDifferences, loaded.SecondDifferences,
                          loaded.DifferenceScale), (True, False, True, "derivatives"))
        self.assertEqual(loaded.Segments, 3)
