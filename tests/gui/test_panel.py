"""The command and its panel, used with mouse and keyboard."""

import csv
import json
import os
import tempfile

import FreeCADGui

import samples
from gui_case import GuiCase, QTest
from osculate.gui.panel.join_panel import JoinPanel
from osculate.gui.panel.message import Message
from osculate.gui.qt import Qt, QtWidgets


class CommandTest(GuiCase):
    def test_is_in_toolbar_and_menu(self):
        window = FreeCADGui.getMainWindow()
        toolbar = window.findChild(QtWidgets.QToolBar, "Osculate")
        self.assertIn("Analyze join", [action.text() for action in toolbar.actions()])
        menus = [action.text() for action in window.menuBar().actions()]
        self.assertIn("&Osculate", menus)

    def test_is_inactive_while_its_panel_is_open(self):
        action = FreeCADGui.Command.get("Osculate_AnalyzeJoin")
        self.assertTrue(action.isActive())
        self.run_command()
        self.assertFalse(action.isActive())

    def test_picks_edges_in_the_3d_view(self):
        line, arc = samples.line_and_arc(self.doc)
        self.fit()
        form = self.run_command()
        self.assertFalse(form.banner.isVisible())
        self.click_at(line.Shape.Edges[0].valueAt(25.0))
        self.wait_for(lambda: FreeCADGui.Selection.getSelectionEx(), "a selection")
        self.click_at(arc.Shape.Edges[0].valueAt(-0.4), Qt.KeyboardModifier.ControlModifier)
        self.wait_for(form.banner.isVisible, "the verdict")
        self.assertIn("<b>G1</b>, misses G2 by 100 %", form.banner.text.text())
        self.screenshot("picked_in_3d")


class SelectionTest(GuiCase):
    def test_nothing_selected_says_what_to_select(self):
        form = self.run_command()
        self.assertTrue(form.advice.isVisible())
        self.assertIn("two edges", form.advice.text())
        self.assertFalse(form.orders.isVisible())

    def test_face_is_refused_with_its_name(self):
        self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        form = self.analyze((self.doc.Box, "Face1"))
        self.assertIn("Box.Face1 is no edge", form.advice.text())
        self.assertIn("two edges", form.advice.text())

    def test_object_without_edges_is_refused(self):
        self.doc.addObject("Spreadsheet::Sheet", "Sheet")
        self.doc.addObject("Part::Vertex", "Point")
        self.doc.recompute()
        form = self.analyze((self.doc.Point, ""))
        self.assertIn("Point has no edges", form.advice.text())
        self.select((self.doc.Sheet, ""))
        self.assertIn("Sheet has no edges", form.advice.text())

    def test_two_objects_of_one_edge_each(self):
        line, arc = samples.line_and_arc(self.doc)
        form = self.analyze((line, ""), (arc, ""))
        self.assertIn("<b>G1</b>", form.banner.text.text())

    def test_vertex_of_a_sketch_stands_for_its_edges(self):
        sketch = samples.profile(self.doc)
        number = next(number for number, vertex in enumerate(sketch.Shape.Vertexes, start=1)
                      if vertex.Point.isEqual(samples.V(50, 0, 0), 1e-6))
        form = self.analyze((sketch, f"Vertex{number}"))
        self.assertIn("<b>G1</b>", form.banner.text.text())
        self.assertEqual([side.name.toolTip() for side in form.edges.sides],
                         ["Profile.Edge1", "Profile.Edge2"])

    def test_one_edge_shows_its_knots(self):
        sketch = samples.profile(self.doc)
        form = self.analyze((sketch, "Edge4"))
        self.assertEqual([place.label() for place, _ in form.joins.model.joins],
                         ["Profile.Edge4, knot 1", "Profile.Edge4, knot 2"])

    def test_edge_of_one_segment_asks_for_another(self):
        line, _ = samples.line_and_arc(self.doc)
        form = self.analyze((line, "Edge1"))
        self.assertIn("Line.Edge1 has no inner joins", form.advice.text())

    def test_closed_edge_shows_its_closing_join(self):
        circle = self.doc.addObject("Part::Circle", "Circle")
        self.doc.recompute()
        form = self.analyze((circle, "Edge1"))
        self.assertEqual(form.joins.model.joins[-1][0].label(), "Circle.Edge1, closing")
        self.assertIn("<b>G4</b>", form.banner.text.text())

    def test_placement_of_a_part_counts(self):
        line, arc = samples.line_and_arc(self.doc)
        part = self.doc.addObject("App::Part", "Part")
        part.addObject(arc)
        part.Placement.Base.z = 3.0
        self.doc.recompute()
        form = self.analyze((line, "Edge1"), (part, "Arc.Edge1"))
        self.assertIn("3 mm", form.banner.text.text())

    def test_follows_the_selection_only_if_told(self):
        line, arc = samples.line_and_arc(self.doc)
        first, second = samples.cut_curve(self.doc)
        form = self.analyze((line, "Edge1"), (arc, "Edge1"))
        self.click(form.follow)
        self.select((first, "Edge1"), (second, "Edge1"))
        self.assertIn("<b>G1</b>", form.banner.text.text())
        self.click(form.follow)
        self.assertIn("<b>G4</b>", form.banner.text.text())


class PairTest(GuiCase):
    def setUp(self):
        super().setUp()
        self.line, self.arc = samples.line_and_arc(self.doc)
        self.form_ = self.analyze((self.line, "Edge1"), (self.arc, "Edge1"))

    def test_table_of_orders_reads_without_colour(self):
        text = self.form_.orders.text()
        self.assertEqual(text.count("✓&nbsp;pass"), 2)
        self.assertEqual(text.count("✗&nbsp;fail"), 3)
        self.assertIn("0.001 mm", text)

    def test_both_sides(self):
        text = self.form_.sides.text()
        self.assertIn("curvature", text)
        self.assertIn("0.05", text)
        self.assertIn(">20<", text)

    def test_definitions_unfold(self):
        section = next(part for part in self.form_.sections
                       if part.content is self.form_.definitions)
        self.assertFalse(self.form_.definitions.isVisible())
        self.click(section.header)
        self.assertTrue(self.form_.definitions.isVisible())
        self.assertIn("CATIA V5", self.form_.definitions.text())

    def test_ends_can_be_flipped_and_found_again(self):
        edges = self.form_.edges
        self.assertTrue(edges.nearest.isChecked())
        self.click(edges.sides[1].end_button)
        self.assertFalse(edges.nearest.isChecked())
        self.assertIn("28.3 mm", self.form_.orders.text())
        self.click(edges.nearest)
        self.assertIn("<b>G1</b>", self.form_.banner.text.text())

    def test_swap_travels_the_other_way(self):
        self.click(self.form_.edges.swap)
        self.assertEqual([side.name.toolTip() for side in self.form_.edges.sides],
                         ["Arc.Edge1", "Line.Edge1"])
        self.assertEqual([side.end_button.text().split()[0] for side in self.form_.edges.sides],
                         ["start", "end"])
        self.assertIn("<b>G1</b>", self.form_.banner.text.text())

    def test_preset_and_own_values(self):
        box = self.form_.tolerances
        box.preset.setCurrentText("catia-v5")
        self.assertEqual(box.values[1].value(), 0.01)
        self.assertIn("CATIA", box.source.text())
        self.type_number(box.values[2], "150")
        self.assertEqual(box.preset.currentText(), "custom")
        self.assertIn("150 %", self.form_.orders.text())
        self.assertIn("<b>G2</b>", self.form_.banner.text.text())

    def test_spin_box_steps_by_1_2_5(self):
        box = self.form_.tolerances.values[0]
        box.stepBy(1)
        self.assertAlmostEqual(box.value(), 0.002)
        box.stepBy(-2)
        self.assertAlmostEqual(box.value(), 0.0005)

    def test_order_asked_for(self):
        self.form_.tolerances.order.setValue(1)
        self.pump()
        self.assertNotIn("G2", self.form_.orders.text())
        self.assertIn("all orders asked for pass", self.form_.banner.text.text())

    def test_copy_as_text_json_and_csv(self):
        clipboard = QtWidgets.QApplication.clipboard()
        self.click(self.form_.actions.copy)
        self.assertIn("misses G2", clipboard.text())
        text, as_json, as_csv = self.form_.actions.copy.menu().actions()
        as_json.trigger()
        self.assertEqual(json.loads(clipboard.text())[0]["schema"], "osculate.join/1")
        as_csv.trigger()
        rows = list(csv.DictReader(clipboard.text().splitlines()))
        self.assertEqual((rows[0]["label"], rows[0]["order"]), ("Line.Edge1 – Arc.Edge1", "1"))

    def test_save(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "joins.json")
            self.save_as(path)
            with open(path, encoding="utf-8") as file:
                self.assertEqual(json.load(file)[0]["order"], 1)
            self.assertIn("Saved", self.form_.advice.text())

    def test_saving_where_it_cannot_be_done_is_said(self):
        self.save_as("/nowhere/joins.csv")
        self.assertIn("/nowhere", self.form_.advice.text())
        self.save_as("/nowhere/joins.txt")
        self.assertIn(".csv or .json", self.form_.advice.text())

    def save_as(self, path):
        asked, JoinPanel.ask_path = JoinPanel.ask_path, lambda panel: path
        try:
            self.click(self.form_.actions.save)
        finally:
            JoinPanel.ask_path = asked


class UndecidedTest(GuiCase):
    def test_is_said_in_panel_and_list(self):
        first, second = samples.cut_curve(self.doc, scale=1e-3, offset=1e4)
        form = self.analyze((first, "Edge1"), (second, "Edge1"))
        self.assertIn("<b>G4</b>", form.banner.text.text())
        form.tolerances.preset.setCurrentText("exact")
        self.pump()
        self.assertIn("<b>G1</b>, G2 undecided", form.banner.text.text())
        self.assertIn("?&nbsp;undecided", form.orders.text())
        self.assertIn("&lt; ", form.orders.text())
        self.assertIn("coordinates", form.warnings.text())
        self.fit()
        self.screenshot("undecided")


class ListTest(GuiCase):
    def setUp(self):
        super().setUp()
        self.sketch = samples.profile(self.doc)
        self.fit()
        self.form_ = self.analyze((self.sketch, ""))

    def test_worst_first(self):
        self.assertEqual([report.order for _, report in self.form_.joins.model.joins],
                         [-1, 0, 1, 1, 4, 4])
        self.assertIn("6 joins", self.form_.joins.summary.text())
        self.assertIn("<b>gap</b>, 0.02 mm", self.form_.banner.text.text())
        self.screenshot("list")

    def test_click_on_a_row_shows_the_join(self):
        self.click_row(1)
        self.assertIn("<b>G0</b>, misses G1 by 50.3°", self.form_.banner.text.text())
        self.assertFalse(self.form_.edges.swap.isEnabled())
        self.screenshot("list_row")

    def test_double_click_zooms(self):
        before = self.view().getCameraNode().height.getValue()
        self.click_row(4)
        place = self.row_center(4)
        QTest.mouseDClick(self.form_.joins.view.viewport(), Qt.MouseButton.LeftButton,
                          Qt.KeyboardModifier.NoModifier, place)
        self.pump()
        self.assertLess(self.view().getCameraNode().height.getValue(), 0.8 * before)

    def test_row_stays_chosen_after_an_edit(self):
        self.click_row(2)
        chosen = self.form_.joins.view.currentIndex().row()
        self.sketch.Placement.Base.x = 5.0
        self.doc.recompute()
        self.pump()
        self.assertEqual(self.form_.joins.view.selectionModel().currentIndex().row(), chosen)

    def click_row(self, row):
        QTest.mouseClick(self.form_.joins.view.viewport(), Qt.MouseButton.LeftButton,
                         Qt.KeyboardModifier.NoModifier, self.row_center(row))
        self.pump()

    def row_center(self, row):
        view = self.form_.joins.view
        return view.visualRect(view.model().index(row, 1)).center()


class LayoutTest(GuiCase):
    def test_nothing_is_cut_at_320_pixels(self):
        sketch = samples.profile(self.doc)
        form = self.analyze((sketch, ""))
        for section in (*form.sections, form.tolerance_section):
            section.header.setChecked(True)
        form.setMinimumWidth(0)
        form.resize(320, form.height())
        self.pump()
        self.assertLessEqual(form.minimumSizeHint().width(), 320)
        for label in form.findChildren(QtWidgets.QLabel):
            if label.isVisible() and not isinstance(label, Message):
                self.assertLessEqual(label.x() + label.width(), label.parent().width() + 1)

    def test_the_dock_is_widened_to_fit(self):
        samples.line_and_arc(self.doc)
        form = self.run_command()
        self.pump()
        self.assertGreaterEqual(form.width(), 300)
