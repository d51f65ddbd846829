"""What the demo has written: the right orders, the same joins in every format, pictures."""
import csv
import json
import os
import subprocess
import unittest
import xml.etree.ElementTree as ElementTree
import zipfile
from pathlib import Path

OUTPUT = Path(os.environ["OSCULATE_DEMO_OUTPUT"])


def white_pixels(picture):
    """Pixels of pure white: the ground of labels and panels, nowhere in FreeCAD's background."""
    counted = subprocess.run(
        ["convert", str(picture), "-alpha", "off", "-fill", "black", "+opaque", "white",
         "-format", "%[fx:round(mean*w*h)]", "info:"], check=True, capture_output=True, text=True)
    return int(float(counted.stdout))


class DemoTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.joins = json.loads((OUTPUT / "joins.json").read_text(encoding="utf-8"))

    def test_sample_has_the_orders_of_its_names(self):
        orders = {join["label"]: join["order"] for join in self.joins[:5]}
        self.assertEqual(orders, {f"G{n}a.Edge1 – G{n}b.Edge1": n for n in range(5)})

    def test_sample_is_smooth_only_geometrically(self):
        self.assertEqual([join["parametric_order"] for join in self.joins[:5]], [0] * 5)

    def test_real_models_have_joins_of_several_orders(self):
        self.assertGreater(len(self.joins), 300)
        self.assertLessEqual({0, 1}, {join["order"] for join in self.joins[5:]})
        self.assertEqual({join["schema"] for join in self.joins}, {"osculate.join/1"})

    def test_csv_has_the_same_joins(self):
        with open(OUTPUT / "joins.csv", newline="", encoding="utf-8") as file:
            rows = [(row["label"], int(row["order"])) for row in csv.DictReader(file)]
        self.assertEqual(rows, [(join["label"], join["order"]) for join in self.joins])

    def test_report_shows_the_misses_of_the_sample(self):
        report = (OUTPUT / "report.txt").read_text(encoding="utf-8")
        for order in range(4):
            self.assertIn(f"G{order}, misses G{order + 1} by ", report)

    def test_document_holds_checks_that_are_up_to_date(self):
        with zipfile.ZipFile(OUTPUT / "joins.FCStd") as archive:
            root = ElementTree.fromstring(archive.read("Document.xml"))
        statuses = [value.get("value") for value in
                    root.findall(".//Property[@name='Status']/String")]
        self.assertGreaterEqual(len(statuses), 7)
        self.assertEqual(set(statuses), {"OK"})

    def test_the_blend_meets_both_edges_with_g3(self):
        report = (OUTPUT / "report.txt").read_text(encoding="utf-8")
        self.assertIn("Kept1 – BlendCurve: G3, misses G4 by ", report)
        self.assertIn("BlendCurve – Kept2: G3, misses G4 by ", report)

    def test_pictures_show_labels(self):
        for name in ("joins.png", "part.png", "blend.png", "panel.png"):
            with self.subTest(name):
                self.assertGreater(white_pixels(OUTPUT / name), 3000)


if __name__ == "__main__":
    unittest.main()
