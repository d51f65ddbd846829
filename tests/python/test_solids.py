"""osculate.BezierTetrahedron: what it says, what it computes, and what it refuses."""
import math
import pickle
import unittest

import numpy as np

import osculate
from osculate import BezierTetrahedron, BezierTriangle, Curve, solids

MIDDLE = np.full(4, 0.25)


def sample(degree=3, seed=1, dimension=3):
    return solids.random(degree, seed, dimension)


def unit(degree=1):
    """The tetrahedron of the axes, as a polynomial net of this degree."""
    return solids.tetrahedron((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)).elevated(degree - 1)


def inside(count=20, seed=1):
    u = np.random.default_rng(seed).uniform(0.01, 1, (count, 4))
    return u / u.sum(axis=1, keepdims=True)


def bernstein_sum(solid, u):
    """The point by the definition: a sum of Bernstein polynomials."""
    weights = np.ones(len(solid.points)) if solid.weights is None else solid.weights
    basis = [math.factorial(solid.degree) / math.prod(math.factorial(i) for i in index)
             * math.prod(x ** i for x, i in zip(u, index)) for index in solid.indices]
    return (basis * weights) @ solid.points / (basis @ weights)


class DataTest(unittest.TestCase):
    def test_keeps_its_numbers(self):
        points = np.arange(12.0).reshape(4, 3)
        solid = BezierTetrahedron(1, points, [1, 2, 0, 3])
        np.testing.assert_array_equal(solid.points, points)
        np.testing.assert_array_equal(solid.weights, [1, 2, 0, 3])
        self.assertEqual((solid.degree, solid.dimension, solid.is_rational), (1, 3, True))
        self.assertIsNone(BezierTetrahedron(1, points).weights)
        self.assertEqual(BezierTetrahedron(1, np.ones((4, 4))).dimension, 4)

    def test_order_of_the_net(self):
        self.assertEqual(sample(2).indices, [
            [2, 0, 0, 0], [1, 1, 0, 0], [1, 0, 1, 0], [1, 0, 0, 1], [0, 2, 0, 0],
            [0, 1, 1, 0], [0, 1, 0, 1], [0, 0, 2, 0], [0, 0, 1, 1], [0, 0, 0, 2]])

    def test_lists_and_arrays_of_any_layout(self):
        points = sample(2).points
        for form in (points.tolist(), np.asfortranarray(points), np.repeat(points, 2, axis=0)[::2]):
            np.testing.assert_array_equal(BezierTetrahedron(2, form).points, points)

    def test_equality_pickle_and_repr(self):
        for solid in (sample(), unit(2), sample(2, 1, 4), sample().face(1)):
            self.assertEqual(pickle.loads(pickle.dumps(solid)), solid)
        self.assertNotEqual(sample(), sample(seed=2))
        self.assertEqual(repr(sample()),
                         "<osculate.BezierTetrahedron: rational, degree 3, 20 points in E3>")

    def test_nothing_changes_it(self):
        solid = sample()
        with self.assertRaises(AttributeError):
            solid.degree = 2
        array = solid.points
        array += 1
        self.assertFalse(np.array_equal(array, solid.points))

    def test_flat_nets_are_said_to_be(self):
        points = sample(2).points
        points[:, 2] = 7
        self.assertIn("flat", BezierTetrahedron(2, points).warnings[0])
        self.assertEqual(sample().warnings, [])
        points = unit(1).points
        points[1] = points[2]
        self.assertEqual(BezierTetrahedron(1, points).warnings[0],
                         "the net is flat: all points lie in one plane")
        points = sample(2).points
        points[[i[1] + i[2] == 2 for i in sample(2).indices]] = 1
        self.assertEqual(BezierTetrahedron(2, points).warnings,
                         ["edge 1-2 is collapsed to a point"])


class EvaluationTest(unittest.TestCase):
    def test_is_the_sum_of_bernstein_polynomials(self):
        for solid in (unit(3), sample(4), sample(3, 1, 4)):
            for u in inside(5):
                np.testing.assert_allclose(solid.evaluate(u), bernstein_sum(solid, u), rtol=1e-12)

    def test_arrays_and_single_points_agree(self):
        solid = sample(5)
        u = inside(7)
        singly = [solid.evaluate(row) for row in u]
        np.testing.assert_allclose(solid.evaluate(u), singly, rtol=1e-13)
        self.assertEqual(solid.evaluate(u.reshape(7, 1, 4)).shape, (7, 1, 3))
        self.assertEqual(solid.evaluate(np.empty((0, 4))).shape, (0, 3))

    def test_outside_too(self):
        np.testing.assert_allclose(unit(3).evaluate([[-0.5, 0.5, 0.5, 0.5]]), [[0.5, 0.5, 0.5]])

    def test_derivatives(self):
        solid = sample(3)
        d, e = [1, -1, 0, 0], [0, 0.5, 0.5, -1]
        h = 1e-5
        at = [MIDDLE + h * np.array(x) for x in (d, np.negative(d))]
        difference = (solid.evaluate(at[0]) - solid.evaluate(at[1])) / (2 * h)
        np.testing.assert_allclose(solid.derivative(MIDDLE, [d]), difference, rtol=1e-8)
        difference = (solid.derivative(at[0], [e]) - solid.derivative(at[1], [e])) / (2 * h)
        np.testing.assert_allclose(solid.derivative(MIDDLE, [d, e]), difference, rtol=1e-8)
        self.assertEqual(solid.derivative(inside(6), [d, e, d]).shape, (6, 3))

    def test_partial_derivatives_make_directional_ones(self):
        solid = sample(3)
        d = np.array([0.3, -0.5, 0.4, -0.2])
        total = sum(x * solid.partial(MIDDLE, row) for x, row in zip(d, np.eye(4, dtype=int)))
        np.testing.assert_allclose(solid.derivative(MIDDLE, [d]), total, rtol=1e-11)


class OperationsTest(unittest.TestCase):
    def test_elevated(self):
        higher = sample().elevated(2)
        self.assertEqual(higher.degree, 5)
        np.testing.assert_allclose(higher.evaluate(inside()), sample().evaluate(inside()))

    def test_parts_share_the_map(self):
        solid = sample()
        corners = np.eye(4)
        corners[2] = MIDDLE
        np.testing.assert_allclose(solid.subdivided()[2].evaluate(inside()),
                                   solid.evaluate(inside() @ corners), rtol=1e-12)
        corners = inside(4)
        np.testing.assert_allclose(solid.part(corners).evaluate(inside()),
                                   solid.evaluate(inside() @ corners), rtol=1e-12)
        self.assertEqual(len(solid.refined()), 8)
        halves = solid.bisected(0, 3)
        self.assertAlmostEqual(sum(half.volume() for half in halves) / solid.volume(), 1, 12)

    def test_faces_edges_and_cuts(self):
        solid = sample()
        face = solid.face(1)
        self.assertIsInstance(face, BezierTriangle)
        np.testing.assert_allclose(face.evaluate([0.2, 0.3, 0.5]),
                                   solid.evaluate([0.2, 0, 0.3, 0.5]))
        edge = solid.edge(0, 2)
        self.assertIsInstance(edge, Curve)
        np.testing.assert_allclose(edge.evaluate(0.25)[0], solid.evaluate([0.75, 0, 0.25, 0]))
        np.testing.assert_allclose(solid.iso_surface(3, 0.4).evaluate([0.2, 0.3, 0.5]),
                                   solid.evaluate([0.12, 0.18, 0.3, 0.4]))

    def test_relabelled(self):
        solid = sample()
        turned = solid.relabelled([2, 0, 3, 1])
        np.testing.assert_allclose(turned.evaluate([0.1, 0.2, 0.3, 0.4]),
                                   solid.evaluate([0.2, 0.4, 0.1, 0.3]))

    def test_transformed(self):
        matrix = np.array([[0, -1, 0, 5], [1, 0, 0, 6], [0, 0, 2, 7], [0, 0, 0, 1]])
        p = sample().evaluate(inside())
        np.testing.assert_allclose(sample().transformed(matrix).evaluate(inside()),
                                   p @ matrix[:3, :3].T + matrix[:3, 3])
        matrix[3] = [0, 0, 0, 2]
        np.testing.assert_allclose(sample().transformed(matrix).evaluate(inside())[0],
                                   (p @ matrix[:3, :3].T + matrix[:3, 3])[0] / 2)

    def test_volume_centroid_and_inversion(self):
        solid = unit(3)
        self.assertAlmostEqual(solid.volume(), 1 / 6, 15)
        np.testing.assert_allclose(solid.centroid(), [0.25] * 3, rtol=1e-14)
        volume, error = solids.ball_octant(10).volume_and_error()
        self.assertAlmostEqual(volume, 1000 * math.pi / 6, 9)
        self.assertLess(error, 1e-9)
        u = inside(1)[0]
        np.testing.assert_allclose(sample().locate(sample().evaluate(u)), [u], atol=1e-9)
        self.assertEqual(unit().locate([2, 2, 2]).shape, (0, 4))


class ValidityTest(unittest.TestCase):
    def test_certificates(self):
        self.assertEqual(unit(2).jacobian_bounds()[2], "valid")
        low, high, text = unit(2).jacobian_bounds()
        self.assertAlmostEqual(low, 1, 9)
        self.assertAlmostEqual(high, 1, 9)
        self.assertEqual(solids.cone(1, 2).jacobian_bounds()[2],
                         "singular at edge 0-3, edge 1-3, edge 2-3")
        mirrored = unit(2).relabelled([1, 0, 2, 3]).validity()
        self.assertEqual(mirrored.verdict, "inverted")
        self.assertTrue(mirrored.is_mirrored)

    def test_a_fold_has_a_witness(self):
        points = unit(3).points
        points[unit(3).indices.index([1, 1, 1, 0])] += [0, 0, 3]
        solid = BezierTetrahedron(3, points)
        report = solid.validity()
        self.assertEqual(report.verdict, "inverted")
        self.assertLess(solid.jacobian(report.witness), 0)
        self.assertIn("inverted at (", str(report))

    def test_places(self):
        (between, corners), = solids.ball_octant(5).validity().places
        self.assertEqual(between, (3,))
        np.testing.assert_array_equal(corners, [[0, 0, 0, 1]])


class ContactTest(unittest.TestCase):
    APEX = (-0.3, 0.4, 0.5, 0.4)

    def test_neighbours_have_their_order_and_are_valid(self):
        solid = sample(4)
        for order in range(5):
            neighbour = solid.join(self.APEX, order)
            report = solid.contact(neighbour)
            self.assertEqual((report.order, report.homogeneous_order), (order, order))
            self.assertEqual(report.faces, (0, 0))
            self.assertFalse(report.overlaps)
            self.assertEqual(neighbour.validity().verdict, "valid", order)
            if order:
                np.testing.assert_allclose(report.apex, self.APEX, atol=1e-9)

    def test_labels_of_the_thesis(self):
        solid = sample(3)
        neighbour = solid.join(self.APEX, 2, keep_labels=True)
        self.assertEqual(solid.contact(neighbour).corners, (0, 1, 2, 3))
        self.assertTrue(neighbour.validity().is_mirrored)

    def test_residuals_and_gap(self):
        solid = sample(3)
        neighbour = solid.join(self.APEX, 1)
        report = solid.contact(neighbour)
        self.assertEqual(len(report.residuals_mm), 4)
        self.assertLess(report.residuals_mm[1], 1e-9)
        self.assertGreater(report.residuals_mm[2], 1e-3)
        moved = neighbour.transformed([[1, 0, 0, 0.5], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
        report = solid.contact(moved)
        self.assertFalse(report.meets)
        self.assertEqual(report.order, -1)
        self.assertAlmostEqual(report.gap_mm, 0.5, 9)
        self.assertIn("no faces meet", repr(report))

    def test_apex_point_and_face(self):
        solid = sample(3)
        neighbour = solid.join((0.5, -0.3, -0.1, 0.9), 1, face=1, apex_point=(1, 2, 3))
        np.testing.assert_array_equal(neighbour.points[neighbour.indices.index([0, 3, 0, 0])],
                                      [1, 2, 3])
        with self.assertRaisesRegex(ValueError, "give face"):
            solid.join((0.5, -0.3, -0.1, 0.9), 1)

    def test_chain(self):
        links = [(self.APEX, 2), {"apex": (0.5, -0.3, 0.4, 0.4), "order": 1}]
        row = solids.chain(sample(3), links)
        self.assertEqual([a.contact(b).order for a, b in zip(row, row[1:])], [2, 1])

    def test_a_contact_that_cannot_be(self):
        solid = BezierTetrahedron(1, unit().points, [5, 1, 1, 1])
        with self.assertRaisesRegex(osculate.ContactError, "choose the apex nearer"):
            solid.join((-1, 0.5, 0.5, 1), 1)


class SpaceTest(unittest.TestCase):
    def test_parallel_projection_takes_an_embedding_back(self):
        direction = (0.1, -0.2, 0.3, 0.5)
        inside_e4 = sample().embedded(direction)
        self.assertEqual(inside_e4.dimension, 4)
        np.testing.assert_allclose(inside_e4.project(direction).points, sample().points, atol=1e-12)
        normal = inside_e4.normal(MIDDLE)
        np.testing.assert_allclose(normal, np.array(direction) / np.linalg.norm(direction))

    def test_default_direction_drops_the_fourth_coordinate(self):
        solid = sample(2, 1, 4)
        np.testing.assert_array_equal(solid.project().points, solid.points[:, :3])

    def test_perspective(self):
        solid = sample(2, 1, 4)
        image = solid.project(centre=(10, 20, 30, 500))
        x = solid.evaluate(MIDDLE)
        centre = np.array([10, 20, 30, 500])
        q = centre - (centre - x) * 500 / (500 - x[3])
        np.testing.assert_allclose(image.evaluate(MIDDLE), q[:3])
        with self.assertRaisesRegex(ValueError, "both sides"):
            solid.project(centre=(10, 20, 30, 0.01))


class PrimitivesTest(unittest.TestCase):
    def test_volumes(self):
        self.assertAlmostEqual(solids.cone(3, 5).volume(), 15 * math.pi, 10)
        self.assertAlmostEqual(solids.elliptic_cone(3, 2, (1, 1, 4)).volume(), 8 * math.pi, 10)
        wedge = solids.sphere_wedge((0, 0, 0), (2, 0, 0), (0, 2, 0), (0, 0, 2))
        self.assertEqual(len(wedge), 1)
        self.assertAlmostEqual(wedge[0].volume(), 8 * math.pi / 6, 10)
        frustum = solids.frustum_wedge(3, 1, 5)
        self.assertEqual(len(frustum), 12)
        self.assertAlmostEqual(sum(s.volume() for s in frustum), 65 * math.pi / 3, 10)
        quarter = solids.cylinder_wedge(2, 3, 90)
        self.assertAlmostEqual(sum(s.volume() for s in quarter), 3 * math.pi, 10)

    def test_the_apex_is_the_last_point(self):
        np.testing.assert_array_equal(solids.cone(1, 5).points[-1], [0, 0, 5])
        np.testing.assert_array_equal(solids.ball_octant(2).points[-1], [0, 0, 0])

    def test_points_are_on_the_sphere(self):
        face = solids.ball_octant(2).face(3)
        u = np.random.default_rng(1).dirichlet((1, 1, 1), 50)
        np.testing.assert_allclose((face.evaluate(u) ** 2).sum(axis=1), 4, rtol=1e-13)

    def test_random_solids_are_the_same_again(self):
        self.assertEqual(sample(4, 7), sample(4, 7))


class BadInputTest(unittest.TestCase):
    def check(self, message, function, *arguments, error=ValueError, **keywords):
        with self.assertRaisesRegex(error, message):
            function(*arguments, **keywords)

    def test_nets(self):
        points = sample(2).points
        self.check("degree 3 has 20 points, got 10", BezierTetrahedron, 3, points)
        self.check("degree: must be 1 to 12, got 0", BezierTetrahedron, 0, points)
        self.check("degree: must be 1 to 12, got 13", BezierTetrahedron, 13, points)
        self.check("must have 3 coordinates", BezierTetrahedron, 2, points[:, :2])
        self.check("points: must have the shape", BezierTetrahedron, 2, points[0])
        self.check("every coordinate must be finite", BezierTetrahedron, 2, points * math.nan)
        self.check("weights: one for each point", BezierTetrahedron, 2, points, [1, 2])
        self.check("weight must be finite and >= 0", BezierTetrahedron, 2, points, [-1] * 10)
        self.check("weights: at least one must be > 0", BezierTetrahedron, 2, points, [0] * 10)
        self.check("points: must be an array", BezierTetrahedron, 2, "abc", error=TypeError)
        self.check("degree: must be an integer", BezierTetrahedron, 2.5, points, error=TypeError)

    def test_coordinates(self):
        self.check("u: .* must have the sum 1", sample().evaluate, [1, 1, 1, 1])
        self.check(r"u: must have the shape \(.., 4\)", sample().evaluate, [0.5, 0.5])
        self.check("u: must be finite", sample().evaluate, [math.nan, 0, 0, 1])
        self.check("directions: .*sum 0", sample().derivative, MIDDLE, [[1, 0, 0, 0]])
        self.check("orders: must be 4 numbers", sample().partial, MIDDLE, [1, 2])

    def test_operations(self):
        self.check("raised by 0 to 9", sample().elevated, 10)
        self.check("face: must be 0 to 3", sample().face, 4)
        self.check("two different corners", sample().edge, 1, 1)
        self.check("order: must be a permutation", sample().relabelled, [0, 1, 2, 2])
        self.check("matrix: must have the shape", sample().transformed, np.eye(3))
        self.check("order: must be 0 to the degree 3", sample().join, (-1, 1, 0.5, 0.5), 4)
        self.check("must lie beyond the face", sample().join, MIDDLE, 1, face=0)
        self.check("tolerance: must be finite and > 0", sample().jacobian_bounds, 0)
        self.check("project it from E4 first", sample(2, 1, 4).volume)
        self.check("give either n", sample().mesh)
        self.check("give either n", sample().mesh, 3, chordal_mm=1)
        self.check("solid: must be in E4", sample().project)

    def test_primitives(self):
        o, x, y = (0, 0, 0), (1, 0, 0), (0, 1, 0)
        self.check("radius: must be finite and > 0", solids.cone, -1, 1)
        self.check("height: must be finite and not 0", solids.cone, 1, 0)
        self.check("radius: must be a number", solids.cone, "a", 1, error=TypeError)
        self.check("one great circle", solids.sphere_wedge, o, x, y, (-1, 0, 0))
        self.check("same distance from the centre", solids.sphere_wedge, o, x, y, (0, 0, 2))
        self.check("lie in one plane", solids.tetrahedron, o, x, y, (1, 1, 0))
        self.check("angle: must be at most 2 pi", solids.cylinder_wedge, 1, 1, 361)
        self.check("seed: must be >= 0", solids.random, 2, -1)


if __name__ == "__main__":
    unittest.main()
