"""osculate audit: results, options, exit statuses."""
import csv
import io
import json
import os
import pty
import stat
import subprocess
import unittest

from support import MODELS, PROGRAM, WIRE, ProgramTest, run, shared_file


class ResultsTest(ProgramTest):
    def report(self, *arguments):
        result = self.run_here("audit", *arguments, "--json", "-")
        self.assertEqual(result.stderr, "")
        return json.loads(result.stdout)

    def test_every_format_has_the_same_joins(self):
        for name in ("wire.step", "wire.igs", "wire.brep"):
            report = self.report(MODELS / name)
            self.assertEqual(report["summary"]["orders"], WIRE, name)
            self.assertEqual(report["files"][0]["edges"], 4)
            self.assertEqual({tuple(row["edges"]) for row in report["rows"]},
                             {(1, 2), (2, 3), (3, 4)})

    def test_a_cut_spline_and_an_arc(self):
        for name in ("smooth.step", "smooth.igs", "smooth.brep"):
            report = self.report(MODELS / name)
            kinds = sorted((row["kind"], row["order"]) for row in report["rows"])
            self.assertEqual(kinds, [("knot", 2), ("knot", 4), ("knot", 4), ("vertex", 4)], name)

    def test_the_content_decides_on_the_format(self):
        self.copy("wire.step", "wire.brep")
        self.copy("wire.igs", "wire.txt")
        for name in ("wire.brep", "wire.txt"):
            self.assertEqual(self.report(name)["summary"]["joins"], 3)

    def test_text(self):
        text = self.assert_fine(self.run_here("audit", self.copy("wire.step")))
        lines = text.splitlines()
        self.assertEqual(lines[0], "wire.step: 4 edges, 3 joins: 3 at vertices, 0 at inner knots, "
                                   "0 at seams")
        self.assertEqual(lines[1], "  G0 1   G1 2")
        self.assertRegex(lines[2],
                         r"^  3 end \+ 4 start +G0, misses G1 by 90 deg .* \(15, 20, 0\)$")
        self.assertEqual(len(lines), 5)

    def test_json(self):
        report = self.report(MODELS / "wire.step", "--order", "2", "--tolerances", "class-a")
        self.assertEqual(report["schema"], "osculate.audit/1")
        self.assertEqual((report["options"]["order"], report["options"]["preset"]), (2, "class-a"))
        for row in report["rows"]:
            self.assertEqual(row["file"], str(MODELS / "wire.step"))
            self.assertEqual(len(row["residuals"]), 3)

    def test_csv(self):
        result = self.run_here("audit", MODELS / "wire.step", MODELS / "smooth.brep", "--csv", "-")
        rows = list(csv.DictReader(io.StringIO(self.assert_fine(result))))
        self.assertEqual([os.path.basename(row["file"]) for row in rows],
                         ["wire.step"] * 3 + ["smooth.brep"] * 4)
        worst = min(rows, key=lambda row: int(row["order"]))
        self.assertEqual((worst["edge1"], worst["edge2"], float(worst["g1_residual"])),
                         ("3", "4", 90.0))

    def test_csv_and_json_together(self):
        self.assert_fine(self.run_here("audit", MODELS / "wire.step", "--csv", "a.csv", "--json",
                                       "a.json", "--quiet"))
        with open(self.folder / "a.csv", encoding="utf-8") as file:
            self.assertEqual(len(file.readlines()), 4)
        self.assertEqual(len(json.loads((self.folder / "a.json").read_text())["rows"]), 3)

    def test_worst(self):
        for count, lines in ((0, 2), (1, 3), (2, 4), (50, 5)):
            text = self.assert_fine(run("audit", MODELS / "wire.step", "--worst", count))
            self.assertEqual(len(text.splitlines()), lines)

    def test_quiet(self):
        self.assertEqual(self.assert_fine(run("audit", MODELS / "wire.step", "--quiet")), "")

    def test_many_files(self):
        names = [self.copy(name, f"{number}-{name}") for number in range(4)
                 for name in ("wire.step", "smooth.igs", "wire.brep")]
        one = self.report(*names, "--jobs", "1")
        many = self.report(*names, "--jobs", "5")
        self.assertEqual(one, many)
        self.assertEqual([entry["file"] for entry in many["files"]], names)
        text = self.assert_fine(self.run_here("audit", *names, "--jobs", "5"))
        self.assertIn("all 12 files: 40 joins", text)

    def test_a_path_given_twice_is_audited_once(self):
        names = [self.copy("wire.step"), self.copy("wire.brep")]
        report = self.report(*names, *names, "./wire.brep", "--files-from",
                             self.write("list", "wire.step\n"))
        self.assertEqual([entry["file"] for entry in report["files"]], names)
        self.assertEqual(report["summary"]["joins"], 6)

    def test_real_models(self):
        report = self.report(shared_file("data/NIST_MBE_PMI_4.stp"),
                             shared_file("data/Fuselage_guides.brep"),
                             shared_file("data/igesio_input.igs"))
        kinds = [entry["summary"]["kinds"] for entry in report["files"]]
        self.assertEqual([(kind["vertex"], kind["knot"]) for kind in kinds],
                         [(2786, 745), (288, 3240), (60, 0)])


class OptionsTest(ProgramTest):
    def joins(self, *options, model="wire.step"):
        result = run("audit", MODELS / model, "--json", "-", *options)
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(result.stdout)

    def test_pairs(self):
        for pairs, joins in (("all", 3), ("wire", 3), ("tangent", 2)):
            report = self.joins("--pairs", pairs)
            self.assertEqual((report["options"]["pairs"], report["summary"]["joins"]),
                             (pairs, joins))
        self.assertEqual(report["files"][0]["corners_left_out"], 1)
        self.assertEqual(self.joins("--pairs", "tangent", "--corner-deg", "95")["summary"]["joins"],
                         3)

    def test_touching_ends_of_wireframe(self):
        self.assertEqual(self.joins("--touch-mm", "0")["summary"]["joins"], 0)
        self.assertEqual(self.joins("--touch-mm", "0", model="wire.brep")["summary"]["joins"], 3)

    def test_own_tolerances(self):
        self.assertEqual(self.joins("--angle-deg", "91")["summary"]["orders"]["G0"], 0)
        options = self.joins("--gap-mm", "0.5", "--curvature", "0.2", "--third", "0.3",
                             "--fourth", "0.4")["options"]
        self.assertEqual(options["preset"], "custom")
        self.assertEqual(options["tolerances"], {"gap_mm": 0.5, "angle_deg": 0.1, "curvature": 0.2,
                                                 "third": 0.3, "fourth": 0.4})

    def test_presets(self):
        for preset in ("exact", "osculate", "rhino", "opennurbs", "catia-v5", "icem", "creo",
                       "occt", "class-a"):
            self.assertEqual(self.joins("--tolerances", preset)["options"]["preset"], preset)

    def test_order(self):
        self.assertEqual(self.joins("--order", "0")["summary"]["orders"], {"gap": 0, "G0": 3})
        self.assertEqual(self.joins("--order", "8", model="smooth.brep")["rows"][-1]["order"], 8)

    def test_files_from_a_list(self):
        self.copy("wire.step")
        self.copy("wire.igs", "a b.igs")
        self.write("list.txt", "wire.step\n\na b.igs\r\n")
        result = self.run_here("audit", "--files-from", "list.txt", "--json", "-")
        report = json.loads(self.assert_fine(result))
        self.assertEqual([entry["file"] for entry in report["files"]], ["wire.step", "a b.igs"])
        result = self.run_here("audit", "wire.step", "--files-from", "-", "--json", "-",
                               input="a b.igs\n")
        report = json.loads(self.assert_fine(result))
        self.assertEqual([entry["file"] for entry in report["files"]], ["wire.step", "a b.igs"])

    def test_odd_names(self):
        for name in ("a,b\".step", "-dash.step", "neue\nzeile.step", "ä.step"):
            self.copy("wire.step", name)
            result = self.run_here("audit", "--csv", "-", "--", name)
            rows = list(csv.DictReader(io.StringIO(self.assert_fine(result), newline="")))
            self.assertEqual([row["file"] for row in rows], [name] * 3)


class StatusTest(ProgramTest):
    def test_fail_below(self):
        for order, status in (("G0", 0), ("G1", 1), ("G2", 1), ("g2", 1), ("2", 1), ("G4", 1)):
            result = run("audit", MODELS / "wire.step", "--fail-below", order)
            self.assertEqual(result.returncode, status, order)
        self.assertIn("osculate: 3 of 3 joins are below G4\n", result.stderr)
        self.assertIn("misses G1", result.stdout)

    def test_fail_below_without_corners(self):
        options = ("audit", MODELS / "wire.step", "--pairs", "tangent", "--fail-below")
        self.assert_fine(run(*options, "G1"))
        self.assert_status(run(*options, "G2"), 1, "2 of 2 joins are below G2")

    def test_smooth_models_pass(self):
        self.assert_fine(run("audit", MODELS / "smooth.step", "--fail-below", "G2"))
        self.assert_status(run("audit", MODELS / "smooth.step", "--fail-below", "G3"), 1, "1 of 4")

    def test_bad_use(self):
        wire = MODELS / "wire.step"
        for arguments, message in (
                ((), "no files to audit"),
                ((wire, "--fail-below", "G9"), "must be G0 to G8, got G9"),
                ((wire, "--fail-below", "smooth"), "must be G0 to G8"),
                ((wire, "--order", "1", "--fail-below", "G2"), "ask for --order 2"),
                ((wire, "--order", "9"), "--order"), ((wire, "--order", "x"), "--order"),
                ((wire, "--tolerances", "mine"), "--tolerances"),
                ((wire, "--gap-mm", "-1"), "--gap-mm"), ((wire, "--pairs", "some"), "--pairs"),
                ((wire, "--corner-deg", "200"), "--corner-deg"),
                ((wire, "--corner-deg", "20"), "no effect without --pairs tangent"),
                ((wire, "--touch-mm", "-1"), "--touch-mm: must not be below 0, got -1"),
                ((wire, "--jobs", "0"), "--jobs: must be greater than 0, got 0"),
                ((wire, "--worst", "-1"), "--worst"),
                ((wire, "--time-limit", "0"), "--time-limit"), ((wire, "--unknown"), "--unknown"),
                ((wire, "--csv", "-", "--json", "-"), "only one can go to standard output"),
                (("--files-from", "/no/such/list"), "cannot read /no/such/list")):
            with self.subTest(arguments[1:]):
                result = self.assert_status(run("audit", *arguments), 2, message)
                self.assertEqual(result.stdout, "")

    def test_an_unreadable_file_does_not_stop_the_rest(self):
        names = [self.copy("wire.step"), "none.step", self.copy("smooth.brep")]
        result = self.run_here("audit", *names, "--json", "-")
        self.assert_status(result, 2, "none.step: unreadable: cannot be read: No such file")
        report = json.loads(result.stdout)
        self.assertEqual([entry["status"] for entry in report["files"]],
                         ["audited", "unreadable", "audited"])
        self.assertEqual(report["summary"]["joins"], 7)

    def test_an_unreadable_file_wins_over_a_join_below(self):
        result = run("audit", MODELS / "wire.step", "/none.step", "--fail-below", "G2")
        self.assert_status(result, 2, "none.step", "3 of 3 joins are below G2")

    def test_edges_that_cannot_be_analysed(self):
        model = MODELS / "infinite.brep"
        said = f"osculate: {model}: 1 edge could not be analysed\n"
        result = run("audit", model, "--json", "-")
        self.assertEqual((result.returncode, result.stderr), (0, said))
        entry = json.loads(result.stdout)["files"][0]
        self.assertEqual((entry["edges"], entry["summary"]["joins"]), (5, 3))
        self.assertEqual(entry["skipped"], [{"edge": 5, "degenerated": False, "reason":
                                             "is infinite; trim it to a finite range"}])
        result = run("audit", model, "--strict", "--quiet")
        self.assertEqual((result.returncode, result.stdout, result.stderr), (2, "", said))

    def test_a_file_without_edges(self):
        text = self.assert_fine(run("audit", MODELS / "point.brep", "--fail-below", "G4"))
        self.assertIn("0 edges, 0 joins", text)


class OutputTest(ProgramTest):
    def test_outputs_that_cannot_be_written(self):
        self.write("old.json", "old")
        (self.folder / "folder").mkdir()
        for option, path in (("--csv", "none/a.csv"), ("--json", "none/a.json"),
                             ("--csv", "folder"), ("--json", "/proc/a.json")):
            result = self.run_here("audit", MODELS / "wire.step", option, path)
            self.assert_status(result, 2, "cannot write ", path)
            self.assertEqual(result.stdout, "", "refused before the work")
        self.assertEqual(sorted(os.listdir(self.folder)), ["folder", "old.json"])

    @unittest.skipIf(os.geteuid() == 0, "root may write everywhere")
    def test_a_folder_without_permission(self):
        (self.folder / "locked").mkdir(mode=0o500)
        result = self.run_here("audit", MODELS / "wire.step", "--csv", "locked/a.csv")
        self.assert_status(result, 2, "Permission denied")

    def test_a_full_disk(self):
        result = run("audit", MODELS / "wire.step", "--csv", "/dev/full")
        self.assert_status(result, 2, "cannot write /dev/full: No space left")

    def test_devices_are_written_in_place(self):
        self.assert_fine(run("audit", MODELS / "wire.step", "--csv", "/dev/null", "--quiet"))
        self.assertTrue(stat.S_ISCHR(os.stat("/dev/null").st_mode))

    def test_an_old_file_is_replaced_and_keeps_its_permissions(self):
        self.write("old.csv", "old")
        os.chmod(self.folder / "old.csv", 0o640)
        os.symlink("old.csv", self.folder / "link.csv")
        self.assert_fine(self.run_here("audit", MODELS / "wire.step", "--csv", "link.csv", "-q"))
        self.assertTrue((self.folder / "link.csv").is_symlink())
        self.assertEqual(stat.S_IMODE(os.stat(self.folder / "old.csv").st_mode), 0o640)
        self.assertEqual(len((self.folder / "old.csv").read_text().splitlines()), 4)

    def test_nothing_but_results_in_a_pipe(self):
        result = run("audit", MODELS / "wire.igs", "--json", "-")
        self.assertEqual(result.stderr, "")
        json.loads(result.stdout)


class ProgressTest(ProgramTest):
    def on_terminal(self, *arguments):
        """What the program writes to a terminal that is its standard error."""
        leader, follower = pty.openpty()
        process = subprocess.Popen([PROGRAM, *map(str, arguments)], stdout=subprocess.DEVNULL,
                                   stderr=follower)
        os.close(follower)
        text = b""
        try:
            while True:
                text += os.read(leader, 4096)
        except OSError:
            pass  # the program has closed it
        os.close(leader)
        process.wait(timeout=60)
        return text.decode()

    def test_a_line_on_a_terminal(self):
        model = shared_file("data/NIST_MBE_PMI_4.stp")
        text = self.on_terminal("audit", model, MODELS / "wire.step", "--jobs", "1")
        self.assertRegex(text, r"\r\x1b\[K[01] of 2 files, \d+ %")
        self.assertTrue(text.endswith("\r\x1b[K"), "the line is wiped out")

    def test_none_where_it_is_not_wanted(self):
        model = shared_file("data/igesio_input.igs")
        self.assertEqual(self.on_terminal("audit", model, "--quiet"), "")


if __name__ == "__main__":
    unittest.main()
