"""The triangles and lines that FreeCAD's 3D view shows of a Bézier solid."""
import unittest

import numpy as np

import osculate
from osculate import solids
from support import needs_freecad


@needs_freecad
class MeshTest(unittest.TestCase):
    def setUp(self):
        from osculate.gui.solid import meshes
        self.meshes = meshes
        self.solid = solids.random(3, 1)

    def test_faces_are_meshed_on_the_lattice_that_values_are_computed_on(self):
        faces = self.meshes.faces_of(self.solid, 0.5, with_jacobian=True)
        lattice = self.meshes.lattice(faces.divisions)
        for face, surface in enumerate(faces.surfaces):
            u = np.zeros((len(lattice), 4))
            u[:, [corner for corner in range(4) if corner != face]] = lattice
            np.testing.assert_allclose(surface.points, self.solid.evaluate(u), atol=1e-11)
            np.testing.assert_allclose(surface.values, self.solid.jacobian(u), rtol=1e-9)

    def test_triangles_of_a_lattice_cover_it_once(self):
        lattice, triangles = self.meshes.lattice(7), self.meshes.lattice_triangles(7)
        corners = lattice[triangles][:, :, :2]
        areas = np.linalg.det(corners[:, 1:] - corners[:, :1])
        np.testing.assert_allclose(areas, areas[0])
        self.assertEqual(len(triangles), 49)
        self.assertAlmostEqual(abs(areas.sum()), 1.0)
        self.assertEqual(len(self.meshes.rim_of(triangles)), 3 * 7)

    def test_interpolation_on_a_finer_lattice_is_exact_for_linear_functions(self):
        for coarse, fine in ((5, 13), (32, 57), (1, 4)):
            values = [self.meshes.lattice(m) @ (1.0, -2.0, 5.0) for m in (coarse, fine)]
            np.testing.assert_allclose(self.meshes.interpolated(values[0], coarse, fine),
                                       values[1], atol=1e-13)

    def test_interpolated_jacobians_of_a_fine_mesh_are_near(self):
        faces = self.meshes.faces_of(self.solid, 0.02, with_jacobian=True)
        self.assertGreater(faces.divisions, 64)
        u = np.zeros((len(self.meshes.lattice(faces.divisions)), 4))
        u[:, 1:] = self.meshes.lattice(faces.divisions)
        exact = self.solid.jacobian(u)
        self.assertLess(abs(faces.surfaces[0].values - exact).max(), 0.03 * abs(exact).max())

    def test_a_corner_slice_is_the_iso_surface(self):
        slice_ = self.meshes.corner_slice(self.solid, 2, 0.3, 6)
        surface = self.solid.iso_surface(2, 0.3)
        for point, u in zip(slice_.points, self.meshes.lattice(6)):
            np.testing.assert_allclose(point, surface.evaluate(u), atol=1e-11)
        np.testing.assert_allclose(np.linalg.norm(slice_.normals, axis=1), 1.0)

    def test_a_plane_slice_lies_in_its_plane(self):
        low, high = self.meshes.extent(self.solid, 2)
        slice_ = self.meshes.plane_slice(self.solid, 2, (low + high) / 2.0, 16, True)
        np.testing.assert_allclose(slice_.points[:, 2], (low + high) / 2.0, atol=1e-10)
        np.testing.assert_allclose(abs(slice_.normals[:, 2]), 1.0)
        self.assertEqual(len(slice_.values), len(slice_.points))

    def test_edges_end_at_the_corners(self):
        corners = self.solid.evaluate(np.eye(4))
        ends = {tuple(np.round(line[end], 9)) for line in self.meshes.edges_of(self.solid, 5)
                for end in (0, -1)}
        self.assertEqual(ends, {tuple(np.round(corner, 9)) for corner in corners})

    def test_weights_that_differ_wildly_cost_no_more(self):
        points, weights = self.solid.points, self.solid.weights
        weights[0] = 1e-12
        faces = self.meshes.faces_of(osculate.BezierTetrahedron(3, points, weights), 0.001)
        self.assertLessEqual(faces.divisions, 200)
        weights[0] = 0.0
        faces = self.meshes.faces_of(osculate.BezierTetrahedron(3, points, weights), 0.001, True)
        self.assertTrue(all(np.isfinite(surface.points).all() and np.isfinite(surface.values).all()
                            for surface in faces.surfaces))

    def test_a_single_point_has_no_faces(self):
        point = osculate.BezierTetrahedron(1, np.ones((4, 3)))
        self.assertEqual(self.meshes.bound_for(point, 0.0), 0.0)
        self.assertEqual(self.meshes.faces_of(point, 0.0).surfaces, ())


@needs_freecad
class ColorTest(unittest.TestCase):
    def test_both_signs_are_far_apart_at_0_and_rounding_has_none(self):
        from osculate.gui.solid.jacobian_colors import colors_of, places_of
        values = [-1e-6, -1e-12, 0.0, 1e-6]
        colors, places = colors_of(values, 1.0), places_of(values, 1.0)[:, 0]
        self.assertGreater(abs(colors[0] - colors[1]).max(), 0.5)
        self.assertLess(abs(colors[1] - colors[3]).max(), 1e-3)
        self.assertLess(places[0], 0.5)
        self.assertTrue((places[1:] > 0.5).all())
        self.assertTrue((places_of([0.0, 0.0], 0.0)[:, 0] > 0.5).all())


if __name__ == "__main__":
    unittest.main()
