"""The dock Curve plot: what is selected is drawn."""

from unittest import mock

import FreeCADGui

import samples
from gui_case import DARK
from osculate.gui import colors
from osculate.gui.plot.plot_dock import PlotDock, show_dock
from osculate.gui.plot.plot_source import MOST_EDGES
from osculate.gui.qt import Qt
from plot_case import PlotCase


class DrawnTest(PlotCase):
    def test_a_sketch_with_its_joins(self):
        sketch = samples.profile(self.doc)
        self.fit()
        plot = self.plot((sketch, ""))
        self.assertEqual([join.label for join in plot.joins],
                         ["G1", "G1", "G0", "G4", "G4", "gap"])
        self.assertEqual(self.dock.source.labels[3], "Profile.Edge4")
        self.screenshot("plot_light")
        picture = self.canvas.grab().toImage()
        for color in (*(colors.QUANTITIES[name] for name in self.tools.quantities()
                        if name != "torsion"), colors.of_order(1), colors.GAP):
            self.assertGreater(self.count_pixels(picture, color), 50, color)

    def test_dark(self):
        sketch = samples.profile(self.doc)
        self.fit()
        window = FreeCADGui.getMainWindow()
        window.setStyleSheet("QWidget { background: #2b2b2b; color: #e0e0e0 }")
        self.addCleanup(window.setStyleSheet, "")
        self.set_background(DARK)
        self.plot((sketch, ""))
        self.move_to(60.0)
        self.screenshot("plot_dark")
        picture = self.canvas.grab().toImage()
        self.assertLess(self.count_pixels(picture, "#ffffff"), 3000)
        self.assertGreater(self.count_pixels(picture, colors.QUANTITIES["curvature"]), 50)

    def test_check_boxes_choose_the_quantities_and_are_remembered(self):
        line, arc = samples.line_and_arc(self.doc)
        self.plot((line, "Edge1"), (arc, "Edge1"))
        self.click(self.tools.boxes["curvature_rate2"])
        self.click(self.tools.boxes["torsion_rate"])
        wanted = ("curvature", "torsion", "curvature_rate", "torsion_rate")
        self.assertEqual(tuple(self.canvas.drawing.axes), wanted)
        for quantity in wanted[1:]:
            self.click(self.tools.boxes[quantity])
        self.assertEqual(tuple(self.canvas.drawing.axes), ("curvature",))
        self.click(self.tools.boxes["curvature"])  # one is left at least
        self.assertTrue(self.tools.boxes["curvature"].isChecked())
        self.screenshot("plot_one")
        other = PlotDock(FreeCADGui.getMainWindow())
        self.addCleanup(other.deleteLater)
        self.assertEqual(other.form.quantities(), ("curvature",))

    def test_beside_the_view_it_is_narrow(self):
        sketch = samples.profile(self.doc)
        window = FreeCADGui.getMainWindow()
        window.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, self.dock)
        self.addCleanup(window.addDockWidget, Qt.DockWidgetArea.BottomDockWidgetArea, self.dock)
        self.plot((sketch, ""))
        window.resizeDocks([self.dock], [360], Qt.Orientation.Horizontal)
        self.pump()
        self.screenshot("plot_narrow")
        self.assertLess(self.dock.width(), 480)


class SelectionTest(PlotCase):
    def test_asks_for_a_selection_and_follows_it(self):
        line, arc = samples.line_and_arc(self.doc)
        FreeCADGui.Selection.clearSelection()
        show_dock()
        self.pump()
        self.assertIn("Select edges", self.tools.advice.text())
        self.assertFalse(self.tools.save.isEnabled())
        self.select((line, "Edge1"))
        self.wait_for(lambda: self.dock.source.plot is not None, "the plot")
        self.assertAlmostEqual(self.dock.source.plot.length, 50.0, delta=1e-9)
        self.select((arc, "Edge1"), (line, "Edge1"))
        self.wait_for(lambda: len(self.dock.source.plot.curves) == 2, "the plot of both")
        self.assertAlmostEqual(self.dock.source.plot.length, 81.415926535, delta=1e-6)
        self.click(self.tools.follow)
        self.select((line, "Edge1"))
        self.assertEqual(len(self.dock.source.plot.curves), 2)
        self.click(self.tools.follow)
        self.assertEqual(len(self.dock.source.plot.curves), 1)

    def test_what_cannot_be_plotted_is_said(self):
        line, _ = samples.line_and_arc(self.doc)
        self.plot((line, "Edge1"))
        self.select((line, "Vertex1"))
        self.wait_for(lambda: self.tools.advice.text(), "the advice")
        self.assertIn("Select edges", self.tools.advice.text())
        self.assertIsNotNone(self.dock.source.plot)  # the old one stays

    def test_an_edge_that_is_selected_twice_is_plotted_once(self):
        line, arc = samples.line_and_arc(self.doc)
        plot = self.plot((line, "Edge1"), (line, ""), (arc, ""))
        self.assertEqual(len(plot.curves), 2)

    def test_placement_of_a_part_around_counts(self):
        line, _ = samples.line_and_arc(self.doc)
        part = self.doc.addObject("App::Part", "Part")
        part.addObject(line)
        part.Placement.Base.z = 7.0
        self.doc.recompute()
        plot = self.plot((part, "Line.Edge1"))
        self.assertEqual(plot.comb.point[:, 2].tolist(), [7.0] * len(plot.s))
        self.assertEqual(self.dock.source.labels, ("Line.Edge1",))

    def test_what_has_no_curve_is_left_out_and_said(self):
        line, _ = samples.line_and_arc(self.doc)
        endless = samples.add_edge(self.doc, "Endless", samples.Part.Line())
        plot = self.plot((endless, ""), (line, ""))
        self.assertEqual(len(plot.curves), 1)
        self.assertIn("Endless.Edge1: ", self.tools.trouble.text())

    def test_of_very_many_edges_the_first_are_plotted(self):
        lines = [samples.Part.LineSegment(samples.V(3 * i, 0, 0), samples.V(3 * i + 2, 0, 0))
                 for i in range(MOST_EDGES + 20)]
        obj = self.doc.addObject("Part::Feature", "Many")
        obj.Shape = samples.Part.Compound([line.toShape() for line in lines])
        plot = self.plot((obj, ""))
        self.assertEqual(len(plot.curves), MOST_EDGES)
        self.assertIn(f"Only {MOST_EDGES} of {MOST_EDGES + 20}", self.tools.trouble.text())
        self.screenshot("plot_many")

    def test_is_possible_while_a_task_is_open(self):
        line, arc = samples.line_and_arc(self.doc)
        self.analyze((line, "Edge1"), (arc, "Edge1"))
        self.assertTrue(FreeCADGui.Command.get("Osculate_CurvePlot").isActive())

    def test_without_matplotlib_it_says_so(self):
        line, _ = samples.line_and_arc(self.doc)
        dock = PlotDock(FreeCADGui.getMainWindow())
        self.addCleanup(dock.deleteLater)
        self.addCleanup(dock.close)
        self.select((line, "Edge1"))
        hidden = {"osculate.gui.plot.plot_canvas": None}
        with mock.patch.dict("sys.modules", hidden):
            FreeCADGui.getMainWindow().addDockWidget(Qt.DockWidgetArea.BottomDockWidgetArea, dock)
            dock.show()
            self.pump()
        self.assertIn("plot_canvas", dock.form.trouble.text())
        self.assertTrue(dock.form.trouble.isVisible())
