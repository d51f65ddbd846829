"""osculate analyze, blend and merge; help, version, the manual page, installation."""
import json
import os
import re
import shutil
import subprocess
import unittest

from support import MODELS, ProgramTest, run, shared_file

WIRE, SMOOTH = MODELS / "wire.step", MODELS / "smooth.brep"


class AnalyzeTest(ProgramTest):
    def test_text(self):
        text = self.assert_fine(run("analyze", WIRE, "--edges", "1", "2"))
        self.assertTrue(text.startswith("G1, misses G2 by 1 (tolerance 0.01)\n"), text)

    def test_json(self):
        report = json.loads(self.assert_fine(run("analyze", WIRE, "--edges", "2", "1", "--json")))
        self.assertEqual((report["schema"], report["order"]), ("osculate.join/1", 1))
        self.assertEqual([side["end"] for side in report["sides"]], ["start", "end"])

    def test_ends(self):
        report = json.loads(run("analyze", WIRE, "--edges", "1", "2", "--ends", "start", "end",
                                "--json").stdout)
        self.assertEqual((report["order"], [side["end"] for side in report["sides"]]),
                         (-1, ["start", "end"]))

    def test_order_and_tolerances(self):
        report = json.loads(run("analyze", WIRE, "--edges", "1", "2", "--json", "--order", "2",
                                "--tolerances", "rhino", "--curvature", "1.5").stdout)
        self.assertEqual((report["order"], report["preset"], len(report["verdicts"])),
                         (2, "custom", 3))

    def test_the_joins_within_an_edge(self):
        reports = json.loads(self.assert_fine(run("analyze", SMOOTH, "--edges", "1", "--json")))
        self.assertEqual([report["parameter"] for report in reports], [1.0])
        text = self.assert_fine(run("analyze", SMOOTH, "--edges", "1"))
        self.assertTrue(text.startswith("at the inner knot 1:\nG2, misses G3"), text)
        text = self.assert_fine(run("analyze", WIRE, "--edges", "1"))
        self.assertEqual(text, "the edge has no inner knots and is open: no joins\n")
        self.assertEqual(run("analyze", WIRE, "--edges", "1", "--json").stdout, "[]\n")

    def test_the_closing_join(self):
        model = shared_file("data/Propeller.brep")
        report = json.loads(self.assert_fine(run("audit", model, "--json", "-")))
        closed = next(row["edges"][0] for row in report["rows"] if row["kind"] == "seam")
        text = self.assert_fine(run("analyze", model, "--edges", closed, closed))
        self.assertRegex(text, "^(G|gap)")
        self.assert_status(run("analyze", WIRE, "--edges", "2", "2"), 2,
                           "its closing join, but it is open")

    def test_fail_below(self):
        self.assert_status(run("analyze", WIRE, "--edges", "1", "2", "--fail-below", "G2"), 1)
        self.assert_fine(run("analyze", WIRE, "--edges", "1", "2", "--fail-below", "G1"))

    def test_bad_use(self):
        for arguments, message in (
                ((WIRE,), "--edges is required"), ((), "is required"),
                ((WIRE, "--edges", "1", "5"), "--edges: the file has the edges 1 to 4, got 5"),
                ((WIRE, "--edges", "0", "1"), "got 0"), ((WIRE, "--edges", "1", "2", "3"), ""),
                ((WIRE, "--edges", "one"), "--edges"),
                ((WIRE, "--edges", "1", "2", "--ends", "end"), "--ends"),
                ((WIRE, "--edges", "1", "2", "--ends", "top", "end"), "--ends"),
                (("none.step", "--edges", "1", "2"), "none.step cannot be read"),
                ((MODELS / "point.brep", "--edges", "1"), "the edges 1 to 0"),
                ((WIRE, "--edges", "1", "2", "--fail-below", "G7"), "ask for --order 7")):
            with self.subTest(arguments[1:]):
                result = self.assert_status(run("analyze", *arguments), 2, message)
                self.assertEqual(result.stdout, "")

    def test_a_degenerated_edge(self):
        model = shared_file("data/Propeller.brep")
        report = json.loads(run("audit", model, "--json", "-").stdout)
        edge = report["files"][0]["skipped"][0]["edge"]
        self.assert_status(run("analyze", model, "--edges", edge), 2,
                           f"edge {edge}: edge: is degenerated")


class BlendTest(ProgramTest):
    def joins_of(self, name):
        """The blend's edge with both of its neighbours, analysed anew from its file."""
        report = json.loads(self.run_here("audit", name, "--json", "-").stdout)
        return report["files"][0]["edges"]

    def test_every_format(self):
        for ending in ("step", "stp", "iges", "IGS", "brep", "brp"):
            name = f"out.{ending}"
            text = self.assert_fine(self.run_here("blend", WIRE, "--edges", "1", "3", "-o", name))
            self.assertRegex(text, rf"^out.{ending}: degree 7, length [0-9.]+ mm\n"
                                   r"  at edge 1: G3; beta .*\n  at edge 3: G3; beta .*\n$")
            self.assertEqual(self.joins_of(name), 1)

    def test_orders_degree_and_numbers(self):
        result = self.run_here("blend", WIRE, "--edges", "1", "3", "--order", "1", "2", "--degree",
                               "6", "--beta-first", "0.9", "--fairness", "bending", "-o", "o.brep",
                               "--json")
        data = json.loads(self.assert_fine(result))
        self.assertEqual(data["schema"], "osculate.blend/1")
        self.assertEqual(data["curve"]["degree"], 6)
        self.assertEqual(len(data["curve"]["poles"]), 7)
        self.assertAlmostEqual(data["beta"][0][0], 0.9, places=14)
        self.assertEqual(len(data["beta"][1]), 2)
        self.assertEqual([report["order"] for report in data["reports"]], [1, 2])
        self.assertEqual(data["warnings"], [])
        self.assertGreater(data["energy"]["length_mm"], 5)

    def test_symmetric_and_without_fairness(self):
        options = ("blend", WIRE, "--edges", "1", "3", "-o", "o.brep", "--json", "--order", "2")
        data = json.loads(self.run_here(*options, "--symmetric").stdout)
        self.assertEqual(data["beta"][0], data["beta"][1])
        data = json.loads(self.run_here(*options, "--fairness", "none").stdout)
        self.assertEqual(data["beta"], [[1.0, 0.0], [1.0, 0.0]])
        self.assertIsNone(data["energy"]["objective"])

    def test_ends(self):
        data = json.loads(self.run_here("blend", WIRE, "--edges", "1", "3", "--ends", "start",
                                        "end", "-o", "o.brep", "--json").stdout)
        self.assertEqual(data["curve"]["poles"][0], [0, 0, 0])
        self.assertEqual(data["curve"]["poles"][-1], [15, 20, 0])

    def test_the_file_is_the_curve(self):
        """BREP keeps 15 digits; the blend meets its neighbours from the file too."""
        data = json.loads(self.run_here("blend", WIRE, "--edges", "1", "3", "--order", "2", "-o",
                                        "o.brep", "--json").stdout)
        text = (self.folder / "o.brep").read_text()
        for coordinate in data["curve"]["poles"][1][:2]:
            self.assertIn(f"{coordinate:.10g}"[:9], text)

    def test_bad_use(self):
        self.write("old.brep", "old")
        (self.folder / "folder.brep").mkdir()
        for arguments, message in (
                (("--edges", "1", "3"), "--output is required"),
                (("--edges", "1", "-o", "o.step"), "--edges"),
                (("--edges", "1", "9", "-o", "old.brep"), "the edges 1 to 4, got 9"),
                (("--edges", "1", "3", "-o", "o.stl"), "output: must end with .step"),
                (("--edges", "1", "3", "-o", "none/o.step"), "cannot write none/"),
                (("--edges", "1", "3", "-o", "folder.brep"), "Is a directory"),
                (("--edges", "1", "3", "--order", "9", "-o", "o.step"), "--order"),
                (("--edges", "1", "3", "--degree", "3", "-o", "old.brep"), "degree"),
                (("--edges", "1", "3", "--order", "1", "--beta-first", "1", "2", "-o", "o.step"),
                 "--beta-first: at most as many numbers as the order, 1, got 2"),
                (("--edges", "1", "3", "--beta-first", "-1", "-o", "old.brep"), "beta"),
                (("--edges", "1", "2", "-o", "old.brep"), "osculate: ")):
            with self.subTest(arguments):
                result = self.run_here("blend", WIRE, *arguments)
                self.assertEqual(self.assert_status(result, 2, message).stdout, "")
        self.assertEqual((self.folder / "old.brep").read_text(), "old")
        self.assertEqual(sorted(os.listdir(self.folder)), ["folder.brep", "old.brep"])


class MergeTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.models = [self.copy(name) for name in ("wire.step", "smooth.igs", "wire.brep")]

    def audit(self, *arguments):
        return self.run_here("audit", *arguments, "--quiet")

    def parts(self):
        for number, model in enumerate(self.models):
            self.audit(model, "--json", f"{number}.json")
        return [f"{number}.json" for number in range(len(self.models))]

    def test_is_the_report_of_all(self):
        self.audit(*self.models, "--json", "all.json", "--csv", "all.csv")
        text = self.assert_fine(self.run_here("merge", *self.parts(), "--json", "m.json", "--csv",
                                              "m.csv"))
        for name in ("json", "csv"):
            self.assertEqual((self.folder / f"m.{name}").read_text(),
                             (self.folder / f"all.{name}").read_text())
        self.assertEqual(text, self.assert_fine(self.run_here("audit", *self.models)))

    def test_statuses(self):
        parts = self.parts()
        self.assert_status(self.run_here("merge", *parts, "--fail-below", "G2"), 1,
                           "6 of 10 joins are below G2")
        self.assert_fine(self.run_here("merge", "1.json", "--fail-below", "G2", "--quiet"))
        self.assert_status(self.run_here("merge", *parts, "--fail-below", "G5"), 2,
                           "make the reports with osculate audit --order 5")
        self.audit("none.step", "--json", "bad.json")
        self.assert_status(self.run_here("merge", *parts, "bad.json", "--fail-below", "G2"), 2,
                           "none.step: unreadable", "6 of 10")

    def test_a_file_in_two_reports(self):
        self.audit("none.step", "--json", "first.json")
        self.copy("wire.step", "none.step")
        self.audit("none.step", "--json", "second.json")
        result = self.run_here("merge", "first.json", "second.json")
        self.assert_status(result, 2, "second.json: the file none.step is in another report too")
        text = self.assert_fine(self.run_here("merge", "first.json", "second.json", "--latest"))
        self.assertIn("none.step: 4 edges, 3 joins", text)

    def test_a_report_that_lists_a_file_twice(self):
        self.audit("wire.step", "--json", "a.json")
        report = json.loads((self.folder / "a.json").read_text())
        report["files"] *= 2
        self.write("twice.json", json.dumps(report))
        self.assert_status(self.run_here("merge", "twice.json", "--latest"), 2,
                           "twice.json: no audit report", "it lists the file 'wire.step' twice")

    def test_strict(self):
        self.audit(self.copy("infinite.brep"), "--json", "a.json")
        said = "infinite.brep: 1 edge could not be analysed"
        self.assert_status(self.run_here("merge", "a.json"), 0, said)
        self.assert_status(self.run_here("merge", "a.json", "--strict"), 2, said)

    def test_other_options(self):
        self.audit("wire.step", "--json", "a.json")
        for options in (("--order", "2"), ("--pairs", "wire"), ("--gap-mm", "1"),
                        ("--touch-mm", "1")):
            self.audit("wire.brep", "--json", "b.json", *options)
            self.assert_status(self.run_here("merge", "a.json", "b.json"), 2,
                               "b.json was made with other options")

    def test_what_is_no_report(self):
        self.write("text.json", "{}")
        self.write("cut.json", '{"schema": "osculate.audit/1", "options": ')
        for name, message in (("text.json", "text.json: no audit report"),
                              ("cut.json", "cut.json: no audit report"),
                              ("none.json", "cannot read none.json")):
            self.assert_status(self.run_here("merge", name), 2, message)
        self.assert_status(self.run_here("merge"), 2, "reports is required")
        (self.folder / "folder").mkdir()
        self.assert_status(self.run_here("merge", "folder"), 2, "folder")

    def test_outputs(self):
        parts = self.parts()
        self.assert_status(self.run_here("merge", *parts, "--csv", "no/m.csv"), 2, "cannot write")
        report = json.loads(self.assert_fine(self.run_here("merge", *parts, "--json", "-")))
        self.assertEqual(report["summary"]["joins"], 10)
        self.assertEqual(self.assert_fine(self.run_here("merge", *parts, "--quiet")), "")
        text = self.assert_fine(self.run_here("merge", *parts, "--worst", "0"))
        self.assertNotIn("misses", text)


class HelpTest(unittest.TestCase):
    COMMANDS = ("analyze", "audit", "blend", "merge")

    def test_help(self):
        of_commands = [(command, "--help") for command in self.COMMANDS]
        for arguments in (("--help",), ("-h",), *of_commands):
            result = run(*arguments)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            self.assertIn("Examples:\n  osculate ", result.stdout)
            self.assertRegex(result.stdout, r"Usage: osculate")

    def test_examples_are_understood(self):
        """Every example of the help parses; none has an option that does not exist."""
        for command in self.COMMANDS:
            for line in re.findall(r"^  (osculate .*)$", run(command, "--help").stdout, re.M):
                words = line.split("|")[0].split(" || ")[0].split()
                self.assertEqual(words[1], command)
                known = run(command, "--help").stdout
                for word in words[2:]:
                    if word.startswith("-") and word != "-":
                        self.assertIn(word, known, line)

    def test_version(self):
        self.assertEqual(run("--version").stdout, f"osculate {os.environ['OSCULATE_VERSION']}\n")

    def test_no_or_an_unknown_command(self):
        for arguments in ((), ("paint",), ("--unknown",)):
            result = run(*arguments)
            self.assertEqual((result.returncode, result.stdout), (2, ""))
            self.assertNotEqual(result.stderr, "")

    def test_the_manual_page_has_every_option(self):
        with open(os.environ["OSCULATE_MANUAL"], encoding="utf-8") as file:
            page = file.read().replace("\\-", "-")
        for command in self.COMMANDS:
            self.assertIn(f'.SH "OSCULATE {command.upper()}"', page)
            options = re.findall(r"^  (?:-\w,)? *(--[a-z-]+)", run(command, "--help").stdout, re.M)
            self.assertGreater(len(options), 3)
            for option in options:
                self.assertIn(option, page)
        for line in re.findall(r"^  (osculate .*)$", run("audit", "--help").stdout, re.M):
            self.assertIn(line.replace("\\", "\\e"), page)

    @unittest.skipUnless(shutil.which("man"), "needs man")
    def test_the_manual_page_is_without_faults(self):
        result = subprocess.run(["man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z",
                                 os.environ["OSCULATE_MANUAL"]], capture_output=True, text=True,
                                env={**os.environ, "MANROFFSEQ": "", "MANWIDTH": "80"}, check=False)
        self.assertEqual((result.returncode, result.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()
