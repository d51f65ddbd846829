"""How Bézier solids are drawn: read from pixels and from the scene."""

import FreeCADGui
from pivy import coin

import osculate
from gui_case import DARK, LIGHT
from osculate import solids
from osculate.gui import colors
from osculate.gui.solid.jacobian_colors import NEGATIVE
from osculate.gui.solid.look import MODES
from drawn_case import DrawnCase, add_solid, folded, show

NET = colors.SIDES[1]
FACE = "#ff2222"


def nodes_of(obj, kind):
    """The nodes of a Coin class that are drawn of an object."""
    search = coin.SoSearchAction()
    search.setType(coin.SoType.fromName(kind))
    search.setInterest(coin.SoSearchAction.ALL)
    search.apply(obj.ViewObject.RootNode)
    paths = search.getPaths()
    return [paths[i].getTail() for i in range(paths.getLength())]


def triangles_of(obj):
    """The number of triangles in the scene."""
    return sum(node.coordIndex.getNum() // 4 for node in nodes_of(obj, "IndexedFaceSet"))


class LookTest(DrawnCase):
    def setUp(self):
        super().setUp()
        self.obj = add_solid(self.doc, solids.ball_octant(50.0))
        self.vobj = self.obj.ViewObject
        self.look()

    def pixels(self, name, color=NET, spread=6):
        return self.count_pixels(self.image(name), color, spread)

    def test_is_seen_in_every_mode_on_light_and_dark(self):
        self.assertEqual(self.vobj.listDisplayModes(), list(MODES))
        self.vobj.ShowNet = False
        for name, background in (("light", LIGHT), ("dark", DARK)):
            self.set_background(background)
            color = "#ffffff" if background == LIGHT else "#202428"
            covered = []
            for mode in MODES:
                self.vobj.DisplayMode = mode
                image = self.image(f"solid_{mode.replace(' ', '_')}_{name}")
                covered.append(900 * 600 - self.count_pixels(image, color))
            with_edges, shaded, wires, net = covered
            self.assertGreater(min(shaded, with_edges), 40000)
            self.assertGreater(wires, 2000)
            self.assertGreater(net, 2000)
            self.assertLess(max(wires, net), 0.5 * shaded)

    def test_faces_are_smooth_and_lit_from_outside(self):
        """The normals of a ball are its radii."""
        self.vobj.DisplayMode = "Shaded"
        self.vobj.ShowNet = False
        (normals,), (points,) = (nodes_of(self.obj, kind) for kind in ("Normal", "Coordinate3"))
        round_ones = 0
        for normal, point in zip(normals.vector.getValues(), points.point.getValues()):
            if abs(point.length() - 50.0) < 1e-4 and min(point.getValue()) > 1.0:
                self.assertGreater(normal.dot(point), 50.0 - 1e-3)
                round_ones += 1
        self.assertGreater(round_ones, 100)

    def test_deviation_decides_how_fine_the_mesh_is(self):
        counts = []
        for deviation in (1.0, 0.0, 0.01):
            self.vobj.Deviation = deviation
            counts.append(triangles_of(self.obj))
        self.assertEqual(counts, sorted(counts))
        self.assertGreater(counts[2], 3 * counts[1])

    def test_a_senseless_deviation_does_not_fill_the_memory(self):
        self.vobj.Deviation = 1e-9
        self.assertLess(triangles_of(self.obj), 4 * 200 ** 2)

    def test_colours_and_transparency(self):
        self.vobj.ShowNet = False
        self.vobj.DisplayMode = "Shaded"
        self.vobj.ShapeColor = (1.0, 0.0, 0.0)
        image = self.image("solid_red")
        red = sum(image.pixelColor(x, 300).red() > image.pixelColor(x, 300).green() + 60
                  for x in range(900))
        self.assertGreater(red, 150)
        self.vobj.Transparency = 60
        self.assertNotEqual(self.image("solid_red_clear"), image)
        self.vobj.DisplayMode = "Shaded with edges"
        self.vobj.LineColor = (0.0, 1.0, 0.0)
        self.vobj.LineWidth = 4.0
        self.assertGreater(self.pixels("solid_green_edges", "#00ff00"), 400)

    def test_points_keep_their_size_on_the_screen(self):
        self.vobj.DisplayMode = "Net only"
        self.vobj.PointSize = 20.0
        near = self.pixels("net_near")
        self.vobj.PointSize = 5.0
        self.assertGreater(near, self.pixels("net_small") + 10 * 200)
        self.vobj.PointSize = 20.0
        height = self.view().getCameraNode().height
        height.setValue(3.0 * height.getValue())
        self.assertGreater(self.pixels("net_far"), 10 * 200)

    def test_labels_on_demand(self):
        self.assertEqual(nodes_of(self.obj, "SoImage"), [])
        self.vobj.ShowIndices = True
        self.vobj.ShowWeights = True
        self.image("solid_labels")
        # the 20 points at the centre of the ball have one label
        self.assertEqual(len(nodes_of(self.obj, "SoImage")), 35 - 19)
        self.vobj.ShowIndices = self.vobj.ShowWeights = False
        self.assertEqual(nodes_of(self.obj, "SoImage"), [])

    def test_what_is_not_shown_is_not_there(self):
        self.vobj.ShowNet = False
        self.vobj.DisplayMode = "Shaded"
        self.assertEqual(len(nodes_of(self.obj, "IndexedFaceSet")), 1)
        self.assertEqual(nodes_of(self.obj, "IndexedLineSet"), [])
        self.assertEqual(nodes_of(self.obj, "SoMarkerSet"), [])
        self.vobj.DisplayMode = "Net only"
        self.assertEqual(nodes_of(self.obj, "IndexedFaceSet"), [])

    def test_slices_show_the_inside(self):
        for direction in ("Z", "Corner 0"):
            self.vobj.SliceDirection = direction
            self.vobj.Slices = 4
            self.vobj.ShowSlices = True
            self.assertEqual(len(nodes_of(self.obj, "IndexedFaceSet")), 5)
            self.image(f"solid_slices_{direction.replace(' ', '_')}")
        self.vobj.ShowSlices = False
        self.assertEqual(len(nodes_of(self.obj, "IndexedFaceSet")), 1)

    def test_a_click_selects_it_and_it_is_seen(self):
        plain = self.image("solid_plain")
        FreeCADGui.Selection.clearSelection()
        self.click_at(self.obj.Points[4] * 0.6)
        self.wait_for(lambda: FreeCADGui.Selection.getSelection(), "the selection")
        self.assertEqual(FreeCADGui.Selection.getSelection(), [self.obj])
        green = self.image("solid_selected")
        count = sum(green.pixelColor(x, 300).green() > plain.pixelColor(x, 300).green() + 20
                    for x in range(900))
        self.assertGreater(count, 100)
        self.clear_selection()

    def test_fits_into_the_view_with_its_net(self):
        height = self.view().getCameraNode().height.getValue()
        self.assertLess(height, 200.0)
        self.assertGreater(height, 60.0)
        self.vobj.ShowIndices = True
        self.look()
        self.assertAlmostEqual(self.view().getCameraNode().height.getValue(), height, delta=0.5)

    def test_goes_when_the_object_goes(self):
        self.doc.removeObject(self.obj.Name)
        self.pump()
        self.assertEqual(self.pixels("solid_gone", "#ffffff"), 900 * 600)

    def test_follows_its_net(self):
        show(self.obj, solids.cone(10.0, 30.0))
        self.look()
        self.assertGreater(self.pixels("solid_cone"), 400)
        self.assertEqual(len(nodes_of(self.obj, "SoMarkerSet")), 1)

    def test_properties_are_kept_in_a_file(self):
        self.vobj.DisplayMode = "Wireframe"
        self.vobj.NetColor = (0.0, 1.0, 1.0)
        self.vobj.Slices, self.vobj.SliceDirection, self.vobj.ShowSlices = 7, "Corner 2", True
        self.vobj.Deviation = 0.25
        before = self.image("solid_saved")
        obj = self.reloaded(self.obj)
        vobj = obj.ViewObject
        self.assertEqual((vobj.DisplayMode, vobj.Slices, vobj.SliceDirection, vobj.ShowSlices),
                         ("Wireframe", 7, "Corner 2", True))
        self.assertEqual(vobj.Deviation.Value, 0.25)
        self.look()
        self.assertEqual(self.image("solid_loaded"), before)


class JacobianTest(DrawnCase):
    def setUp(self):
        super().setUp()
        self.obj = add_solid(self.doc, folded())
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

    def test_colours_are_those_of_the_jacobian(self):
        self.obj.ViewObject.ColorByJacobian = True
        material = max(nodes_of(self.obj, "Material"), key=lambda node: node.diffuseColor.getNum())
        first = material.diffuseColor[0].getValue()
        jacobian = osculate.BezierTetrahedron(3, folded().points, folded().weights).jacobian(
            [[0, 1, 0, 0]])[0]
        self.assertEqual(jacobian < 0.0, first[0] > first[2])
        self.assertEqual(len(NEGATIVE), 2)


class OddNetsTest(DrawnCase):
    def test_nets_that_are_no_whole_solids_are_drawn_as_far_as_they_go(self):
        value = solids.random(3, 1)
        points, weights = value.points, value.weights
        corner = weights.copy()
        corner[0] = 0.0
        face = [0.0 if index[3] == 0 else 1.0 for index in value.indices]
        obj = add_solid(self.doc, value)
        vobj = obj.ViewObject
        vobj.ColorByJacobian = vobj.ShowSlices = vobj.ShowIndices = True
        for name, net in (("flat", (points * [1, 1, 0], weights)),
                          ("point", (0.0 * points, weights)), ("corner", (points, corner)),
                          ("face", (points, face)), ("far", (points + 1e7, weights))):
            show(obj, osculate.BezierTetrahedron(3, *net))
            for mode in MODES:
                vobj.DisplayMode = mode
            self.look()
            self.image(f"odd_{name}")
            self.assertEqual(self.report_view().toPlainText(), "", name)

    def test_four_dimensions_are_projected_along_the_last(self):
        value = solids.random(3, 1)
        obj = add_solid(self.doc, value)
        self.look()
        flat = self.image("solid_e3")
        show(obj, value.embedded())
        self.assertEqual(len(obj.FourthCoordinates), 20)
        self.assertEqual(self.image("solid_e4"), flat)

    def test_half_set_properties_keep_what_was_drawn(self):
        obj = add_solid(self.doc, solids.random(3, 1))
        count = triangles_of(obj)
        obj.Points = obj.Points[:7]
        self.assertEqual(triangles_of(obj), count)
