"""The table of an audit: sorting, filters, the current row, options."""

from audit_case import AuditCase
from osculate.features import make_audit
from osculate.gui import colors
from osculate.gui.audit.audit_model import JOIN, MISSES, RANK
from osculate.gui.qt import Qt


class TableTest(AuditCase):
    def setUp(self):
        super().setUp()
        self.obj = make_audit(self.doc, [self.profile], pairs="all")
        self.table_form = self.edit(self.obj)

    def choose_orders(self, data):
        self.choose(self.table_form.filter.orders, data)

    def test_worst_first_and_sorted_by_any_column(self):
        form = self.table_form
        self.assertEqual(self.texts(form, RANK), ["1", "2", "3", "4", "5"])
        self.assertEqual(self.texts(form, JOIN)[:3],
                         ["Edge3 – Edge4", "Edge2 – Edge3", "Edge1 – Edge2"])
        self.assertEqual(self.texts(form, MISSES)[1], "G2 by 150 %")
        form.table.sortByColumn(JOIN, Qt.SortOrder.AscendingOrder)
        self.assertEqual(self.texts(form, RANK)[:3], ["3", "2", "1"])
        form.table.sortByColumn(MISSES + 2, Qt.SortOrder.DescendingOrder)
        angles = [float(text[:-1]) for text in self.texts(form, MISSES + 2) if "·" not in text]
        self.assertEqual(angles, sorted(angles, reverse=True))
        self.assertGreater(angles[0], 10.0)

    def test_filters(self):
        form = self.table_form
        self.choose_orders("out")
        self.assertEqual(self.texts(form, RANK), ["1"])
        self.assertEqual(form.filter.count.text(), "1 of 5")
        self.choose_orders(2)
        self.assertEqual(self.texts(form, RANK), ["1", "2", "3"])
        self.choose_orders(0)
        self.assertEqual(self.texts(form, RANK), [])
        self.choose_orders("all")
        self.choose(form.filter.deviations, 2)
        self.type_number(form.filter.least, "120")
        self.assertEqual(self.texts(form, MISSES), ["G2 by 150 %"])
        self.screenshot("audit_filter")

    def test_what_is_required_shows_in_filter_and_summary(self):
        form = self.table_form
        self.choose_orders("out")
        form.options.required.setValue(2)
        self.pump()
        self.assertEqual(self.texts(form, RANK), ["1", "2", "3"])
        self.assertIn("below G2", form.filter.orders.currentText())
        self.assertIn("<b>3</b> below G2", form.summary.text())
        form.options.tolerances.order.setValue(1)
        self.pump()
        self.assertEqual((self.obj.OrderAsked, self.obj.Required, self.obj.Status), (1, 1, "OK"))
        self.assertEqual(form.table.rows_shown.columnCount(), MISSES + 3)
        form.options.required.setValue(3)
        self.pump()
        self.assertEqual((self.obj.OrderAsked, self.obj.Status), (3, "OK"))

    def test_a_click_selects_the_edges_and_goes_there(self):
        height = self.view().getCameraNode().height.getValue()
        self.click_row(self.table_form, 1)
        self.assertEqual(self.selected(), [("Profile", "Edge2", "Edge3")])
        self.assertLess(self.view().getCameraNode().height.getValue(), height)
        self.assertGreater(self.drawn("audit_row", colors.SIDES[0]), 100)
        self.screenshot("audit_row")
        self.finish("Ok")
        self.assertEqual(self.drawn("audit_row_gone", colors.SIDES[0]), 0)

    def test_zoom_can_be_switched_off_and_a_double_click_always_does(self):
        form = self.table_form
        self.click(form.zoom)
        height = self.view().getCameraNode().height.getValue()
        self.click_row(form, 1)
        self.assertEqual(self.view().getCameraNode().height.getValue(), height)
        self.assertEqual(self.selected(), [("Profile", "Edge2", "Edge3")])
        form.table.doubleClicked.emit(form.table.rows_shown.index(1, JOIN))
        self.assertLess(self.view().getCameraNode().height.getValue(), height)

    def test_the_row_stays_current_while_the_table_changes(self):
        form = self.table_form
        self.click_row(form, 1)
        form.table.sortByColumn(RANK, Qt.SortOrder.DescendingOrder)
        self.assertEqual(form.table.currentIndex().row(), 3)
        self.choose_orders("out")  # hides it
        self.choose_orders("all")
        self.assertEqual(form.table.currentIndex().row(), 3)
        form.options.pairs.setCurrentIndex(0)
        form.options.pairs.activated.emit(0)
        self.pump()
        self.assertEqual((self.obj.Pairs, self.obj.Joins), ("tangent", 4))
        self.assertEqual(form.table.currentIndex().row(), 3)

    def test_options_reach_the_object(self):
        form = self.table_form
        form.options.tolerances.preset.setCurrentText("catia-v5")
        self.pump()
        self.assertEqual((self.obj.Preset, self.obj.AngleTolerance.Value), ("catia-v5", 0.01))
        self.type_number(form.options.tolerances.values[1], "91")
        self.assertEqual((self.obj.Preset, self.obj.G0), ("custom", 0))
        self.type_number(form.options.touch, "0.1")
        self.assertEqual(self.obj.Gaps, 1)
        self.assertIn("gap", form.summary.text())

    def test_follows_an_edit_of_the_model(self):
        self.finish("Ok")
        self.profile.delGeometry(4)
        self.doc.recompute()
        self.assertEqual(self.obj.EdgeCount, 4)
        form = self.edit(self.obj)
        self.assertIn("4 edges", form.summary.text())
