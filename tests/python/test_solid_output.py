"""What Bézier solids give to displays and to other programs: meshes, sections, Part.Solid, VTU."""
import importlib.util
import math
import tempfile
import unittest
from pathlib import Path

import numpy as np

import osculate
from osculate import solids
from support import needs_freecad

HAS_VTK = importlib.util.find_spec("vtkmodules") is not None


def volume_inside(points, triangles):
    a, b, c = (points[triangles[:, i]] for i in range(3))
    return np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6


class MeshTest(unittest.TestCase):
    def test_uniform(self):
        solid = solids.tetrahedron((0, 0, 0), (6, 0, 0), (0, 6, 0), (0, 0, 6))
        mesh = solid.mesh(3)
        self.assertEqual(mesh.points.shape, (20, 3))
        self.assertEqual(mesh.tetrahedra.shape, (27, 4))
        self.assertEqual(mesh.triangles.shape, (36, 3))
        self.assertAlmostEqual(volume_inside(mesh.points, mesh.triangles), 36)
        np.testing.assert_allclose(solid.evaluate(mesh.coordinates), mesh.points, atol=1e-14)

    def test_chordal(self):
        octant = solids.ball_octant(100)
        mesh = octant.mesh(chordal_mm=0.5)
        sphere = mesh.triangles[mesh.triangle_faces == 3]
        middles = mesh.points[sphere].mean(axis=1)
        self.assertLess((100 - np.linalg.norm(middles, axis=1)).max(), 0.5)
        self.assertAlmostEqual(volume_inside(mesh.points, mesh.triangles) / octant.volume(), 1, 2)

    def test_tessellation_has_normals(self):
        faces = solids.ball_octant(10).tessellate(0.01)
        self.assertEqual(len(faces), 4)
        np.testing.assert_allclose(faces[3].normals, faces[3].points / 10, atol=1e-12)
        self.assertLess(faces[3].triangles.max(), len(faces[3].points))

    def test_section(self):
        section = solids.cone(3, 6).slice((0, 0, 2), (0, 0, 1), 20)
        np.testing.assert_allclose(section.points[:, 2], 2, atol=1e-12)
        a, b, c = (section.points[section.triangles[:, i]] for i in range(3))
        self.assertAlmostEqual(np.cross(b - a, c - a)[:, 2].sum() / 2 / (4 * math.pi), 1, 1)


@needs_freecad
class PartTest(unittest.TestCase):
    def check(self, solid):
        shape = solid.to_solid()
        self.assertEqual(shape.ShapeType, "Solid")
        self.assertTrue(shape.isValid())
        self.assertTrue(shape.isClosed())
        # FreeCAD integrates over faces without bound of the error: 6e-7 at a collapsed edge
        self.assertAlmostEqual(shape.Volume / abs(solid.volume()), 1, 5)
        return shape

    def test_primitives_are_valid_solids(self):
        self.check(solids.tetrahedron((0, 0, 0), (6, 0, 0), (0, 6, 0), (0, 0, 6)))
        self.check(solids.cone(5, 12))
        self.check(solids.ball_octant(10))
        for solid in solids.frustum_wedge(8, 5, 10, 90):
            self.check(solid)

    def test_random_ones_too(self):
        for seed in (1, 2):
            self.check(solids.random(3, seed))

    def test_booleans(self):
        import FreeCAD
        import Part
        octant = self.check(solids.ball_octant(10))
        result = octant.cut(Part.makeBox(3, 3, 3, FreeCAD.Vector(1, 1, 1)))
        self.assertTrue(result.isValid())
        self.assertAlmostEqual(result.Volume, octant.Volume - 27, 3)

    def test_what_is_no_solid(self):
        points = solids.random(2, 1).points
        points[:, 2] = 0
        with self.assertRaisesRegex(ValueError, "has no volume"):
            osculate.BezierTetrahedron(2, points).to_solid()
        with self.assertRaisesRegex(ValueError, "project it from E4 first"):
            solids.random(2, 1, 4).to_solid()


class VtuTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = Path(folder.name) / "solid.vtu"

    def test_file_is_xml_with_all_solids(self):
        import xml.etree.ElementTree
        row = solids.frustum_wedge(3, 2, 5, 90)
        solids.write_vtu(row, self.path)
        piece = xml.etree.ElementTree.parse(self.path).getroot()[0][0]
        self.assertEqual(piece.attrib, {"NumberOfPoints": "60", "NumberOfCells": "3"})

    def test_bad_paths_and_solids(self):
        with self.assertRaisesRegex(ValueError, "path: cannot write"):
            solids.random(2, 1).write_vtu(self.path / "none" / "x.vtu")
        with self.assertRaisesRegex(ValueError, "project it from E4 first"):
            solids.random(2, 1, 4).write_vtu(self.path)
        self.assertFalse(self.path.exists())

    @unittest.skipUnless(HAS_VTK, "needs VTK (python3-vtk9)")
    def test_vtk_evaluates_to_the_same_points(self):
        from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
        u = np.random.default_rng(1).dirichlet((1, 1, 1, 1), 10)
        for solid in [solids.random(degree, 1) for degree in range(1, 9)] + [solids.ball_octant(5)]:
            solid.write_vtu(self.path)
            reader = vtkXMLUnstructuredGridReader()
            reader.SetFileName(str(self.path))
            reader.Update()
            cell = reader.GetOutput().GetCell(0)
            self.assertEqual(cell.GetClassName(), "vtkBezierTetra")
            self.assertEqual(cell.GetOrder(), solid.degree)
            for row, expected in zip(u, solid.evaluate(u)):
                found, weights = [0.0] * 3, [0.0] * len(solid.points)
                cell.EvaluateLocation(_reference(0), list(row[1:]), found, weights)
                np.testing.assert_allclose(found, expected, rtol=1e-12, atol=1e-12)


def _reference(value):
    from vtkmodules.vtkCommonCore import reference
    return reference(value)


if __name__ == "__main__":
    unittest.main()
