"""What the tests of the program share: running it, models, a folder of their own."""
import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

PROGRAM = os.environ["OSCULATE_PROGRAM"]
MODELS = Path(__file__).parents[1] / "data" / "models"
SHARED = Path(os.environ.get("OSCULATE_SHARED_DIR", Path(__file__).parents[3] / "shared"))

#: What the models hold: edges, joins, and how many joins of each order.
WIRE = {"gap": 0, "G0": 1, "G1": 2, "G2": 0, "G3": 0, "G4": 0}


def run(*arguments, timeout=120, **options):
    """The finished process, with its standard output and error as text."""
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True,
                          timeout=timeout, check=False, **options)


def shared_file(name):
    path = SHARED / name
    if not path.exists():
        raise unittest.SkipTest(f"no reference data {name} beside the checkout")
    return path


class ProgramTest(unittest.TestCase):
    """A test with a folder of its own, in which the program runs."""

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def run_here(self, *arguments, **options):
        return run(*arguments, cwd=self.folder, **options)

    def copy(self, name, new_name=None):
        """A model in the test's folder, as a name without a path."""
        shutil.copy(MODELS / name, self.folder / (new_name or name))
        return new_name or name

    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return name

    def assert_fine(self, result):
        self.assertEqual((result.returncode, result.stderr), (0, ""), result.stdout)
        return result.stdout

    def assert_status(self, result, status, *fragments):
        """The status, and what standard error says."""
        self.assertEqual(result.returncode, status, result.stderr)
        for fragment in fragments:
            self.assertIn(fragment, result.stderr)
        return result
