"""Draws the pictures of Bézier solids beside this file.

    tests/gui/on_screen docs/images/make_solid_pictures.py
"""

import os
import sys

import FreeCAD
import FreeCADGui

from osculate import BezierTetrahedron, solids
from osculate.features import make_bezier_solid, make_solid_contact
from osculate.gui.solid_panel.primitive_form import PrimitiveForm

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from pictures import (  # noqa: E402  FreeCAD does not look beside a script
    DARK, LIGHT, find_form, grab, look, pump, run, save_view, set_background)


def main():
    draw_kinds()
    draw_solid()
    draw_jacobian()
    draw_contact()


def draw_kinds():
    """solid_kinds.png: the panel that makes solids, a spherical wedge."""
    document = FreeCAD.newDocument("Kinds")
    FreeCADGui.runCommand("Osculate_BezierSolid")
    pump()
    form = find_form(PrimitiveForm)
    form.kind_box.setCurrentIndex(form.kind_box.findData("sphere-wedge"))
    form.kind_box.activated.emit(form.kind_box.currentIndex())
    look(document, "viewIsometric")
    grab("solid_kinds")
    FreeCADGui.Control.closeDialog()
    FreeCAD.closeDocument(document.Name)


def draw_solid():
    """solid.png: an octant of a ball with its net and slices, and the panel that edits it."""
    document = FreeCAD.newDocument("Solids")
    octant = make_bezier_solid(document, solids.ball_octant(50.0), name="Octant")
    octant.ViewObject.ShowSlices = True
    octant.ViewObject.Slices = 4
    octant.ViewObject.doubleClicked()
    pump()
    look(document, "viewIsometric")
    grab("solid")
    FreeCADGui.Control.closeDialog()
    FreeCAD.closeDocument(document.Name)


def draw_jacobian():
    """jacobian.png: a solid that folds over itself, in the colours of its Jacobian, on dark."""
    document = FreeCAD.newDocument("Fold")
    value = solids.random(3, 1)
    points = value.points
    points[-1] = 0.9 * points[0] + 0.1 * points[10]  # a corner is pushed through the solid
    folded = make_bezier_solid(document, BezierTetrahedron(3, points, value.weights), name="Folded")
    folded.ViewObject.ColorByJacobian = True
    set_background(DARK)
    look(document, "viewIsometric", 1.2)
    save_view(document, "jacobian", 900, 520)
    set_background(LIGHT)
    FreeCAD.closeDocument(document.Name)


def draw_contact():
    """contact.png: a solid and its neighbour with C1 contact."""
    document = FreeCAD.newDocument("Contact")
    value = solids.random(3, 1)
    first = make_bezier_solid(document, value)
    second = make_bezier_solid(document, value.join((-1.0, 0.6, 0.6, 0.8), 1))
    make_solid_contact(document, first, second)
    for solid in (first, second):
        solid.ViewObject.ShowNet = False
        solid.ViewObject.Transparency = 40
    look(document, "viewTop", 1.1)
    save_view(document, "contact", 900, 520)
    FreeCAD.closeDocument(document.Name)


run(main)
