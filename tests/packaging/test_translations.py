"""The translations of the workbench are whole."""
import re
import unittest
import xml.etree.ElementTree as tree
from pathlib import Path

FOLDER = Path(__file__).resolve().parents[2] / "resources" / "translations"
FIELD = re.compile(r"\{[^}]*\}")


def messages(path):
    """(source, translation element) of a .ts file."""
    for message in tree.parse(path).iter("message"):
        yield message.findtext("source"), message.find("translation")


class TranslationsTest(unittest.TestCase):
    def test_every_text_is_translated(self):
        for path in sorted(FOLDER.glob("*.ts")):
            missing = [source for source, translation in messages(path)
                       if translation.get("type") == "unfinished" or not translation.text]
            self.assertEqual(missing, [], f"{path.name}: run resources/translations/update, "
                                          "then translate these")

    def test_translations_have_the_fields_of_their_sources(self):
        for path in sorted(FOLDER.glob("*.ts")):
            for source, translation in messages(path):
                self.assertEqual(sorted(FIELD.findall(source)),
                                 sorted(FIELD.findall(translation.text or "")), source)

    def test_every_language_is_compiled(self):
        languages = [path.stem for path in sorted(FOLDER.glob("*.ts"))]
        self.assertTrue(languages)
        self.assertEqual([path.stem for path in sorted(FOLDER.glob("*.qm"))], languages)


if __name__ == "__main__":
    unittest.main()
