"""The installed add-on folder is complete, holds nothing else, and works where it lies."""
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ADDON = Path(os.environ["OSCULATE_ADDON"])
VERSION = os.environ["OSCULATE_VERSION"]
TOP_LEVEL = {"CHANGELOG.md", "Init.py", "InitGui.py", "LICENSE", "README.md", "package.xml",
             "resources", "workbench"}
SCRIPT = """
import os, sys
try:
    import osculate
    print("version", osculate.__version__, "at", osculate.__file__)
    sys.stdout.flush()
    os._exit(0)
except BaseException as error:
    print(repr(error))
    sys.stdout.flush()
    os._exit(1)
"""


def run(command, **environment):
    result = subprocess.run(command, env={**os.environ, **environment}, stdin=subprocess.DEVNULL,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                            timeout=120)
    return result.returncode, result.stdout


class AddonTest(unittest.TestCase):
    def test_top_level_is_what_freecad_needs(self):
        self.assertEqual({path.name for path in ADDON.iterdir()}, TOP_LEVEL)

    def test_holds_nothing_of_the_build(self):
        unwanted = [path for path in ADDON.rglob("*")
                    if path.name == "__pycache__" or path.name.startswith("test_")
                    or path.suffix in {".pyc", ".txt", ".cpp", ".h", ".a"}]
        self.assertEqual(unwanted, [])

    def test_imports_in_plain_python(self):
        code, output = run([sys.executable, "-B", "-c", SCRIPT],
                           PYTHONPATH=str(ADDON / "workbench"))
        self.assertEqual(code, 0, output)
        self.assertIn(f"version {VERSION} at {ADDON}", output)

    def test_imports_in_freecad_from_its_mod_folder(self):
        with tempfile.TemporaryDirectory() as home:
            mod = Path(home, "Mod")
            mod.mkdir()
            (mod / "Osculate").symlink_to(ADDON)
            script = Path(home, "import_osculate.py")
            script.write_text(SCRIPT)
            code, output = run(["freecadcmd", str(script)], FREECAD_USER_HOME=home,
                               PYTHONDONTWRITEBYTECODE="1")
        self.assertEqual(code, 0, output)
        self.assertIn(f"version {VERSION} at ", output)


if __name__ == "__main__":
    unittest.main()
