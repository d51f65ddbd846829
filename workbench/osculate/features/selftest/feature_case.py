"""A document with two edges, for the tests of document objects."""

import math
import os
import tempfile
import unittest

import FreeCAD
import Part

V = FreeCAD.Vector


class FeatureCase(unittest.TestCase):
    """A line and a quarter of a circle of radius 20 that touches it: G1, misses G2."""

    def setUp(self):
        self.doc = FreeCAD.newDocument("OsculateSelftest")
        self.line = self.add("Line", Part.LineSegment(V(0, 0, 0), V(50, 0, 0)).toShape())
        circle = Part.Circle(V(50, 20, 0), V(0, 0, 1), 20)
        self.arc = self.add("Arc", Part.ArcOfCircle(circle, -math.pi / 2, 0).toShape())
        self.doc.recompute()

    def tearDown(self):
        FreeCAD.closeDocument(self.doc.Name)

    def add(self, name, shape):
        obj = self.doc.addObject("Part::Feature", name)
        obj.Shape = shape
        return obj

    def save_and_load(self):
        """The document goes through a file; returns it."""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "test.FCStd")
            self.doc.saveAs(path)
            FreeCAD.closeDocument(self.doc.Name)
            self.doc = FreeCAD.openDocument(path)
        return self.doc
