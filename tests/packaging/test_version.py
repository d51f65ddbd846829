"""The version stands once, in project() of CMakeLists.txt; all that repeats it must agree."""
import os
import re
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
VERSION = os.environ["OSCULATE_VERSION"]
NAMESPACE = {"package": "https://wiki.freecad.org/Package_Metadata"}


class VersionTest(unittest.TestCase):
    def test_package_xml_agrees(self):
        metadata = ElementTree.parse(ROOT / "package.xml").getroot()
        self.assertEqual(metadata.findtext("package:version", namespaces=NAMESPACE), VERSION)

    def test_changelog_begins_with_it(self):
        headings = re.findall(r"^## (\S+)", (ROOT / "CHANGELOG.md").read_text(), re.MULTILINE)
        self.assertEqual(headings[0], VERSION)


if __name__ == "__main__":
    unittest.main()
