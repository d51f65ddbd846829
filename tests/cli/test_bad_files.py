"""Files that are damaged, cut, empty, no models; readers that crash or hang."""
import json
import os
import random
import signal
import subprocess
import time
import unittest
from pathlib import Path

from support import MODELS, PROGRAM, ProgramTest, shared_file

#: OpenCASCADE 7.6 breaks down at the trimmed curve (8) whose basis is of an unknown kind (99).
CRASHING = """DBRep_DrawableShape

CASCADE Topology V1, (c) Matra-Datavision
Locations 0
Curve2ds 0
Curves 1
8 0 1
99
"""


def children_of(process):
    """Process ids of the children, from the kernel."""
    path = Path(f"/proc/{process.pid}/task/{process.pid}/children")
    return [int(number) for number in path.read_text().split()]


def is_running(process):
    """Whether it has not ended; one that has may wait for the first process to take notice."""
    try:
        with open(f"/proc/{process}/stat", encoding="ascii", errors="replace") as file:
            return file.read().rpartition(")")[2].split()[0] != "Z"
    except FileNotFoundError:
        return False


class BadFilesTest(ProgramTest):
    def audit_one(self, name, *fragments, status="unreadable"):
        """The file fails with these words; a good file beside it is audited."""
        good = self.copy("wire.step", "good.step")
        result = self.run_here("audit", name, good, "--json", "-")
        self.assert_status(result, 2, f"osculate: {name}: {status}: ", *fragments)
        report = json.loads(result.stdout)
        self.assertEqual([entry["status"] for entry in report["files"]], [status, "audited"])
        self.assertEqual(report["summary"]["joins"], 3)

    def test_missing(self):
        self.audit_one("none.step", "No such file or directory")

    def test_a_folder(self):
        (self.folder / "parts").mkdir()
        self.audit_one("parts", "is a folder; give a STEP, IGES or BREP file")

    def test_empty(self):
        for ending in ("step", "igs", "brep"):
            self.audit_one(self.write(f"empty.{ending}", ""), "is empty")

    def test_other_content(self):
        for name, content in (("text.step", "solid cube\n" * 50), ("line.brep", "\n"),
                              ("bytes.igs", bytes(range(256)) * 20)):
            self.audit_one(self.write(name, content), "is no STEP, IGES or BREP file")

    @unittest.skipIf(os.geteuid() == 0, "root may read everything")
    def test_without_permission(self):
        name = self.copy("wire.step", "locked.step")
        os.chmod(self.folder / name, 0)
        self.audit_one(name, "Permission denied")

    def test_cut_off_anywhere(self):
        for name in ("wire.step", "wire.igs", "wire.brep"):
            whole = (MODELS / name).read_bytes().rstrip()
            for share in (0.02, 0.3, 0.6, 0.95):
                with self.subTest(name, share=share):
                    cut = self.write(f"cut-{name}", whole[:int(share * len(whole))])
                    result = self.run_here("audit", cut)
                    self.assertEqual(result.returncode, 2, result.stdout)
                    self.assertRegex(result.stderr,
                                     "^osculate: cut-.*: (unreadable|crashed): .+\n$")

    def test_a_step_file_without_a_shape(self):
        text = (MODELS / "wire.step").read_text()
        head, tail = text[:text.index("#1 =")], text[text.index("ENDSEC;\nEND-ISO"):]
        self.audit_one(self.write("none.stp", head + tail), "")

    def test_an_entity_that_is_missing(self):
        lines = (MODELS / "wire.step").read_text().split(";\n")
        text = ";\n".join(line for line in lines if not line.startswith("#17 = LINE"))
        result = self.run_here("audit", self.write("part.step", text), "--json", "-")
        report = json.loads(result.stdout)
        self.assertTrue(report["files"][0]["notes"] or result.returncode == 2, report)
        strict = self.run_here("audit", "part.step", "--strict", "--quiet")
        self.assert_status(strict, 2, "osculate: part.step: ")

    def test_random_damage_never_ends_the_batch(self):
        generator = random.Random(7)
        names = []
        for name in ("wire.step", "wire.igs", "wire.brep", "smooth.step", "smooth.igs"):
            whole = (MODELS / name).read_bytes()
            for number in range(6):
                damaged = bytearray(whole)
                for _ in range(generator.choice([1, 5, 30])):
                    damaged[generator.randrange(len(damaged))] = generator.randrange(32, 127)
                names.append(self.write(f"{number}-{name}", bytes(damaged)))
        good = self.copy("wire.step")
        result = self.run_here("audit", *names, good, "--json", "-", "--time-limit", "20")
        self.assertIn(result.returncode, (0, 2))
        report = json.loads(result.stdout)
        self.assertEqual([entry["file"] for entry in report["files"]], [*names, good])
        self.assertEqual(report["files"][-1]["summary"]["joins"], 3)

    def test_damaged_real_models(self):
        generator = random.Random(8)
        for source in ("data/NIST_MBE_PMI_4.stp", "data/Propeller.brep"):
            whole = bytearray(shared_file(source).read_bytes())
            digits = [i for i, byte in enumerate(whole) if 48 <= byte <= 57]
            for place in generator.sample(digits, 20):
                whole[place] = generator.randrange(48, 58)
            name = self.write("damaged" + os.path.splitext(source)[1], bytes(whole))
            result = self.run_here("audit", name, self.copy("wire.step"), "--json", "-",
                                   "--time-limit", "60")
            self.assertEqual(json.loads(result.stdout)["files"][1]["status"], "audited")


class ContainmentTest(ProgramTest):
    def setUp(self):
        super().setUp()
        os.mkfifo(self.folder / "stuck.step")  # opening it waits for a writer that never comes

    def start(self, *arguments):
        process = subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def child_of(self, process):
        deadline = time.monotonic() + 30
        while time.monotonic() < deadline:
            children = children_of(process)
            if children:
                return children[0]
            time.sleep(0.01)
        return self.fail("the program started no child process")

    def test_a_reader_that_hangs(self):
        good = self.copy("wire.step")
        start = time.monotonic()
        result = self.run_here("audit", "stuck.step", good, "--time-limit", "1", "--json", "-")
        self.assertLess(time.monotonic() - start, 30)
        self.assert_status(result, 2, "osculate: stuck.step: timed-out: took longer than 1 s\n")
        report = json.loads(result.stdout)
        self.assertEqual([entry["status"] for entry in report["files"]], ["timed-out", "audited"])

    def test_a_reader_that_crashes(self):
        for number, name in ((signal.SIGSEGV, "Segmentation fault"), (signal.SIGKILL, "Killed")):
            process = self.start("audit", "stuck.step", self.copy("wire.step"), "--jobs", "1",
                                 "--json", "-")
            os.kill(self.child_of(process), number)
            output, errors = process.communicate(timeout=60)
            self.assertEqual(process.returncode, 2)
            self.assertIn(f"osculate: stuck.step: crashed: OpenCASCADE broke down: signal {number} "
                          f"({name})\n", errors)
            report = json.loads(output)
            self.assertEqual([e["status"] for e in report["files"]], ["crashed", "audited"])

    def test_a_file_at_which_opencascade_crashes(self):
        """It does in 7.6; later versions may refuse the file instead."""
        name = self.write("crash.brep", CRASHING)
        result = self.run_here("audit", name, self.copy("wire.step"), "--json", "-")
        self.assert_status(result, 2, "osculate: crash.brep: ")
        first, second = json.loads(result.stdout)["files"]
        self.assertIn(first["status"], ("crashed", "unreadable"))
        self.assertEqual(second["status"], "audited")

    def test_analyze_and_blend_survive_too(self):
        name = self.write("crash.brep", CRASHING)
        for command in (("analyze", name, "--edges", "1", "2"),
                        ("blend", name, "--edges", "1", "2", "-o", "out.step")):
            result = self.run_here(*command)
            self.assert_status(result, 2, "osculate: ")
            self.assertEqual(result.stdout, "")
        for command in (("analyze", "stuck.step", "--edges", "1", "2"),
                        ("blend", "stuck.step", "--edges", "1", "2", "-o", "out.step")):
            result = self.run_here(*command, "--time-limit", "0.5")
            self.assert_status(result, 2, "osculate: stuck.step took longer than 0.5 s\n")
        process = self.start("analyze", "stuck.step", "--edges", "1", "2")
        os.kill(self.child_of(process), signal.SIGABRT)
        _, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 2)
        self.assertIn("stuck.step made OpenCASCADE break down: signal 6 (Aborted)", errors)
        self.assertFalse((self.folder / "out.step").exists())

    def test_no_children_are_left_behind(self):
        process = self.start("audit", "stuck.step")
        child = self.child_of(process)
        process.kill()
        process.wait(timeout=30)
        deadline = time.monotonic() + 30
        while is_running(child) and time.monotonic() < deadline:
            time.sleep(0.01)
        self.assertFalse(is_running(child))

    def test_no_core_files(self):
        name = self.write("crash.brep", CRASHING)
        self.run_here("audit", name)
        self.assertEqual(sorted(os.listdir(self.folder)), ["crash.brep", "stuck.step"])


if __name__ == "__main__":
    unittest.main()
