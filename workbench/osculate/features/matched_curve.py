"""The document object MatchedCurve: an edge changed as little as possible so that it meets another
one.
"""

import FreeCAD

import osculate
from osculate import shapes
from osculate.features import beta_properties
from osculate.features.blend_curve import MOST_DEGREE
from osculate.features.constructed import RESULT, Constructed, show_result
from osculate.features.departure import CHOICES, NEAREST, ends_of
from osculate.features.edge_link import EdgeLink, LinkError, resolve_each
from osculate.features.feature import make
from osculate.features.joins import END_NAMES
from osculate.features.properties import LINK, READ_ONLY, SHOWN, set_if_changed

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

SIDES = ("Reference", "Changed")
CHANGED_CHOICES = (NEAREST, *END_NAMES)
#: The far end is looked at up to this order, or to the order that is kept if that is higher.
_FAR_ORDER = 4

beta_numbers = beta_properties.of_side()

_EDGES = ("Edges", (
    ("Reference", LINK, QT_TRANSLATE_NOOP("App::Property", "The edge that stays")),
    ("ReferenceEnd", "App::PropertyEnumeration", QT_TRANSLATE_NOOP(
        "App::Property", "Where it is met")),
    ("ReferencePosition", "App::PropertyFloatConstraint", QT_TRANSLATE_NOOP(
        "App::Property", "The place inside the reference, as a share of its length")),
    ("Changed", LINK, QT_TRANSLATE_NOOP(
        "App::Property", "The edge that is changed; it stays as it is, the result is another one")),
    ("ChangedEnd", "App::PropertyEnumeration", QT_TRANSLATE_NOOP(
        "App::Property", "Which end of it meets the reference")),
    ("HideOriginal", "App::PropertyBool", QT_TRANSLATE_NOOP(
        "App::Property", "Whether the object of the edge as it was is hidden")),
))
_MATCH = ("Match", (
    ("Order", "App::PropertyIntegerConstraint", QT_TRANSLATE_NOOP(
        "App::Property", "Order of contact with the reference, 0 to 8")),
    ("Keep", "App::PropertyIntegerConstraint", QT_TRANSLATE_NOOP(
        "App::Property", "Up to which order the derivatives at the far end stay, 0 to 8")),
    ("Degree", "App::PropertyIntegerConstraint", QT_TRANSLATE_NOOP(
        "App::Property", "The degree; 0 for that of the edge where it suffices, else the least")),
    ("Spans", "App::PropertyIntegerConstraint", QT_TRANSLATE_NOOP(
        "App::Property", "How many spans may change, from the join; 0 for as many as are useful")),
))
_CHANGE = ("Result", (
    ("EndsMade", "App::PropertyString", QT_TRANSLATE_NOOP(
        "App::Property", "Which ends meet, the nearest being found")),
    ("MaxDisplacement", "App::PropertyLength", QT_TRANSLATE_NOOP(
        "App::Property", "No point of the edge moved farther")),
    ("RmsDisplacement", "App::PropertyLength", QT_TRANSLATE_NOOP(
        "App::Property", "Root mean square of the displacement over the spans that changed")),
    ("ChangedSpans", "App::PropertyInteger", QT_TRANSLATE_NOOP(
        "App::Property", "How many spans changed, from the join")),
))


class MatchedCurve(Constructed):
    """Proxy of a Part::FeaturePython; documents name this class."""

    groups = (_EDGES, _MATCH, beta_numbers.group)
    result_groups = (_CHANGE, RESULT)
    starts = {
        "ReferenceEnd": list(CHOICES),
        "ReferencePosition": (0.5, 0.0, 1.0, 0.05),
        "ChangedEnd": list(CHANGED_CHOICES),
        "Order": (2, 0, osculate.MAX_ORDER, 1),
        "Keep": (4, 0, osculate.MAX_ORDER, 1),
        "Degree": (0, 0, MOST_DEGREE, 1),
        "Spans": (0, 0, 1000000, 1),
        beta_numbers.number_name(1): 1.0,
    }

    original = None    #: the Curve of the edge as it was, of the last recompute
    far_report = None  #: the JoinReport at its far end, where it can be told

    def construct(self, obj):
        edges = resolve_each([EdgeLink.of_property(getattr(obj, side)) for side in SIDES])
        self.original = shapes.curve_from_edge(edges[1])
        return osculate.match(
            *edges, order=obj.Order, keep=obj.Keep, degree=obj.Degree or None,
            spans=obj.Spans or None, beta=beta_numbers.given(obj, obj.Order),
            ends=ends_of(edges, (obj.ReferenceEnd, obj.ChangedEnd), (obj.ReferencePosition, 0.5)))

    def show_choices(self, obj, result):
        is_closing = obj.Reference == obj.Changed  # both ends are at the join
        self.far_report = None if is_closing else far_report(
            self.original, result.curve, result.reports[0].ends[1], max(_FAR_ORDER, obj.Keep))
        beta_numbers.show(obj, result.beta[0])

    def show(self, obj, result):
        join = result.reports[0]
        show_result(obj, result, [report for report in (join, self.far_report) if report])
        set_if_changed(obj, "EndsMade", "-".join(join.ends))
        set_if_changed(obj, "MaxDisplacement", result.max_displacement_mm)
        set_if_changed(obj, "RmsDisplacement", result.change["rms_mm"])
        set_if_changed(obj, "ChangedSpans", result.change["spans"])

    def set_editors(self, obj):
        super().set_editors(obj)
        is_inside = obj.ReferenceEnd.startswith("inside")
        obj.setEditorMode("ReferencePosition", SHOWN if is_inside else READ_ONLY)
        beta_numbers.set_editors(obj, obj.Order)

    def onBeforeChange(self, obj, name):
        if name == "Changed" and self._is_set_up(obj) and obj.HideOriginal:
            show_original(obj, True)  # another edge takes its place

    def onChanged(self, obj, name):
        if not self._is_set_up(obj):
            return
        if name.endswith("Fixed") or name in ("Order", "ReferenceEnd"):
            self.set_editors(obj)
        elif name == "HideOriginal" or (name == "Changed" and obj.HideOriginal):
            show_original(obj, not obj.HideOriginal)

    @staticmethod
    def _is_set_up(obj):
        """Its properties are there, and are not being loaded."""
        return not FreeCAD.isRestoring() and hasattr(obj, "SchemaVersion")


def far_report(original, changed, end, order):
    """The JoinReport of a changed curve where it ends with the parametric continuation of the
    original there: what the curve keeps of its contact with a neighbour. None where the original
    stops there.

    end: "start" or "end", the end that was changed.
    """
    far = "start" if end == "end" else "end"
    try:
        beyond = osculate.extend(original, end=far, order=order, parametric=True).curve
    except osculate.ContactError:
        return None
    return osculate.analyze(changed, beyond, order=order, ends=(far, "start"),
                            tolerances=osculate.Tolerances.preset("exact"))


def show_original(obj, is_visible):
    """Shows or hides the object of the edge that is changed."""
    try:
        owner = EdgeLink.of_property(obj.Changed).owner()
    except LinkError:
        return  # it was deleted
    if owner.Visibility != is_visible:
        owner.Visibility = is_visible


def make_matched_curve(doc, reference, changed, *, order=2, ends=None, position=0.5, keep=4,
                       degree=None, spans=None, beta=None, hide_original=False,
                       name="MatchedCurve"):
    """Adds a MatchedCurve to a document and recomputes it.

    doc:     the App.Document
    reference, changed: (object, "Edge1") pairs; the path may lead down an App::Part
             ("Sketch.Edge1"). The second edge stays as it is: the result is a changed copy.
    order, keep, degree, spans, beta: as for osculate.match
    ends:    a pair, for the reference of "nearest", "start", "end", "inside-forward" and
             "inside-backward", for the other of "nearest", "start" and "end"; None for the nearest
    position: the place inside the reference, as a share of its length from its start
    hide_original: whether the object of the second edge is hidden

    Raises ValueError before anything is changed. A link that leads to no edge, and what a match
    cannot meet, is no error here: the object says so in its Status.
    """
    ends = (NEAREST, NEAREST) if ends is None else tuple(ends)
    beta = () if beta is None else tuple(beta)
    _check(order, ends, position, keep, degree, spans, beta)
    return make_object(doc, name=name, Reference=reference, Changed=changed, Order=order,
                       ReferenceEnd=ends[0], ChangedEnd=ends[1], ReferencePosition=position,
                       Keep=keep, Degree=degree or 0, Spans=spans or 0,
                       HideOriginal=bool(hide_original), **beta_numbers.settings(beta))


def make_object(doc, *, name="MatchedCurve", **properties):
    """Adds a MatchedCurve with some of its properties set, and recomputes it."""
    return make(doc, MatchedCurve, name, **properties)


def _check(order, ends, position, keep, degree, spans, beta):
    most = osculate.MAX_ORDER
    for argument, value in (("order", order), ("keep", keep)):
        if not 0 <= value <= most:
            raise ValueError(f"{argument}: must be 0 to {most}, not {value}")
    for end, choices in zip(ends, (CHOICES, CHANGED_CHOICES)):
        if end not in choices:
            raise ValueError(f"ends: must be one of {', '.join(choices)}, not {end!r}")
    if not 0.0 <= position <= 1.0:
        raise ValueError(f"position: must be from 0 to 1, not {position}")
    if degree is not None and not 1 <= degree <= MOST_DEGREE:
        raise ValueError(f"degree: must be 1 to {MOST_DEGREE}, not {degree}")
    if spans is not None and spans < 1:
        raise ValueError(f"spans: must be at least 1, not {spans}")
    if len(beta) > order:
        raise ValueError(f"beta: contact of order {order} has {order} numbers, got {len(beta)}")
    if beta and beta[0] is not None and not beta[0] > 0.0:
        raise ValueError(f"beta: beta_1 must be > 0, not {beta[0]}")
