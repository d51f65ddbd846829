"""Draws the pictures of what is drawn along edges, beside this file.

    tests/gui/on_screen docs/images/make_overlay_pictures.py
"""

import os
import sys

import FreeCAD
import FreeCADGui
import Part

from osculate.features import make_control_polygons

FOLDER = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, FOLDER)
from pictures import V, arc, grab, ink, look, pump, run  # noqa: E402  FreeCAD does not look there


def main():
    draw_polygons()


def draw_polygons():
    """polygons.png: control polygons of a B-spline and of an arc, with weights and differences."""
    document = FreeCAD.newDocument("Polygons")
    spline = Part.BSplineCurve()
    spline.buildFromPolesMultsKnots(
        [V(0, 0, 0), V(20, 40, 0), V(60, 45, 0), V(70, 0, 0), V(105, -15, 0), V(125, 30, 0)],
        [4, 1, 1, 4], [0, 1, 2, 3], False, 3)
    for name, curve in (("Spline", spline), ("Arc", arc(V(160, 20, 0), 30, -130, 60))):
        document.addObject("Part::Feature", name).Shape = curve.toShape()
    document.recompute()
    ink(document)
    polygons = make_control_polygons(document, document.Objects, weights=True,
                                     second_differences=True, difference_scale="derivatives")
    polygons.ViewObject.doubleClicked()
    pump()
    look(document, "viewTop", 1.0)
    grab("polygons")
    FreeCADGui.Control.closeDialog()
    FreeCAD.closeDocument(document.Name)


run(main)
