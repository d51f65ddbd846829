"""AuditReport.to_html: the page of an audit."""
import json
import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import osculate
from osculate import audit, palette
from page_reader import Page, coordinates, text_of
from support import PYTHON, FreeCAD, Part, needs_freecad, shared_file

PNG = bytes.fromhex("89504e470d0a1a0a0000000d494844520000000100000001080600000"
                    "01f15c4890000000d49444154789c636060f8cf00000301010018dd8db000"
                    "00000049454e44ae426082")


def counts_of(page):
    """{name of an order: count} as the bars of a page say."""
    return {cells[0]: int(cells[2].split()[0].replace(",", "")) for cells in page.table("bars")}


class PageCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.path = self.folder / "page.html"

    def page(self, report, **arguments):
        report.to_html(self.path, **arguments)
        return Page(self.path.read_text(encoding="utf-8"))

    def check(self, page, report, count):
        """What is true of every page."""
        self.assertEqual([reference for reference in page.references()
                          if not reference.startswith("data:")], [])
        self.assertEqual(page.all("script") + page.all("link"), [])
        self.assertEqual(counts_of(page), report.summary["orders"])
        rows = page.table("worst") if count else []
        self.assertEqual(len(rows), count)
        for rank, (cells, row) in enumerate(zip(rows, report.worst(count)), start=1):
            self.assertEqual(cells[0], str(rank))
            for edge in row.edges:
                self.assertIn(f"Edge{edge} ", cells[2])
            self.assertTrue(cells[3].startswith("gap" if row.order < 0 else f"G{row.order}"))
        for picture in page.all("svg"):
            self.assertTrue(list(picture.iter("path")))
            for path in picture.iter("path"):
                self.assertTrue(coordinates(path.get("d")))


@needs_freecad
class ShapeTest(PageCase):
    def setUp(self):
        super().setUp()
        self.box = Part.makeBox(10, 20, 30)
        self.shape = self.box.makeFillet(3, self.box.Edges[:3])
        self.report = audit(self.shape)

    def test_page(self):
        page = self.page(self.report)
        self.check(page, self.report, 12)
        self.assertEqual(len(page.all("svg")), 13)
        self.assertEqual(text_of(page.all("h1")[0]), "Audit of Shape")
        facts = " ".join(text_of(item) for item in page.all("p", "facts"))
        self.assertIn(f"osculate {osculate.__version__} · OpenCASCADE {Part.OCC_VERSION}", facts)
        self.assertIn(f"FreeCAD {'.'.join(FreeCAD.Version()[:3])}", facts)
        kinds = self.report.summary["kinds"]
        self.assertIn(f"{kinds['vertex']} at vertices, {kinds['knot']} at inner knots", facts)

    def test_is_reproducible(self):
        with mock.patch.dict(os.environ, SOURCE_DATE_EPOCH="1000000000"):
            texts = {self.page(audit(self.shape)).text for _ in range(2)}
        self.assertEqual(len(texts), 1)
        self.assertIn("2001-09-09 01:46 +0000 · osculate", texts.pop())
        self.assertNotIn("2001-09-09", self.page(self.report).text)

    def test_numbers_of_rows(self):
        shape = Part.makePolygon([FreeCAD.Vector(*p) for p in ((0, 0, 0), (10, 0, 0), (10, 5, 0))])
        page = self.page(audit(shape))
        self.assertEqual(page.table("worst"), [
            ["1", page.table("worst")[0][1], "Edge1 end Edge2 start vertex (10, 0, 0)",
             "G0 misses G1 by 90°", "0 mm", "90°", "–", "–"]])

    def test_how_many_rows(self):
        joins = len(self.report.rows)
        for worst, count in ((0, 0), (1, 1), (5, 5), (None, joins), (10 * joins, joins)):
            page = self.page(self.report, worst=worst)
            self.check(page, self.report, count)

    def test_options(self):
        tolerances = osculate.Tolerances(gap_mm=0.5, angle_deg=2.0, curvature=0.25)
        report = audit(self.shape, order=2, tolerances=tolerances, pairs="tangent", corner_deg=20.0,
                       touch_mm=0)
        page = self.page(report)
        self.check(page, report, 6)
        self.assertEqual(page.table("options"), [
            ["Tolerances", "own values"], ["G0", "0.5 mm"], ["G1", "2°"], ["G2", "25 %"],
            ["Joins", "all pairs of edges at a vertex but corners of more than 20°"],
            ["Ends that share no vertex", "do not join"]])
        left_out = report.summary["corners_left_out"]
        self.assertGreater(left_out, 0)
        self.assertIn(f"{left_out} corners do not count", self.path.read_text(encoding="utf-8"))

    def test_options_are_those_of_the_json(self):
        for arguments in ({}, {"order": 2, "tolerances": "class-a", "pairs": "wire"},
                          {"pairs": "tangent", "corner_deg": 20, "touch_mm": 0.5},
                          {"tolerances": osculate.Tolerances(gap_mm=0.5)}):
            report = audit(self.shape, **arguments)
            report.to_json(self.folder / "joins.json")
            data = json.loads((self.folder / "joins.json").read_text(encoding="utf-8"))
            self.assertEqual(report.options, data["options"])
        report.options["tolerances"]["gap_mm"] = 7.0
        self.assertEqual(report.options, data["options"])

    def test_texts_are_escaped(self):
        title = "<b>&amp; \"x\"</title>\0\udce9"
        page = self.page(self.report, title=title)
        self.check(page, self.report, 12)
        shown = "Audit of <b>&amp; \"x\"</title>\ufffd\ufffd"
        self.assertEqual([text_of(page.all(tag)[0]) for tag in ("h1", "title")], [shown, shown])
        self.assertEqual(page.all("b"), [])

    def test_joins_are_drawn_where_they_are_in_the_colours_of_their_orders(self):
        a = Part.makeLine(FreeCAD.Vector(0, 0, 0), FreeCAD.Vector(10, 0, 0))
        b = Part.makeLine(FreeCAD.Vector(10.005, 0, 0), FreeCAD.Vector(20, 5, 0))
        c = Part.makeLine(FreeCAD.Vector(20, 5, 0), FreeCAD.Vector(20, 10, 0))
        page = self.page(audit(Part.Compound([a, b, c])))
        overview = page.all("svg")[0]
        places = {path.get("stroke"): coordinates(path.get("d"))
                  for path in overview.iter("path") if path.get("stroke")}
        (gap,), (corner,) = places[palette.GAP], places[palette.ORDERS[0]]
        lines, = (coordinates(path.get("d")) for path in overview.iter("path")
                  if path.get("class", "").startswith("edge"))
        for drawn, expected in ((gap, lines[1]), (corner, lines[3])):
            self.assertLessEqual(max(abs(u - v) for u, v in zip(drawn, expected)), 5)
        self.assertEqual([text_of(item) for item in overview.iter("text")], ["1", "2"])

    def test_numbers_only_where_the_order_is_missed(self):
        page = self.page(audit(self.shape, order=0))
        self.assertEqual(list(page.all("svg")[0].iter("text")), [])

    def test_close_ups_have_both_combs_in_one_scale(self):
        small = Part.ArcOfCircle(Part.Circle(FreeCAD.Vector(0, 10, 0), FreeCAD.Vector(0, 0, 1), 10),
                                 -3.141592653589793, -1.5707963267948966).toShape()
        large = Part.ArcOfCircle(Part.Circle(FreeCAD.Vector(0, 20, 0), FreeCAD.Vector(0, 0, 1), 20),
                                 -1.5707963267948966, -0.7853981633974483).toShape()
        page = self.page(audit(Part.Compound([small, large])))
        close_up = page.all("svg")[1]
        teeth = {path.get("class"): coordinates(path.get("d")) for path in close_up.iter("path")
                 if path.get("class", "").startswith("teeth")}
        lengths = {name: ((ends[0][0] - ends[1][0]) ** 2 + (ends[0][1] - ends[1][1]) ** 2) ** 0.5
                   for name, ends in teeth.items()}
        self.assertAlmostEqual(lengths["teeth0"] / lengths["teeth1"], 2.0, delta=0.02)

    def test_edges_without_joins(self):
        alone = Part.makeLine(FreeCAD.Vector(0, -5, 0), FreeCAD.Vector(9, -5, 0))
        shape = Part.Compound([self.shape, alone])
        self.assertNotIn("not drawn", self.page(audit(shape)).text)
        file = self.folder / "model.brep"
        shape.exportBrep(str(file))
        report = audit(file)
        self.assertIn("1 edge without a join not drawn", self.page(report).text)
        self.assertNotIn("not drawn", self.page(report, shape=shape).text)

    def test_the_shape_may_move_afterwards(self):
        shape = self.box.copy()
        alone = Part.Compound([shape, Part.makeLine(FreeCAD.Vector(0, -5, 0),
                                                    FreeCAD.Vector(9, -5, 0))])
        report = audit(alone)
        before = self.page(report).all("svg")[0]
        alone.translate(FreeCAD.Vector(500, 0, 0))
        after = self.page(report).all("svg")[0]
        self.assertEqual([path.get("d") for path in before.iter("path")],
                         [path.get("d") for path in after.iter("path")])

    def test_models_with_little_to_show(self):
        shapes = {"sphere": Part.makeSphere(3), "torus": Part.makeTorus(10, 2),
                  "vertex": Part.Vertex(1, 2, 3), "empty": Part.Compound([]),
                  "line": Part.makeLine(FreeCAD.Vector(0, 0, 0), FreeCAD.Vector(0, 0, 4)),
                  "bent": Part.makePolygon([FreeCAD.Vector(0, 0, z) for z in (0, 5, 3)])}
        for name, shape in shapes.items():
            with self.subTest(name):
                report = audit(shape)
                page = self.page(report)
                self.check(page, report, len(report.rows))
                self.assertEqual(bool(page.all("svg")), name not in ("vertex", "empty"))

    def test_far_and_tiny(self):
        for scale, offset in ((1e-5, 0.0), (1e6, 0.0), (1.0, 1e7)):
            matrix = FreeCAD.Matrix()
            matrix.scale(scale, scale, scale)
            matrix.move(offset, 0, 0)
            shape = self.shape.transformGeometry(matrix)
            report = audit(shape)
            self.check(self.page(report), report, 12)

    def test_a_stopped_audit_says_so(self):
        report = audit(self.shape, progress=lambda share: False)
        self.assertFalse(report.is_complete)
        warning, = self.page(report).all("div", "warning")
        self.assertIn("The audit was stopped", text_of(warning))
        self.assertEqual(self.page(self.report).all("div", "warning"), [])

    def test_pictures(self):
        plain, drawn = self.folder / "a.png", self.folder / "b.svg"
        plain.write_bytes(PNG)
        drawn.write_text("<svg xmlns='http://www.w3.org/2000/svg'/>")
        page = self.page(self.report, pictures=[plain, (str(drawn), "From <below>")])
        self.check(page, self.report, 12)
        self.assertEqual(page.embedded(), [("data:image/png;base64", PNG),
                                           ("data:image/svg+xml;base64", drawn.read_bytes())])
        self.assertIn("From <below>", [text_of(item) for item in page.all("figcaption")])

    def test_bad_arguments(self):
        text = self.folder / "text.png"
        text.write_text("no picture")
        null = Part.Shape()
        for error, pattern, arguments in (
                (ValueError, "worst: must be 0 or more, got -1", {"worst": -1}),
                (TypeError, "float", {"worst": 2.5}),
                (ValueError, "pictures: .*text.png is no PNG, JPEG or SVG", {"pictures": [text]}),
                (FileNotFoundError, "none.png", {"pictures": [self.folder / "none.png"]}),
                (TypeError, "pictures: each must be a path.*got int", {"pictures": [3]}),
                (TypeError, "pictures: must be a list.*got a path", {"pictures": str(text)}),
                (TypeError, "shape: must be the Part.Shape that was audited, got int",
                 {"shape": 3}),
                (TypeError, "shape: .*null shape", {"shape": null}),
                (ValueError, "shape: has 12 edges, but the report is of a model of 19",
                 {"shape": self.box})):
            with self.assertRaisesRegex(error, pattern):
                self.report.to_html(self.path, **arguments)
        self.assertEqual(os.listdir(self.folder), ["text.png"])

    def test_the_old_page_stays_where_the_new_one_cannot_be_written(self):
        with self.assertRaises(FileNotFoundError):
            self.report.to_html(self.folder / "none" / "page.html")
        self.path.write_text("old")
        with mock.patch("os.replace", side_effect=OSError("full")), self.assertRaises(OSError):
            self.report.to_html(self.path)
        self.assertEqual(self.path.read_text(), "old")
        self.assertEqual(os.listdir(self.folder), ["page.html"])


class FileTest(PageCase):
    """These need no FreeCAD."""

    def test_real_models(self):
        for name, most in (("impeller.igs", 600_000), ("NIST_MBE_PMI_4.stp", 400_000),
                           ("Propeller.brep", 200_000), ("igesio_input.igs", 100_000)):
            with self.subTest(name):
                report = audit(shared_file(f"data/{name}"))
                page = self.page(report)
                self.check(page, report, 12)
                self.assertEqual(text_of(page.all("h1")[0]), f"Audit of {name}")
                self.assertLess(self.path.stat().st_size, most)
                dots = sum(len(coordinates(path.get("d")))
                           for path in page.all("svg")[0].iter("path")
                           if path.get("stroke", "").startswith("#"))
                self.assertGreater(dots, 0)
                self.assertLessEqual(dots, len(report.rows))

    def test_a_name_that_is_not_utf8(self):
        name = os.fsencode(self.folder) + b"/caf\xe9.igs"
        with open(name, "wb") as file:
            file.write(shared_file("data/igesio_input.igs").read_bytes())
        page = self.page(audit(os.fsdecode(name)))
        self.assertEqual(text_of(page.all("h1")[0]), "Audit of caf\ufffd.igs")

    def test_the_recipe_of_the_guide(self):
        guide = Path(__file__).parents[2] / "docs" / "command-line.md"
        recipe = re.search(r"<!-- recipe: page -->\n```sh\n(.*?)```", guide.read_text("utf-8"),
                           re.S)[1]
        self.assertIn("/usr/local/share/osculate/workbench", recipe)
        (self.folder / "part.step").write_bytes(shared_file("data/igesio_input.igs").read_bytes())
        python = f"python3() {{ '{PYTHON}' -B \"$@\"; }}\n"
        workbench = str(Path(osculate.__file__).parents[1])
        subprocess.run(["bash", "-ec", python + recipe.replace(
            "/usr/local/share/osculate/workbench", workbench)], cwd=self.folder, check=True)
        page = Page((self.folder / "part.html").read_text(encoding="utf-8"))
        self.check(page, audit(self.folder / "part.step", pairs="tangent"), 20)

    def test_needs_neither_freecad_nor_a_drawing_library(self):
        script = ("import sys, osculate; osculate.audit(sys.argv[1]).to_html(sys.argv[2]); "
                  "print({'FreeCAD', 'Part', 'matplotlib', 'PySide2', 'PySide6'} "
                  "& set(sys.modules))")
        found = subprocess.run(
            [PYTHON, "-B", "-c", script, shared_file("data/igesio_input.igs"), self.path],
            env={**os.environ, "PYTHONPATH": str(Path(osculate.__file__).parents[1])},
            capture_output=True, text=True, check=True)
        self.assertEqual(found.stdout.strip(), "set()")
        self.assertEqual(len(Page(self.path.read_text(encoding="utf-8")).table("worst")), 12)


if __name__ == "__main__":
    unittest.main()
