"""Real models for the audits: as shapes, by name."""
from support import FreeCAD, Part, shared_file


def model(name):
    path = shared_file(f"data/{name}")
    if path.suffix != ".fcstd":
        return Part.read(str(path))
    document = FreeCAD.openDocument(str(path), True)
    try:
        return Part.makeCompound([item.Shape for item in document.Objects
                                  if hasattr(item, "Shape")])
    finally:
        FreeCAD.closeDocument(document.Name)


def rows_of(report, kind):
    return [row for row in report.rows if row.kind == kind]
