"""The document object JoinCheck: the continuity of a join, kept up to date with the model."""

import math

import FreeCAD

from osculate.features import views
from osculate.features.edge_link import EdgeLink, LinkError
from osculate.features.join_check_properties import add_properties, set_editors, set_numbers
from osculate.features.joins import ENDS, JoinPlace
from osculate.features.tolerance_choice import CUSTOM, tolerances_of
from osculate.features.tolerance_properties import (
    set_tolerance_values, take_preset, tolerances_in)


class JoinCheck:
    """Proxy of an App::FeaturePython; what it finds stands in the object's properties.

    Documents name this class: keep module and name, and migrate by `SchemaVersion`.
    """

    SCHEMA_VERSION = 1

    def __init__(self, obj):
        add_properties(obj)
        obj.SchemaVersion = self.SCHEMA_VERSION
        obj.Proxy = self
        take_preset(obj)
        set_editors(obj)

    def onDocumentRestored(self, obj):
        add_properties(obj)
        if obj.SchemaVersion != self.SCHEMA_VERSION:
            obj.SchemaVersion = self.SCHEMA_VERSION
        set_editors(obj)
        views.give_view(obj)  # a check from a script without a GUI has none yet

    def onChanged(self, obj, name):
        if name == "Preset" and not FreeCAD.isRestoring():
            take_preset(obj)

    def execute(self, obj):
        try:
            report = place_of(obj).analyze(obj.OrderAsked, tolerances_in(obj))
        except (LinkError, ValueError, TypeError, RuntimeError) as error:
            _show_error(obj, error)
        else:
            _show_report(obj, report)
        set_editors(obj)

    def dumps(self):
        return None

    def loads(self, _state):
        return None

    __getstate__ = dumps
    __setstate__ = loads


def make_join_check(doc, first, second, *, order=4, ends=None, preset="osculate", values=None,
                    knot=0, name="JoinCheck"):
    """Adds a JoinCheck to a document and recomputes it.

    doc:     the App.Document
    first, second: (object, "Edge1") pairs; the path may lead down an App::Part ("Sketch.Edge1").
             The same edge twice: its closing join, or its inner knot number `knot` (from 1).
    order:   highest order analysed, 0 to 8
    ends:    ("end", "start") and so on; None takes the nearest ends at every recompute
    preset:  name of a tolerance preset, or "custom" with `values` (ToleranceValues)

    Raises ValueError before anything is changed. A link that leads to no edge is no error here:
    the object says so in its Status.
    """
    _check_arguments(order, ends, preset, values, knot)
    obj = doc.addObject("App::FeaturePython", name)
    JoinCheck(obj)
    views.give_view(obj)
    obj.First = first
    obj.Second = second
    configure(obj, order=order, ends=ends, preset=preset, values=values, knot=knot)
    doc.recompute([obj])
    return obj


def configure(obj, *, order, ends, preset, values, knot=0):
    """Sets how a JoinCheck analyses; arguments as in make_join_check."""
    obj.OrderAsked = order
    obj.Ends = _name_of_ends(ends)
    obj.Knot = knot
    obj.Preset = preset
    if preset == CUSTOM:
        set_tolerance_values(obj, values)


def place_of(obj):
    """The JoinPlace of a JoinCheck. Raises LinkError if a link is empty."""
    return JoinPlace(EdgeLink.of_property(obj.First), EdgeLink.of_property(obj.Second),
                     ENDS[obj.Ends], obj.Knot)


def is_at(obj, place):
    """Whether a JoinCheck is at a JoinPlace."""
    try:
        return place_of(obj) == place
    except LinkError:
        return False


def _check_arguments(order, ends, preset, values, knot):
    if not 0 <= order <= 8:
        raise ValueError(f"order must be 0 to 8, not {order}")
    if knot < 0:
        raise ValueError(f"knot must be 0 or the number of an inner knot, not {knot}")
    if preset == CUSTOM and values is None:
        raise ValueError("values are needed with the preset \"custom\"")
    _name_of_ends(ends)
    tolerances_of(preset, values)


def _name_of_ends(ends):
    for name, pair in ENDS.items():
        if pair == (None if ends is None else tuple(ends)):
            return name
    raise ValueError(f"ends must be None or a pair of \"start\" and \"end\", not {ends!r}")


def continuity_name(order):
    """"G2"; "gap" for -1."""
    return f"G{order}" if order >= 0 else "gap"


def _show_report(obj, report):
    obj.Continuity = continuity_name(report.order)
    obj.Order = report.order
    obj.ParametricOrder = report.parametric_order
    obj.Headline = report.headline
    obj.Residuals = [math.nan if residual is None else residual for residual in report.residuals]
    obj.Position = FreeCAD.Vector(*report.sides[0].point)
    set_numbers(obj, {**report.deviation, **_side_numbers("first", report.sides[0]),
                      **_side_numbers("second", report.sides[1])})
    obj.Report = report.to_json()
    obj.Status = "OK"
    obj.Verdicts = list(report.verdicts)  # the last: the view provider waits for it


def _side_numbers(name, side):
    return {f"curvature_{name}": side.curvature,
            f"radius_{name}": 1.0 / side.curvature if side.normal is not None else None}


def _show_error(obj, error):
    obj.Continuity = "error"
    obj.Order = obj.ParametricOrder = -1
    obj.Headline = obj.Report = ""
    obj.Residuals = []
    set_numbers(obj, {})
    obj.Status = str(error)
    obj.Verdicts = []
