"""Draws the pictures of the documentation beside this file.

    tests/gui/on_screen docs/images/make_pictures.py
"""

import math
import os
import sys

import FreeCAD
import FreeCADGui
import Part

from osculate.features import make_curvature_comb, make_join_check
from osculate.gui import resources
from osculate.gui.construct.blend_form import BlendForm
from osculate.gui.construct.interpolated_form import InterpolatedForm
from osculate.gui.construct.joined_form import JoinedForm
from osculate.gui.construct.extend_form import ExtendForm
from osculate.gui.construct.match_form import MatchForm
from osculate.gui.panel.panel_form import PanelForm
from osculate.gui.plot.plot_dock import show_dock
from osculate.gui.preferences_page import PreferencesPage

FOLDER = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, FOLDER)
from pictures import (  # noqa: E402  FreeCAD does not look beside a script
    DARK, INK, LIGHT, V, arc, find_form, grab, grab_edited, ink, look, pump, run, save_view,
    set_background, widen_tree)

SAMPLE = os.path.join(resources.RESOURCES, "samples", "continuity_g0_to_g4.FCStd")


def main():
    draw_checks()
    draw_panel()
    draw_definitions()
    draw_list()
    draw_overlay()
    draw_blend()
    draw_handles()
    draw_porcupine()
    draw_join()
    draw_interpolate()
    draw_extend()
    draw_match()
    draw_comb()
    draw_torsion()
    draw_plot()
    draw_preferences()


def draw_checks():
    """demo.png: a check of each join of the sample, in the tree and in the view."""
    document = open_sample()
    for order in range(5):
        for part in "ab":  # farther apart, to make room for the labels
            side = document.getObject(f"G{order}{part}")
            side.Placement.Base += V(40.0 * order, -85.0 * (order % 2), 0)
        check = make_join_check(document, (document.getObject(f"G{order}a"), "Edge1"),
                                (document.getObject(f"G{order}b"), "Edge1"))
        check.Label = f"Join {order + 1}"
    FreeCADGui.Selection.addSelection(document.Name, "JoinCheck002")  # shows its properties
    widen_tree()
    look(document, "viewTop", 1.25)
    grab("demo")
    FreeCAD.closeDocument(document.Name)


def draw_panel():
    """panel.png: two edges, the panel and the overlay."""
    document = open_sample()
    for obj in document.Objects:
        obj.Visibility = obj.Name in ("G2a", "G2b")
    look(document, "viewIsometric", 1.2)
    analyze(document, ("G2a", "Edge1"), ("G2b", "Edge1"))
    grab("panel")
    FreeCADGui.Control.closeDialog()
    FreeCAD.closeDocument(document.Name)


def draw_definitions():
    """definitions.png: what others would say of two equal arcs that bend to opposite sides."""
    document = FreeCAD.newDocument("Arcs")
    for name, circle in (("First", arc(V(0, 20, 0), 20, -150, -90)),
                         ("Second", arc(V(0, -20, 0), 20, 30, 90))):
        document.addObject("Part::Feature", name).Shape = circle.toShape()
    document.recompute()
    form = analyze(document, ("First", "Edge1"), ("Second", "Edge1"))
    next(part for part in form.sections
         if part.content is form.definitions).header.setChecked(True)
    pump()
    form.definitions.grab().save(os.path.join(FOLDER, "definitions.png"))
    FreeCADGui.Control.closeDialog()
    FreeCAD.closeDocument(document.Name)


def draw_list():
    """list.png: all joins of a sketch, worst first."""
    document = open_profile()
    form = analyze(document, ("Profile", ""))
    form.joins.view.selectRow(2)
    pump()
    grab("list")
    FreeCADGui.Control.closeDialog()
    FreeCAD.closeDocument(document.Name)


def draw_join():
    """join.png: a sketch with a gap that is joined within a tolerance."""
    document = open_profile()
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(document.Name, "Profile")
    FreeCADGui.runCommand("Osculate_Join")
    pump()
    find_form(JoinedForm).tolerance.setValue(0.02)
    grab("join")
    FreeCADGui.Control.closeDialog()
    FreeCAD.closeDocument(document.Name)


def draw_interpolate():
    """interpolate.png: a curve through vertices, one with a tension of its own."""
    document = FreeCAD.newDocument("Points")
    wire = document.addObject("Part::Feature", "Wire")
    wire.Shape = Part.makePolygon([V(0, 0, 0), V(40, 35, 0), V(80, 0, 10), V(110, 45, 0),
                                   V(160, 20, 0), V(180, 50, 20)])
    document.recompute()
    wire.ViewObject.DrawStyle = "Dotted"
    look(document, "viewTop", 1.0)
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(document.Name, "Wire")
    FreeCADGui.runCommand("Osculate_Interpolate")
    pump()
    form = find_form(InterpolatedForm)
    form.table.mark(3)
    form.own.box.setValue(40.0)
    grab("interpolate")
    FreeCADGui.Control.closeDialog()
    FreeCAD.closeDocument(document.Name)


def open_profile():
    """A sketch: line, arc, arc, B-spline, line, with a corner and a gap."""
    document = FreeCAD.newDocument("Profile")
    sketch = document.addObject("Sketcher::SketchObject", "Profile")
    sketch.addGeometry(Part.LineSegment(V(0, 0, 0), V(50, 0, 0)))
    sketch.addGeometry(arc(V(50, 20, 0), 20, -90, 0))
    sketch.addGeometry(arc(V(110, 20, 0), 40, 90, 180))
    spline = Part.BSplineCurve()
    spline.interpolate([V(110, 60, 0), V(140, 70, 0), V(170, 40, 0), V(200, 60, 0)])
    sketch.addGeometry(spline)
    sketch.addGeometry(Part.LineSegment(V(200, 60.02, 0), V(230, 100, 0)))
    document.recompute()
    sketch.ViewObject.LineColor = INK
    sketch.ViewObject.LineWidth = 3.0
    look(document, "viewTop", 1.2)
    return document


def draw_overlay():
    """overlay.png: a close look at the 3D view, on dark."""
    document = open_sample()
    for obj in document.Objects:
        obj.Visibility = obj.Name in ("G1a", "G1b")
    set_background(DARK)
    analyze(document, ("G1a", "Edge1"), ("G1b", "Edge1"))
    look(document, "viewIsometric", 1.4)
    save_view(document, "overlay", 900, 520)
    FreeCADGui.Control.closeDialog()
    set_background(LIGHT)
    FreeCAD.closeDocument(document.Name)


def draw_blend():
    """blend.png: two edges, their blend, the panel and the handles."""
    document = open_blend_ends()
    look(document, "viewIsometric", 1.0)
    form = blend(document)
    form.ends[0].order.buttons[2].click()
    form.ends[0].numbers[0].box.setValue(0.85)
    pump()
    grab("blend")
    FreeCADGui.Control.closeDialog()
    FreeCAD.closeDocument(document.Name)


def draw_handles():
    """handles.png: a close look at the handles while the mouse is at one, on dark."""
    document = open_blend_ends()
    set_background(DARK)
    form = blend(document)
    form.ends[0].numbers[0].lock.click()
    form.panel.handles.hot = ("First", 1)
    form.panel.show()
    look(document, "viewTop", 1.7)
    save_view(document, "handles", 900, 420)
    FreeCADGui.Control.closeDialog()
    set_background(LIGHT)
    FreeCAD.closeDocument(document.Name)


def draw_porcupine():
    """porcupine.png: the combs of a blend and of both its neighbours in one scale."""
    document = open_curves(Left=((0, 0, 0), (5, 40, 0), (20, 70, 0), (55, 85, 0)),
                           Right=((130, 88, 0), (165, 78, 0), (190, 50, 0), (200, 0, 0)))
    look(document, "viewTop", 0.9)
    form = blend(document)
    form.combs.setChecked(True)
    pump()
    grab("porcupine")
    FreeCADGui.Control.closeDialog()
    FreeCAD.closeDocument(document.Name)


def draw_extend():
    """extend.png: an edge that goes on to a vertex, the panel and the handles."""
    document = open_curves(Edge=((0, 0, 0), (30, 0, 0), (60, 10, 0), (80, 35, 5)))
    goal = document.addObject("Part::Feature", "Goal")
    goal.Shape = Part.Vertex(150, 60, 20)
    goal.ViewObject.PointSize = 7.0
    document.recompute()
    look(document, "viewIsometric", 1.0)
    form = construct(document, "Osculate_Extend", ExtendForm, "Edge")
    form.order.buttons[3].click()
    form.targets.pick.click()
    FreeCADGui.Selection.addSelection(document.Name, "Goal", "Vertex1")
    pump()
    form.targets.direction.click()
    for box, value in zip(form.targets.vector.boxes, (1.0, 0.0, 0.0)):
        box.setValue(value)
    form.degree.setValue(7)
    pump()
    grab("extend")
    FreeCADGui.Control.closeDialog()
    FreeCAD.closeDocument(document.Name)


def draw_match():
    """match.png: a spline that is changed to meet another curve, and how far its points moved."""
    document = open_curves(Stays=((0, 0, 0), (30, 0, 0), (60, 10, 0), (80, 35, 5)))
    spline = Part.BSplineCurve()
    spline.interpolate([V(84, 33, 5), V(110, 42, 8), V(130, 30, 10), V(150, 40, 10),
                        V(175, 35, 5), V(200, 45, 0)])
    obj = document.addObject("Part::Feature", "Changes")
    obj.Shape = spline.toShape()
    document.recompute()
    ink(document)
    look(document, "viewTop", 1.0)
    form = construct(document, "Osculate_Match", MatchForm, "Stays", "Changes")
    form.order.buttons[2].click()
    grab("match")
    FreeCADGui.Control.closeDialog()
    FreeCAD.closeDocument(document.Name)


def open_blend_ends():
    """Two curves in space with a gap between them."""
    return open_curves(Left=((0, 0, 0), (30, 0, 0), (60, 10, 0), (80, 35, 5)),
                       Right=((150, 60, 20), (175, 55, 30), (200, 35, 30), (215, 0, 15)))


def open_curves(**poles_of):
    """A document with a Bézier curve for each name."""
    document = FreeCAD.newDocument("Curves")
    for name, poles in poles_of.items():
        curve = Part.BezierCurve()
        curve.setPoles([V(*pole) for pole in poles])
        document.addObject("Part::Feature", name).Shape = curve.toShape()
    document.recompute()
    ink(document)
    return document


def blend(document):
    """Blend on the two objects of a document; returns the panel's form."""
    return construct(document, "Osculate_Blend", BlendForm, "Left", "Right")


def construct(document, command, kind, *names):
    """A command on the edges of some objects; returns the panel's form."""
    FreeCADGui.Selection.clearSelection()
    for name in names:
        FreeCADGui.Selection.addSelection(document.Name, name, "Edge1")
    FreeCADGui.runCommand(command)
    pump()
    return find_form(kind)


def draw_comb():
    """comb.png: the curvature of a profile of two arcs and a Bézier curve, and its panel."""
    document = FreeCAD.newDocument("Comb")
    wave = Part.BezierCurve()
    wave.setPoles([V(30, 30, 0), V(30, 55, 0), V(55, 75, 0), V(95, 66, 0), V(110, 40, 0),
                   V(150, 46, 0)])
    for name, curve in (("Small", arc(V(0, 30, 0), 30, -90, 0)),
                        ("Large", arc(V(0, 80, 0), 80, -130, -90)), ("Wave", wave)):
        document.addObject("Part::Feature", name).Shape = curve.toShape()
    document.recompute()
    comb = make_curvature_comb(document, document.Objects)
    grab_edited(comb, "viewTop", 1.1, "comb")


def draw_torsion():
    """torsion.png: the combs of curvature and torsion of one curve in space, on dark."""
    document = FreeCAD.newDocument("Torsion")
    spline = Part.BSplineCurve()
    spline.interpolate([V((50 - 6 * t) * math.cos(t), (50 - 6 * t) * math.sin(t), 9 * t)
                        for t in (0.0, 0.8, 1.6, 2.4, 3.4, 4.4, 5.6)])
    spiral = document.addObject("Part::Feature", "Spiral")
    spiral.Shape = spline.toShape()
    spiral.ViewObject.LineColor = (0.9, 0.9, 0.9)
    spiral.ViewObject.LineWidth = 3.0
    document.recompute()
    set_background(DARK)
    for quantity in ("curvature", "torsion"):
        make_curvature_comb(document, [spiral], quantity=quantity)
    look(document, "viewIsometric", 0.95)
    save_view(document, "torsion", 900, 640)
    set_background(LIGHT)
    FreeCAD.closeDocument(document.Name)


def draw_plot():
    """plot.png: the plot of a profile in its dock, the cursor in it and in the view."""
    document = open_profile()
    look(document, "viewTop", 0.9)
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(document.Name, "Profile")
    dock = show_dock()
    dock.resize(dock.width(), 430)
    pump()
    FreeCADGui.Selection.clearSelection()
    dock.point_at(165.0)
    grab("plot", dock.objectName())
    dock.close()
    FreeCAD.closeDocument(document.Name)


def draw_preferences():
    """preferences.png: the page of the preferences."""
    page = PreferencesPage()
    page.loadSettings()
    page.form.resize(480, 400)
    page.form.show()
    pump()
    page.form.grab().save(os.path.join(FOLDER, "preferences.png"))
    page.form.close()


def open_sample():
    document = FreeCAD.openDocument(SAMPLE)
    for obj in document.Objects:
        obj.Visibility = True  # the sample was made without a GUI, which knows of no visibility
        obj.ViewObject.LineWidth = 3.0
        obj.ViewObject.LineColor = INK
        obj.ViewObject.PointSize = 5.0
    return document


def analyze(document, *targets):
    """The command on (object name, sub-element) pairs; returns the panel's form."""
    FreeCADGui.Selection.clearSelection()
    for name, sub in targets:
        FreeCADGui.Selection.addSelection(document.Name, name, sub)
    FreeCADGui.runCommand("Osculate_AnalyzeJoin")
    pump()
    FreeCADGui.Selection.clearSelection()  # its green would hide the model's colours
    pump()
    return find_form(PanelForm)


run(main)
