"""osculate.audit of STEP, IGES and BREP files, and its results as files."""
import csv
import json
import os
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import numpy as np

from audit_models import model
from osculate import OcctError, audit
from support import Part, shared_file


class FilesTest(unittest.TestCase):
    """These need no FreeCAD: osculate reads the files itself."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_files_are_numbered_as_freecad_numbers_them(self):
        if Part is None:
            self.skipTest("needs FreeCAD's Part module")
        for name in ("impeller.igs", "NIST_MBE_PMI_4.stp", "Propeller.brep", "igesio_input.igs"):
            own, part = audit(shared_file(f"data/{name}")), audit(model(name))
            for a, b in zip(own.columns(), part.columns()):
                np.testing.assert_array_equal(a, b)

    def test_paths(self):
        path = shared_file("data/igesio_input.igs")
        for form in (str(path), path):
            report = audit(form)
            self.assertEqual((report.edge_count, report.source), (60, str(path)))
            self.assertEqual(report.notes, ())

    def test_csv(self):
        report = audit(shared_file("data/igesio_input.igs"))
        target = self.folder / "joins.csv"
        report.to_csv(target)
        with open(target, encoding="utf-8", newline="") as file:
            table = list(csv.DictReader(file))
        self.assertEqual(len(table), len(report.rows))
        for cells, row in zip(table, report.rows):
            self.assertEqual((cells["file"], cells["kind"]), (report.source, row.kind))
            self.assertEqual((int(cells["edge1"]), int(cells["edge2"])), row.edges)
            self.assertEqual((cells["end1"], cells["end2"]), row.ends)
            self.assertEqual([float(cells[key]) for key in "xyz"], row.point.tolist())
            self.assertEqual(int(cells["order"]), row.order)
            for k in range(5):
                self.assertEqual(cells[f"g{k}_verdict"], row.verdicts[k])
                self.assertEqual(float(cells[f"g{k}_residual"]), row.residuals[k])
            for name, value in row.deviation.items():
                self.assertEqual(value, None if cells[name] == "" else float(cells[name]))

    def test_json(self):
        report = audit(shared_file("data/igesio_input.igs"), order=3, tolerances="creo")
        target = self.folder / "joins.json"
        report.to_json(target)
        data = json.loads(target.read_text(encoding="utf-8"), parse_constant=self.fail)
        self.assertEqual(data["schema"], "osculate.audit/1")
        self.assertEqual((data["options"]["order"], data["options"]["preset"]), (3, "creo"))
        for key in ("joins", "kinds", "orders", "undecided"):
            self.assertEqual(data["summary"][key], report.summary[key])
        self.assertEqual(len(data["rows"]), len(report.rows))
        for entry, row in zip(data["rows"], report.rows):
            self.assertEqual(entry["edges"], list(row.edges))
            self.assertEqual(entry["ends"], list(row.ends))
            self.assertEqual(entry["residuals"], list(row.residuals))
            self.assertEqual(entry["deviation"], row.deviation)
            self.assertEqual(entry["warnings"], [warning.code for warning in row.warnings])

    def test_the_old_file_stays_where_the_new_one_cannot_be_written(self):
        report = audit(shared_file("data/igesio_input.igs"))
        with self.assertRaises(FileNotFoundError):
            report.to_csv(self.folder / "none" / "joins.csv")
        target = self.folder / "joins.json"
        target.write_text("old")
        with mock.patch("os.replace", side_effect=OSError("full")), self.assertRaises(OSError):
            report.to_json(target)
        self.assertEqual(target.read_text(), "old")
        self.assertEqual(os.listdir(self.folder), ["joins.json"])

    def test_what_is_no_model(self):
        empty = self.folder / "empty.stp"
        empty.touch()
        text = self.folder / "text.igs"
        text.write_text("no model\n" * 100)
        cut = self.folder / "cut.stp"
        cut.write_text("ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n#1=CARTESIAN_POINT('',(0.,0.,0")
        for path, error, pattern in (
                (self.folder / "none.stp", FileNotFoundError, "none.stp"),
                (self.folder, IsADirectoryError, ""),
                (empty, ValueError, "empty.stp is empty"),
                (text, ValueError, "is no STEP, IGES or BREP file"),
                (cut, ValueError, "is cut off: a STEP file ends with END-ISO-10303-21"),
                ("", FileNotFoundError, "")):
            with self.assertRaisesRegex(error, pattern):
                audit(path)

    def test_a_damaged_brep_file(self):
        whole = shared_file("data/mayo_bezier_curve.brep").read_bytes()
        cut = self.folder / "cut.brep"
        cut.write_bytes(whole[:2000])
        with self.assertRaises((ValueError, OcctError)):
            audit(cut)

    def test_a_name_that_is_not_utf8(self):
        name = os.fsencode(self.folder) + b"/caf\xe9.igs"
        with open(name, "wb") as file:
            file.write(shared_file("data/igesio_input.igs").read_bytes())
        report = audit(os.fsdecode(name))
        report.to_json(self.folder / "joins.json")
        data = json.loads((self.folder / "joins.json").read_text(encoding="utf-8"))
        self.assertTrue(data["rows"][0]["file"].endswith("caf\ufffd.igs"))
        self.assertIn("caf\ufffd.igs: 60 edges", str(report))


if __name__ == "__main__":
    unittest.main()
