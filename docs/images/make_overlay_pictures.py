"""Draws the pictures of what is drawn along edges, beside this file.

    tests/gui/on_screen docs/images/make_overlay_pictures.py
"""

import os
import sys

import FreeCAD
import Part

from osculate.features import make_control_polygons, make_probe

FOLDER = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, FOLDER)
from pictures import (  # noqa: E402  FreeCAD does not look beside a script
    DARK, LIGHT, V, arc, grab_edited, ink, look, run, save_view, set_background)


def main():
    draw_polygons()
    draw_probe()
    draw_construction()


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
    grab_edited(polygons, "viewTop", 1.0, "polygons")


def draw_probe():
    """probe.png: frame, circle and planes on a curve in space, and the panel."""
    document = FreeCAD.newDocument("Probe")
    curve = Part.BSplineCurve()
    curve.interpolate([V(70, 0, 0), V(0, 60, 15), V(-60, 0, 45), V(0, -70, 60), V(90, 10, 80),
                       V(60, 120, 60)])
    document.addObject("Part::Feature", "Curve").Shape = curve.toShape()
    document.recompute()
    ink(document)
    probe = make_probe(document, document.Objects, position=0.3, parts=[
        "frame", "circle", "osculating plane", "normal plane", "read-out", "marks", "legend"])
    grab_edited(probe, "viewIsometric", 1.0, "probe")


def draw_construction():
    """construction.png: the construction of de Casteljau at t = 1/3 of a quartic, on dark."""
    document = FreeCAD.newDocument("Construction")
    curve = Part.BezierCurve()
    curve.setPoles([V(0, 0, 0), V(10, 60, 0), V(70, 90, 0), V(130, 55, 0), V(120, -10, 0)])
    document.addObject("Part::Feature", "Quartic").Shape = curve.toShape()
    document.recompute()
    document.Quartic.ViewObject.LineWidth = 3.0
    document.Quartic.ViewObject.LineColor = (0.85, 0.88, 0.92)
    set_background(DARK)
    probe = make_probe(document, [document.Quartic], parts=["de Casteljau", "legend"])
    path = probe.Proxy.probe
    probe.Position = path.arc_length_of(0, 1 / 3) / path.length
    document.recompute()
    look(document, "viewTop", 0.8)
    save_view(document, "construction", 900, 560)
    set_background(LIGHT)
    FreeCAD.closeDocument(document.Name)


run(main)
