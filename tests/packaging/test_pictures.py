"""The pictures of the documentation: each is drawn by a script and shown; links lead somewhere."""
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parents[2]
IMAGES = ROOT / "docs" / "images"
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md"))]

sys.path.insert(0, str(IMAGES))
import make_gallery  # noqa: E402  it lies beside the pictures


def links(page, mark=""):
    """The targets of links, or with mark "!" of pictures, that are no addresses of the web."""
    text = re.sub(r"```.*?```", "", page.read_text("utf-8"), flags=re.S)
    found = re.findall(rf"{mark}\[[^\]]*\]\(([^)\s]+)\)", text)
    return [target for target in found if not re.match(r"\w+://|mailto:", target)]


def anchors(page):
    """What GitHub makes of the headings of a page."""
    headings = re.findall(r"^#+ (.+)$", page.read_text("utf-8"), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def pictures_on(page):
    return {(page.parent / target).resolve() for target in links(page, "!")}


class PicturesTest(unittest.TestCase):
    def setUp(self):
        self.there = set(IMAGES.glob("*.png"))

    def test_every_picture_is_in_the_gallery(self):
        self.assertGreater(len(self.there), 20)
        self.assertEqual(pictures_on(ROOT / "docs" / "gallery.md"), self.there)

    def test_every_picture_shown_is_there(self):
        for page in PAGES:
            self.assertLessEqual(pictures_on(page), self.there, page.name)

    def test_every_picture_is_drawn_by_one_script(self):
        drawn = [IMAGES / f"{name}.png" for names in make_gallery.scripts().values()
                 for name in names]
        self.assertEqual(sorted(drawn), sorted(self.there))

    def test_every_function_that_draws_says_what(self):
        for script, names in make_gallery.scripts().items():
            text = script.read_text("utf-8")
            for call in re.findall(r'(?:grab|save_view)\((?:document, )?"(\w+)"', text):
                self.assertIn(call, names, script.name)

    def test_a_picture_that_nothing_draws(self):
        script = IMAGES / "make_gallery.py"
        found = subprocess.run([sys.executable, "-B", script, "page", "nonsense"],
                               capture_output=True, text=True)
        self.assertEqual((found.returncode, found.stderr), (2, "no script draws: nonsense\n"))


@unittest.skipUnless(shutil.which("compare"), "needs ImageMagick")
class GalleryTest(unittest.TestCase):
    """make_gallery with a folder and a program of its own in place of FreeCAD."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.program = self.folder / "on_screen"
        for name, value in (("FOLDER", self.folder), ("ON_SCREEN", self.program),
                            ("print", lambda *_, **__: None)):
            patch = mock.patch.object(make_gallery, name, value, create=name == "print")
            patch.start()
            self.addCleanup(patch.stop)
        self.picture = self.folder / "a.png"
        (self.folder / "make_pictures.py").write_text('def f():\n    """a.png: a picture."""\n')

    def run_with(self, command):
        self.program.write_text(f"#!/bin/sh\ncd {self.folder}\n{command}\n")
        self.program.chmod(0o755)
        return make_gallery.main(set())

    def test_a_new_picture(self):
        self.assertEqual(self.run_with("convert -size 50x50 xc:red a.png"), 0)
        self.assertTrue(self.picture.exists())

    def test_a_picture_that_looks_the_same_keeps_its_bytes(self):
        self.run_with("convert -size 50x50 xc:red a.png")
        old = self.picture.read_bytes()
        same = "convert -size 50x50 xc:red -fill blue -draw 'rectangle 3,3 4,9' -comment x a.png"
        self.assertEqual(self.run_with(same), 0)
        self.assertEqual(self.picture.read_bytes(), old)

    def test_a_picture_that_changed(self):
        self.run_with("convert -size 50x50 xc:red a.png")
        old = self.picture.read_bytes()
        for changed in ("convert -size 50x50 xc:red -fill blue -draw 'rectangle 3,3 9,9' a.png",
                        "convert -size 50x60 xc:red a.png"):
            self.assertEqual(self.run_with(changed), 0)
            self.assertNotEqual(self.picture.read_bytes(), old)

    def test_a_script_that_fails(self):
        self.run_with("convert -size 50x50 xc:red a.png")
        old = self.picture.read_bytes()
        self.assertEqual(self.run_with("exit 3"), 3)
        self.assertEqual(self.run_with("true"), 1)
        self.assertEqual(self.picture.read_bytes(), old)


class LinksTest(unittest.TestCase):
    def test_every_link_leads_to_a_file_and_a_heading(self):
        for page in PAGES:
            for target in links(page):
                path, _, anchor = target.partition("#")
                goal = (page.parent / path).resolve() if path else page
                self.assertTrue(goal.exists(), f"{page.name}: {target}")
                if anchor:
                    self.assertIn(anchor, anchors(goal), f"{page.name}: {target}")


if __name__ == "__main__":
    unittest.main()
