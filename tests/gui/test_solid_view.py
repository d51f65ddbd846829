"""How Bézier solids are drawn: read from pixels and from the scene."""

from unittest import mock

import FreeCADGui

from drawn_case import DrawnCase, nodes_of, show, triangles_of
from gui_case import DARK, LIGHT
from osculate import solids
from osculate.features import make_bezier_solid
from osculate.gui import colors
from osculate.gui.solid.look import MODES
from osculate.gui.solid.solid_node import SolidNode

NET = colors.SIDES[1]


class LookTest(DrawnCase):
    def setUp(self):
        super().setUp()
        self.obj = make_bezier_solid(self.doc, solids.ball_octant(50.0))
        self.vobj = self.obj.ViewObject
        self.look()

    def pixels(self, name, color=NET, spread=6):
        return self.count_pixels(self.image(name), color, spread)

    def test_is_seen_in_every_mode_on_light_and_dark(self):
        self.assertEqual(self.vobj.listDisplayModes(), list(MODES))
        self.vobj.ShowNet = False
        covered = []
        for mode, background, color in zip(MODES, (LIGHT, DARK, DARK, LIGHT),
                                           ("#ffffff", "#202428", "#202428", "#ffffff")):
            self.set_background(background)
            self.vobj.DisplayMode = mode
            image = self.image(f"solid_{mode.replace(' ', '_')}")
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
        drawn = []
        with mock.patch.object(SolidNode, "show", autospec=True,
                               side_effect=lambda *_: drawn.append(1)):
            self.reloaded(self.obj)
        self.assertEqual(len(drawn), 1)  # not once for each property
        obj = self.reloaded(self.doc.Objects[0])
        vobj = obj.ViewObject
        self.assertEqual((vobj.DisplayMode, vobj.Slices, vobj.SliceDirection, vobj.ShowSlices),
                         ("Wireframe", 7, "Corner 2", True))
        self.assertEqual(vobj.Deviation.Value, 0.25)
        self.look()
        self.assertLess(self.difference(self.image("solid_loaded"), before), 4)  # colours of 8 bits
