"""A document for the tests of Bézier solids."""

import FreeCAD

from osculate.features import make_bezier_solid
from osculate.features.selftest.feature_case import FeatureCase


class SolidCase(FeatureCase):
    """An empty document."""

    def setUp(self):
        self.doc = FreeCAD.newDocument("OsculateSolids")

    def solid(self, value, **options):
        return make_bezier_solid(self.doc, value, **options)

    def set_row(self, obj, name, row, number):
        """Changes one entry of a list property and recomputes."""
        rows = list(getattr(obj, name))
        rows[row] = number
        setattr(obj, name, rows)
        self.doc.recompute()

    def part_at(self, x, angle, *objects):
        """An App::Part that is moved along x and turned about z, with some objects."""
        part = self.doc.addObject("App::Part", "Part")
        part.Placement = FreeCAD.Placement(FreeCAD.Vector(x, 0, 0),
                                           FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), angle))
        for obj in objects:
            part.addObject(obj)
        return part
