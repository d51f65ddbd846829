"""Reports as CSV and JSON: what is written can be read back, and a failed write loses nothing."""
import csv
import json
import os
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from osculate import Curve, analyze, analyze_edge, write_csv, write_json
from support import circle_then_line, cubic, spline


class ExportCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.path = self.folder / "joins"
        self.reports = [analyze(*circle_then_line()), analyze(*cubic().split(0.5), order=2),
                        *analyze_edge(spline(3), order=8)]

    def rows(self):
        with open(self.path, newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))


class CsvTest(ExportCase):
    def test_numbers_come_back_bit_for_bit(self):
        write_csv(self.reports, self.path)
        for row, report in zip(self.rows(), self.reports, strict=True):
            self.assertEqual(int(row["order"]), report.order)
            self.assertEqual((row["first_end"], row["second_end"]), report.ends)
            for order, residual in enumerate(report.residuals):
                self.assertEqual(float(row[f"g{order}_residual"]), residual)
                self.assertEqual(row[f"g{order}_verdict"], report.verdicts[order])
            self.assertEqual([float(row[axis]) for axis in "xyz"], report.sides[0].point.tolist())
            self.assertEqual(float(row["first_curvature"]), report.sides[0].curvature)
            self.assertEqual(row["warnings"].split(), [w.code for w in report.warnings])

    def test_what_does_not_exist_is_empty(self):
        write_csv(self.reports, self.path)
        line_row, _, knot_row, _ = self.rows()
        self.assertEqual(line_row["second_torsion"], "")
        self.assertEqual(line_row["parameter"], "")
        self.assertEqual(float(knot_row["parameter"]), 1)
        self.assertEqual(line_row["g5_verdict"], "")  # not asked for there
        self.assertEqual(line_row["beta2"], "")

    def test_labels_with_separators_and_quotes(self):
        labels = ['Edge1, "the first"', "Kante 2 – Übergang", "", "line\nbreak"]
        write_csv(self.reports, self.path, labels=labels)
        self.assertEqual([row["label"] for row in self.rows()], labels)

    def test_no_reports_give_the_header_alone(self):
        write_csv([], self.path)
        self.assertEqual(self.rows(), [])
        self.assertTrue(self.path.read_text().startswith("label,order,"))


class JsonTest(ExportCase):
    def test_the_dicts_come_back(self):
        write_json(iter(self.reports), str(self.path))
        data = json.loads(self.path.read_text(encoding="utf-8"))
        self.assertEqual(data, [report.to_dict() for report in self.reports])

    def test_labels(self):
        write_json(self.reports, self.path, labels=["–", "b", "c", "d"])
        data = json.loads(self.path.read_text(encoding="utf-8"))
        self.assertEqual([entry["label"] for entry in data], ["–", "b", "c", "d"])
        self.assertEqual(data[0]["schema"], "osculate.join/1")

    def test_no_reports(self):
        write_json([], self.path)
        self.assertEqual(json.loads(self.path.read_text()), [])


class AtomicTest(ExportCase):
    def assert_left_alone(self):
        self.assertEqual(self.path.read_text(), "old")
        self.assertEqual(list(self.folder.iterdir()), [self.path])

    def test_bad_arguments_leave_the_old_file(self):
        self.path.write_text("old")
        for write in (write_csv, write_json):
            with self.assertRaisesRegex(TypeError, "reports: must be JoinReport, got int"):
                write([self.reports[0], 1], self.path)
            with self.assertRaisesRegex(ValueError, "labels: one for each report"):
                write(self.reports, self.path, labels=["one"])
        self.assert_left_alone()

    def test_a_write_that_fails_midway_leaves_the_old_file(self):
        self.path.write_text("old")
        for write in (write_csv, write_json):
            with mock.patch("os.fsync", side_effect=OSError("disk full")), \
                    self.assertRaisesRegex(OSError, "disk full"):
                write(self.reports, self.path)
        self.assert_left_alone()

    def test_a_folder_that_does_not_exist(self):
        with self.assertRaises(FileNotFoundError):
            write_csv(self.reports, self.folder / "missing" / "joins.csv")

    def test_the_old_file_is_replaced_and_keeps_its_permissions(self):
        self.path.write_text("old")
        self.path.chmod(0o640)
        write_json(self.reports, self.path)
        self.assertEqual(self.path.stat().st_mode & 0o777, 0o640)
        self.assertEqual(len(json.loads(self.path.read_text())), len(self.reports))
        self.assertEqual(list(self.folder.iterdir()), [self.path])

    def test_a_new_file_has_the_usual_permissions(self):
        usual = self.folder / "usual"
        usual.touch()
        write_csv(self.reports, self.path)
        self.assertEqual(self.path.stat().st_mode, usual.stat().st_mode)

    def test_a_link_stays_a_link(self):
        target = self.folder / "target"
        target.write_text("old")
        os.symlink(target, self.path)
        write_csv([analyze(Curve.bezier([(0, 0, 0), (1, 0, 0)]),
                           Curve.bezier([(1, 0, 0), (2, 0, 0)]))], self.path)
        self.assertTrue(self.path.is_symlink())
        self.assertNotEqual(target.read_text(), "old")


if __name__ == "__main__":
    unittest.main()
