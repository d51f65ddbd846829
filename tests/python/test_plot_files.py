"""Curve plots on paper: what is drawn, and files that can be read back and lose nothing."""
import csv
import math
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from unittest import mock

import numpy as np

from osculate import COMB_QUANTITIES, Curve, curve_plot, palette
from support import circle_then_line, cubic, full_circle, spline

try:
    from matplotlib.colors import to_hex
    from matplotlib.figure import Figure
except ImportError:
    Figure = None

needs_matplotlib = unittest.skipIf(Figure is None, "needs matplotlib")


def cusp():
    """A planar cubic with a cusp in its middle."""
    return Curve.bezier([(0, 0, 0), (30, 30, 0), (0, 30, 0), (30, 0, 0)])


class FileCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)


class CsvTest(FileCase):
    def rows(self, plot, **options):
        path = self.folder / "plot.csv"
        plot.save(path, **options)
        with open(path, newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def test_numbers_come_back_bit_for_bit(self):
        plot = curve_plot([*circle_then_line(), cubic(), spline(3)])
        rows = self.rows(plot, labels=["a", 'b, "c"', "κ", ""])
        self.assertEqual(len(rows), len(plot.s))
        self.assertEqual([float(row["s_mm"]) for row in rows], plot.s.tolist())
        for quantity in COMB_QUANTITIES:
            values = [float(row[quantity] or math.nan) for row in rows]
            np.testing.assert_array_equal(values, getattr(plot.comb, quantity))
        for axis, name in enumerate("xyz"):
            self.assertEqual([float(row[name]) for row in rows],
                             plot.comb.point[:, axis].tolist())
        self.assertEqual([row["label"] for row in rows],
                         [("a", 'b, "c"', "κ", "")[int(row["curve"])] for row in rows])

    def test_a_jump_has_two_rows_of_different_runs(self):
        before, after = [row for row in self.rows(curve_plot(circle_then_line()))
                         if row["join"] == "G1"]
        self.assertEqual(before["s_mm"], after["s_mm"])
        self.assertNotEqual(before["run"], after["run"])
        self.assertAlmostEqual(float(before["curvature"]), 0.1, delta=1e-13)
        self.assertEqual((float(after["curvature"]), after["torsion"]), (0.0, ""))

    def test_parameters_are_those_of_the_curves_that_were_given(self):
        line, curve = Curve.bezier([(-5, 0, 0), (0, 0, 0)]), cubic().reversed()
        for row in self.rows(curve_plot([line, curve])):
            point = (line, curve)[int(row["curve"])].evaluate(float(row["parameter"]))[0]
            np.testing.assert_allclose(point, [float(row[axis]) for axis in "xyz"], atol=1e-12)

    def test_needs_no_matplotlib(self):
        with mock.patch.dict(sys.modules, {"matplotlib": None}):
            self.assertTrue(self.rows(curve_plot(cubic())))


@needs_matplotlib
class PictureTest(FileCase):
    def setUp(self):
        super().setUp()
        self.plot = curve_plot([*circle_then_line(), cubic()])

    def test_svg_is_xml_and_equal_plots_are_equal_files(self):
        for name in ("a.svg", "b.SVG", "a.pdf", "b.pdf"):
            self.plot.save(self.folder / name)
        root = ElementTree.parse(self.folder / "a.svg").getroot()
        self.assertEqual(root.tag, "{http://www.w3.org/2000/svg}svg")
        self.assertEqual((self.folder / "a.svg").read_bytes(), (self.folder / "b.SVG").read_bytes())
        self.assertEqual((self.folder / "a.pdf").read_bytes(), (self.folder / "b.pdf").read_bytes())
        self.assertTrue((self.folder / "a.pdf").read_bytes().startswith(b"%PDF"))

    def test_png_has_the_size_asked_for(self):
        self.plot.save(self.folder / "a.png", size=(4.0, 3.0))
        data = (self.folder / "a.png").read_bytes()
        self.assertEqual([int.from_bytes(data[i:i + 4], "big") for i in (16, 20)], [600, 450])

    def test_a_write_that_fails_leaves_the_old_file(self):
        for name in ("a.svg", "a.csv"):
            path = self.folder / name
            path.write_text("old")
            with mock.patch("os.fsync", side_effect=OSError("disk full")), \
                    self.assertRaisesRegex(OSError, "disk full"):
                self.plot.save(path)
            self.assertEqual(path.read_text(), "old")
        self.assertEqual(len(list(self.folder.iterdir())), 2)
        with self.assertRaises(FileNotFoundError):
            self.plot.save(self.folder / "missing" / "a.pdf")

    def test_bad_arguments(self):
        with self.assertRaisesRegex(ValueError, r"must end with one of .svg, .pdf, .png, .csv, "
                                                "got 'plot.txt'"):
            self.plot.save(self.folder / "plot.txt")
        with self.assertRaisesRegex(ValueError, "labels: one for each curve is needed, got 1 for "
                                                "3 curves"):
            self.plot.save(self.folder / "plot.csv", labels=["one"])
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_without_matplotlib_it_says_so(self):
        kept = {name: None for name in sys.modules if name.partition(".")[0] == "matplotlib"}
        with mock.patch.dict(sys.modules, {**kept, "matplotlib": None}):
            sys.modules.pop("osculate.plot_drawing", None)
            with self.assertRaisesRegex(ImportError, "python3-matplotlib"):
                self.plot.save(self.folder / "a.svg")
        self.assertEqual(list(self.folder.iterdir()), [])


@needs_matplotlib
class DrawingTest(unittest.TestCase):
    def draw(self, curves, size=(8.0, 6.0), **options):
        return curve_plot(curves).draw(Figure(figsize=size), **options)

    def line_of(self, drawing, quantity):
        return next(line for line in drawing.axes[quantity].lines
                    if line.get_color() == palette.QUANTITIES[quantity])

    def labels(self, drawing):
        return [(label.get_text(), to_hex(label.get_bbox_patch().get_facecolor()))
                for label in drawing._labels if label.get_visible()]

    def test_axes_share_the_arc_length(self):
        drawing = self.draw(cubic())
        self.assertEqual(list(drawing.axes), ["curvature", "torsion", "curvature_rate",
                                              "curvature_rate2"])
        for axes in drawing.axes.values():
            self.assertEqual(axes.get_xlim(), (0.0, drawing.window[1]))
        drawing.see((1.0, 2.0))
        for axes in drawing.axes.values():
            self.assertEqual(axes.get_xlim(), (1.0, 2.0))

    def test_no_line_runs_across_a_jump(self):
        drawing = self.draw(circle_then_line())
        s, values = self.line_of(drawing, "curvature").get_data()
        ends = [(s[i], values[i], values[i + 1]) for i in range(len(s) - 1)
                if np.isfinite(values[i:i + 2]).all()]
        self.assertTrue(all(abs(after - before) < 1e-12 for _, before, after in ends))

    def test_joins_have_labels_in_the_colours_of_their_orders(self):
        gap = Curve.bezier([(-15, 10, 0), (-20, 10, 0)])
        drawing = self.draw([*circle_then_line(), gap])
        self.assertEqual(self.labels(drawing), [("gap 5 mm", palette.GAP),
                                                ("G1", palette.of_order(1))])
        lines = drawing._parts["torsion"].joins
        marks = {round(path.vertices[0, 0], 6): to_hex(color)
                 for path, color in zip(lines.get_paths(), lines.get_colors())}
        self.assertEqual(marks[round(5.0 * math.pi, 6)], palette.of_order(1))

    def test_knots_have_thinner_lines_than_joins(self):
        curve = spline(3)
        end, tangent = (curve.evaluate(3.0, 1)[row] for row in (0, 1))
        drawing = self.draw([curve, Curve.bezier([end, end + tangent])])
        widths = list(drawing._parts["curvature"].joins.get_linewidths())
        self.assertEqual(len(widths), 3)
        self.assertLess(max(widths[:2]), widths[2])

    def test_labels_that_have_no_room_are_left_out_and_come_back(self):
        drawing = self.draw(spline(60))
        few = len(self.labels(drawing))
        self.assertLess(few, 40)
        s = drawing._plot.joins[30].s
        drawing.see((s - 0.5, s + 0.5))
        self.assertIn("G2", [text for text, _ in self.labels(drawing)])

    def test_a_constant_is_straight_and_rounding_is_zero(self):
        drawing = self.draw(full_circle(10.0))
        lowest, highest = drawing.axes["curvature"].get_ylim()
        self.assertGreater(highest - lowest, 0.004)
        self.assertTrue(lowest < 0.1 < highest)
        for quantity in ("torsion", "curvature_rate", "curvature_rate2"):
            self.assertEqual(drawing._parts[quantity].note.get_text(), "zero everywhere")
        line = self.draw(Curve.bezier([(0, 0, 0), (1, 2, 3)]))
        self.assertEqual(line._parts["torsion"].note.get_text(), "does not exist")

    def test_a_spike_does_not_hide_the_rest_and_it_says_so(self):
        drawing = self.draw([cusp(), Curve.bezier(cubic().poles + 50)])
        plot = drawing._plot
        largest = np.nanmax(plot.comb.curvature)
        usual = np.nanmax(plot.comb.curvature[plot.places == 1])
        _, highest = drawing.axes["curvature"].get_ylim()
        self.assertLess(highest, 0.2 * largest)
        self.assertGreater(highest, usual)
        self.assertIn("curvature", drawing.cut)
        self.assertIn("cut, up to 17.1 mm⁻¹", drawing._parts["curvature"].note.get_text())
        drawing.see((0.9 * plot.length, plot.length))
        self.assertEqual((drawing.cut, drawing._parts["curvature"].note.get_text()), ((), ""))

    def test_another_plot_takes_the_place_of_the_first(self):
        drawing = self.draw([*circle_then_line(), cubic()])
        axes = list(drawing.axes.values())
        other = curve_plot(spline(3))
        drawing.show(other)
        self.assertEqual(list(drawing.axes.values()), axes)
        s, values = self.line_of(drawing, "curvature").get_data()
        np.testing.assert_array_equal(values, other.series("curvature")[1])
        self.assertEqual([text for text, _ in self.labels(drawing)], ["G2", "G2"])
        self.assertEqual(drawing.window, (0.0, other.length))

    def test_between_two_samples_the_line_is_seen(self):
        drawing = self.draw(cubic())
        s, values = drawing._plot.s, drawing._plot.comb.curvature
        window = [s[40] + share * (s[41] - s[40]) for share in (0.4, 0.6)]
        drawing.see(window)
        lowest, highest = drawing.axes["curvature"].get_ylim()
        self.assertTrue(lowest < np.interp(window[0], s, values) < highest)
        self.assertEqual(drawing.cut, ())

    def test_bad_options(self):
        for options, words in (({"quantities": ("speed",)}, "quantities: 'speed' is none of"),
                               ({"window": (3.0, 3.0)}, "window: must be .first, last. with"),
                               ({"window": (1.0, float("nan"))}, "window: must be")):
            with self.subTest(options), self.assertRaisesRegex(ValueError, words):
                self.draw(cubic(), **options)

    def test_limits_can_be_given(self):
        drawing = self.draw(cubic(), limits={"curvature": (-1.0, 2.0)})
        self.assertEqual(drawing.axes["curvature"].get_ylim(), (-1.0, 2.0))

    def test_units_carry_the_power_of_ten(self):
        drawing = self.draw(Curve.bezier(1000 * cubic().poles))
        self.assertEqual(drawing._parts["curvature"].name.get_text(), "κ  (10⁻⁶ mm⁻¹)")
        formatter = drawing.axes["curvature"].yaxis.get_major_formatter()
        self.assertEqual(formatter(5e-5, 0), "50")

    def test_a_figure_too_small_for_anything_is_no_error(self):
        self.draw(cubic(), size=(0.5, 0.5))


if __name__ == "__main__":
    unittest.main()
