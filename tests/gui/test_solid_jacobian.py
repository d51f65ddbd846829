"""The colours of the Jacobian, and nets that are no whole solids, in the 3D view."""

import numpy

import osculate
from drawn_case import DrawnCase, folded, nodes_of, show, triangles_of
from osculate import solids
from osculate.features import make_bezier_solid
from osculate.gui.qt import QtGui
from osculate.gui.solid.look import MODES

RIM = "#7c8794"  # of a legend


class JacobianTest(DrawnCase):
    def setUp(self):
        super().setUp()
        self.obj = make_bezier_solid(self.doc, folded())
        self.obj.ViewObject.ShowNet = False
        self.look()

    def orange(self, name):
        """Pixels that are redder than blue as NEGATIVE is, whatever the light."""
        image = self.image(name)
        return sum(image.pixelColor(x, y).red() > image.pixelColor(x, y).blue() + 40
                   for x in range(0, 900, 4) for y in range(0, 600, 4))

    def test_a_fold_stands_out(self):
        self.assertEqual(self.orange("fold_plain"), 0)
        self.obj.ViewObject.ColorByJacobian = True
        self.assertGreater(self.orange("fold"), 200)
        self.obj.ViewObject.ShowSlices = True
        self.assertGreater(self.orange("fold_slices"), 100)
        show(self.obj, solids.random(3, 1))
        self.assertEqual(self.orange("fold_mended"), 0)

    def test_colours_are_those_of_the_jacobian_at_each_point(self):
        value = solids.random(3, 1)
        show(self.obj, value)
        self.obj.ViewObject.DisplayMode = "Shaded"
        self.obj.ViewObject.ColorByJacobian = True
        (points,), (places,) = (nodes_of(self.obj, kind)
                                for kind in ("Coordinate3", "TextureCoordinate2"))
        points, places = (field.getValues() for field in (points.point, places.point))
        largest = max(value.jacobian(numpy.eye(4)))  # of this one
        for point, place in list(zip(points, places))[::300]:
            (u, *_) = value.locate(point.getValue(), 1e-3)
            self.assertAlmostEqual(2.0 * place[0] - 1.0,
                                   value.jacobian([u])[0] / largest, delta=0.03)

    def test_legends_stand_side_by_side_and_close_up(self):
        other = make_bezier_solid(self.doc, solids.random(3, 2))
        self.obj.ViewObject.ColorByJacobian = True
        first = self.legends_end("legend")
        other.ViewObject.ColorByJacobian = True
        both = self.legends_end("legends")
        self.assertGreater(both, first + 60)
        self.doc.removeObject(self.obj.Name)
        self.assertLess(self.legends_end("legend_alone"), both - 60)
        other.ViewObject.Visibility = False
        self.assertEqual(self.legends_end("legend_gone"), 0)

    def legends_end(self, name):
        """The last column of the picture in which a long upright line has the rim's colour."""
        image = self.image(name)
        rim = QtGui.QColor(RIM)
        columns = [0]
        for x in range(image.width()):
            colors = (image.pixelColor(x, y) for y in range(10, 200))
            count = sum(abs(color.red() - rim.red()) < 40 and abs(color.blue() - rim.blue()) < 40
                        for color in colors)
            if count > 150:
                columns.append(x)
        return columns[-1]


class OddNetsTest(DrawnCase):
    def test_nets_that_are_no_whole_solids_are_drawn_as_far_as_they_go(self):
        value = solids.random(3, 1)
        points, weights = value.points, value.weights
        corner = weights.copy()
        corner[0] = 0.0
        face = [0.0 if index[3] == 0 else 1.0 for index in value.indices]
        obj = make_bezier_solid(self.doc, value)
        vobj = obj.ViewObject
        vobj.Slices, vobj.ShowIndices = 2, True
        for name, net in (("flat", (points * [1, 1, 0], weights)),
                          ("point", (0.0 * points, weights)), ("corner", (points, corner)),
                          ("face", (points, face)), ("far", (points + 1e7, weights))):
            show(obj, osculate.BezierTetrahedron(3, *net))
            for vobj.ColorByJacobian in (True, False):
                vobj.ShowSlices = vobj.ColorByJacobian
            for vobj.DisplayMode in (MODES[2], MODES[0]):
                self.look()
            self.image(f"odd_{name}")
            self.assertEqual(self.report_view().toPlainText(), "", name)

    def test_four_dimensions_are_projected_along_the_last(self):
        value = solids.random(3, 1)
        obj = make_bezier_solid(self.doc, value)
        self.look()
        flat = self.image("solid_e3")
        show(obj, value.embedded())
        self.assertEqual(len(obj.FourthCoordinates), 20)
        self.assertEqual(self.image("solid_e4"), flat)

    def test_half_set_properties_keep_what_was_drawn(self):
        obj = make_bezier_solid(self.doc, solids.random(3, 1))
        count = triangles_of(obj)
        obj.Points = obj.Points[:7]
        self.assertEqual(triangles_of(obj), count)
