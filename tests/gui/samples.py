"""Models for the GUI tests, small enough to know the answers by heart."""

import math

import FreeCAD
import Part

V = FreeCAD.Vector


def add_edge(doc, name, curve):
    """A Part::Feature with one edge."""
    obj = doc.addObject("Part::Feature", name)
    obj.Shape = curve.toShape()
    return obj


def bezier(*poles):
    curve = Part.BezierCurve()
    curve.setPoles([V(*pole) for pole in poles])
    return curve


def line_and_arc(doc, radius=20.0):
    """A line of 50 mm and a quarter of a circle that it meets with equal tangents: G1."""
    line = add_edge(doc, "Line", Part.LineSegment(V(0, 0, 0), V(50, 0, 0)))
    circle = Part.Circle(V(50, radius, 0), V(0, 0, 1), radius)
    arc = add_edge(doc, "Arc", Part.ArcOfCircle(circle, -math.pi / 2, 0))
    doc.recompute()
    return line, arc


def cut_curve(doc, scale=1.0, offset=0.0):
    """One quintic in two objects: every order passes, unless the offset eats the digits."""
    poles = ((0, 0, 0), (20, 5, 0), (40, 30, 10), (60, 20, 10), (80, 0, 20), (100, 10, 0))
    whole = bezier(*([offset + scale * x for x in pole] for pole in poles))
    first, second = whole.copy(), whole.copy()
    first.segment(0.0, 0.4)
    second.segment(0.4, 1.0)
    objects = add_edge(doc, "First", first), add_edge(doc, "Second", second)
    doc.recompute()
    return objects


def space_curves(doc):
    """Two cubics in space that meet with equal tangents and different frames: G1."""
    objects = (add_edge(doc, "Arriving", bezier((0, 0, 0), (20, 0, 0), (40, 10, 0), (60, 30, 10))),
               add_edge(doc, "Leaving",
                        bezier((60, 30, 10), (80, 50, 20), (110, 60, 20), (130, 30, 0))))
    doc.recompute()
    return objects


def profile(doc):
    """A sketch: line, arc, arc, B-spline, line; G1, G1, a corner, a gap of 0.02 mm."""
    sketch = doc.addObject("Sketcher::SketchObject", "Profile")
    sketch.addGeometry(Part.LineSegment(V(0, 0, 0), V(50, 0, 0)))
    sketch.addGeometry(Part.ArcOfCircle(Part.Circle(V(50, 20, 0), V(0, 0, 1), 20),
                                        -math.pi / 2, 0))
    sketch.addGeometry(Part.ArcOfCircle(Part.Circle(V(110, 20, 0), V(0, 0, 1), 40),
                                        math.pi / 2, math.pi))
    spline = Part.BSplineCurve()
    spline.interpolate([V(110, 60, 0), V(140, 70, 0), V(170, 40, 0), V(200, 60, 0)])
    sketch.addGeometry(spline)
    sketch.addGeometry(Part.LineSegment(V(200, 60.02, 0), V(230, 100, 0)))
    doc.recompute()
    return sketch


def blend_ends(doc):
    """Two cubics in space, 60 mm apart, that a blend can connect."""
    objects = (add_edge(doc, "Left", bezier((0, 0, 0), (20, 0, 0), (40, 10, 0), (50, 20, 0))),
               add_edge(doc, "Right", bezier((100, 30, 0), (120, 30, 20), (140, 10, 20),
                                             (150, 0, 10))))
    doc.recompute()
    return objects
