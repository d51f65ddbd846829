"""The recipes of docs/command-line.md, run as they stand there."""
import json
import os
import re
import shutil
import subprocess
import unittest
from pathlib import Path

from support import PROGRAM, ProgramTest

GUIDE = Path(__file__).parents[2] / "docs" / "command-line.md"


def recipe(name):
    """The block of shell that follows the mark <!-- recipe: name -->."""
    found = re.search(rf"<!-- recipe: {name} -->\n```sh\n(.*?)```", GUIDE.read_text("utf-8"), re.S)
    return found.group(1)


def is_gnu_parallel():
    if not shutil.which("parallel"):
        return False
    result = subprocess.run(["parallel", "--version"], capture_output=True, text=True, check=False)
    return "GNU parallel" in result.stdout


class RecipesTest(ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "models").mkdir()
        self.names = []
        for number in range(7):
            source = ("wire.step", "smooth.igs", "wire.brep")[number % 3]
            ending = os.path.splitext(source)[1]
            self.names.append(self.copy(source, f"models/part {number}{ending}"))
        self.names.append(self.write("models/broken.step", "nothing"))
        self.environment = {**os.environ,
                            "PATH": f"{os.path.dirname(PROGRAM)}:{os.environ['PATH']}",
                            "HOME": str(self.folder)}
        self.run_here("audit", *sorted(self.names), "--pairs", "tangent", "--json", "expected.json",
                      "--quiet")

    def shell(self, script, **variables):
        return subprocess.run(["sh", "-c", script], cwd=self.folder, capture_output=True, text=True,
                              env={**self.environment, **variables}, check=False, timeout=300)

    def assert_merged(self, result):
        """All files are in it; the broken one decides on the status."""
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn("broken.step: unreadable", result.stderr)
        merged = json.loads((self.folder / "all.json").read_text())
        expected = json.loads((self.folder / "expected.json").read_text())
        self.assertEqual(merged["summary"], expected["summary"])
        self.assertEqual(sorted(entry["file"] for entry in merged["files"]), sorted(self.names))
        self.assertEqual(len((self.folder / "all.csv").read_text().splitlines()),
                         1 + expected["summary"]["joins"])

    @unittest.skipUnless(is_gnu_parallel(), "needs GNU parallel")
    def test_gnu_parallel(self):
        script = recipe("parallel")
        self.assertIn("-N 50", script)
        self.assert_merged(self.shell(script.replace("-N 50", "-N 3")))
        parts = [name for name in os.listdir(self.folder) if name.startswith("part-")]
        self.assertEqual(len(parts), 3)

    def test_slurm_array(self):
        """Each task as Slurm would start it: in the folder, told by variables which it is."""
        script = recipe("slurm")
        self.write("files.txt", "\n".join(sorted(self.names)) + "\n")
        for task in range(3):
            result = self.shell(script, SLURM_ARRAY_TASK_ID=str(task), SLURM_ARRAY_TASK_MAX="2",
                                SLURM_CPUS_PER_TASK="2")
            self.assertEqual(result.returncode, 0, result.stderr)
        self.assert_merged(self.shell("osculate merge part-*.json --json all.json --csv all.csv "
                                      "--fail-below G2"))


if __name__ == "__main__":
    unittest.main()
