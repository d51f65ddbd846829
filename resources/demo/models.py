"""Curves to analyse that every FreeCAD on Debian has: our sample, an electronic part, a font."""
from pathlib import Path

import FreeCAD
import Part

SAMPLE = Path(__file__).resolve().parents[1] / "samples" / "continuity_g0_to_g4.FCStd"
PARTS = Path(FreeCAD.getResourceDir(), "Mod", "Idf", "Idflibs")
FONT = Path("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf")


def add_sample(document):
    """The curves of the sample as objects G0a, G0b, ... G4b; returns the pairs."""
    source = FreeCAD.openDocument(str(SAMPLE), True)
    shapes = {name: source.getObject(name).Shape.copy()
              for order in range(5) for name in (f"G{order}a", f"G{order}b")}
    FreeCAD.closeDocument(source.Name)
    features = {name: add(document, name, shape) for name, shape in shapes.items()}
    return [(features[f"G{order}a"], features[f"G{order}b"]) for order in range(5)]


def add_part(document, name, position):
    """One of the STEP models of FreeCAD's Idf module: lines, arcs and B-splines that meet."""
    shape = Part.read(str(PARTS / name))
    feature = add(document, Path(name).stem, shape)
    feature.Placement.Base = position
    return feature


def add_text(document, text, height_mm, position):
    """The outline of a text: lines and quadratic B-splines."""
    glyphs = Part.makeWireString(text, f"{FONT.parent}/", FONT.name, height_mm, 0)
    wires = [wire for glyph in glyphs for wire in glyph]
    feature = add(document, "Outline", Part.makeCompound(wires))
    feature.Placement.Base = position
    return feature


def add(document, name, shape):
    """A Part::Feature with a shape."""
    feature = document.addObject("Part::Feature", name)
    feature.Shape = shape
    return feature


def keep_no_backups():
    """A demo that is run again leaves no joins.FCStd1 behind."""
    FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Document").SetBool(
        "CreateBackupFiles", False)
