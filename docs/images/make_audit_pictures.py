"""Draws the pictures of the audit of a model beside this file.

    tests/gui/on_screen docs/images/make_audit_pictures.py
"""

import os
import sys

import FreeCAD
import FreeCADGui
import Part

from osculate.features import make_audit

FOLDER = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, FOLDER)
from pictures import (  # noqa: E402  FreeCAD does not look beside a script
    V, find_form, grab, look, pump, run)
from osculate.gui.audit.audit_form import AuditForm  # noqa: E402
from osculate.gui.construct.match_form import MatchForm  # noqa: E402


def main():
    draw_audit()
    draw_fix()


def draw_audit():
    """audit.png: all joins of a turned body, those that are not G2 numbered, and the panel."""
    document = FreeCAD.newDocument("Vase")
    body = document.addObject("Part::Feature", "Vase")
    body.Shape = vase()
    body.ViewObject.ShapeColor = (0.78, 0.83, 0.88)
    document.recompute()
    audit = make_audit(document, [body], required=2)
    audit.ViewObject.doubleClicked()
    pump()
    look(document, "viewIsometric", 1.0)
    find_form(AuditForm).zoom.setChecked(False)
    find_form(AuditForm).table.selectRow(0)
    FreeCADGui.Selection.clearSelection()  # its green would hide the colours
    grab("audit")
    FreeCADGui.Control.closeDialog()
    FreeCAD.closeDocument(document.Name)


def draw_fix():
    """audit_fix.png: Match, opened from a row: what it changes, before it is done."""
    document = FreeCAD.newDocument("Curves")
    spline = Part.BSplineCurve()
    spline.interpolate([V(60, 0, 0), V(90, 12, 0), V(120, 40, 0), V(150, 45, 0), V(180, 30, 0)])
    for name, curve in (("Line", Part.LineSegment(V(0, 4, 0), V(60, 0, 0))), ("Spline", spline)):
        document.addObject("Part::Feature", name).Shape = curve.toShape()
    document.recompute()
    for obj in document.Objects:
        obj.ViewObject.LineWidth = 3.0
    audit = make_audit(document, document.Objects, required=2, corner_deg=60.0)
    audit.ViewObject.doubleClicked()
    pump()
    form = find_form(AuditForm)
    form.zoom.setChecked(False)
    form.table.selectRow(0)
    pump()
    form.match.click()
    pump(1.0)
    find_form(MatchForm)
    look(document, "viewTop", 1.0)
    grab("audit_fix")
    FreeCADGui.Control.closeDialog()
    pump()
    FreeCADGui.Control.closeDialog()
    FreeCAD.closeDocument(document.Name)


def vase():
    """A profile of lines, arcs and a spline with a slight kink, turned by three quarters."""
    neck = Part.BSplineCurve()
    neck.interpolate([V(33, 0, 38), V(30, 0, 55), V(17, 0, 80), V(16, 0, 96), V(22, 0, 110)],
                     InitialTangent=V(0.05, 0, 1), FinalTangent=V(1, 0, 1.2))
    inward = 5.0 * (1.0 - 0.5 ** 0.5)
    foot = Part.Arc(V(28, 0, 0), V(33 - inward, 0, inward), V(33, 0, 5)).toShape()
    profile = Part.Wire([Part.LineSegment(V(0, 0, 0), V(28, 0, 0)).toShape(), foot,
                         Part.LineSegment(V(33, 0, 5), V(33, 0, 38)).toShape(), neck.toShape()])
    return profile.revolve(V(0, 0, 0), V(0, 0, 1), 270)


run(main)
