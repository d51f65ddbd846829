"""Importing osculate: what to do when the compiled module is missing, foreign or broken."""
import shutil
import subprocess
import sysconfig
import tempfile
import unittest
from pathlib import Path

import osculate
from support import PYTHON

PACKAGE = Path(osculate.__file__).parent


class ImportTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.package = Path(folder.name) / "osculate"
        shutil.copytree(PACKAGE, self.package,
                        ignore=shutil.ignore_patterns("_core*", "__pycache__", "gui", "features"))

    def import_error(self):
        """The last line of what importing the copy prints."""
        result = subprocess.run(
            [PYTHON, "-B", "-c", "import osculate"], capture_output=True, text=True, timeout=60,
            cwd=self.package.parent, env={"PYTHONPATH": str(self.package.parent)})
        self.assertEqual(result.returncode, 1, result.stderr)
        return result.stderr.splitlines()[-1]

    def test_not_compiled(self):
        message = self.import_error()
        self.assertRegex(message, "^ImportError: osculate is not compiled yet; run `make build`")

    def test_compiled_for_another_python(self):
        (self.package / "_core.cpython-34m-x86_64-linux-gnu.so").touch()
        message = self.import_error()
        self.assertIn("compiled for another Python (_core.cpython-34m-", message)
        self.assertIn("make build", message)

    def test_does_not_load(self):
        (self.package / ("_core" + sysconfig.get_config_var("EXT_SUFFIX"))).write_text("nonsense")
        message = self.import_error()
        self.assertIn("does not load", message)
        self.assertIn("make build", message)

    def test_plain_python_needs_neither_freecad_nor_qt(self):
        code = ("import sys, osculate; "
                "sys.exit(any(m in sys.modules for m in ('FreeCAD', 'Part', 'PySide', 'PySide2')))")
        result = subprocess.run([PYTHON, "-c", code], timeout=60,
                                env={"PYTHONPATH": str(PACKAGE.parent)})
        self.assertEqual(result.returncode, 0)

    def test_version(self):
        self.assertRegex(osculate.__version__, r"^\d+\.\d+\.\d+$")

    def test_classes_are_named_by_the_package(self):
        for name in osculate.__all__:
            thing = getattr(osculate, name)
            if isinstance(thing, type) and thing.__module__ == "osculate":
                self.assertIs(getattr(osculate, thing.__qualname__), thing)
        self.assertEqual(osculate.Curve.__module__, "osculate")

    def test_public_names_exist_once(self):
        for name in osculate.__all__:
            self.assertTrue(hasattr(osculate, name), name)
        self.assertEqual(sorted(set(osculate.__all__)), osculate.__all__)


if __name__ == "__main__":
    unittest.main()
