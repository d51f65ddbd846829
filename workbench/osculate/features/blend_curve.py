"""The document object BlendCurve: a curve between two edges that meets each with its own order."""

import FreeCAD

import osculate
from osculate.features import beta_properties
from osculate.features.constructed import RESULT, Constructed
from osculate.features.departure import CHOICES, NEAREST, ends_of
from osculate.features.edge_link import EdgeLink, resolve_each
from osculate.features.feature import make
from osculate.features.properties import LINK, READ_ONLY, SHOWN, set_if_changed

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

SIDES = ("First", "Second")
FAIRNESS = {"mvc": "mvc", "bending": "bending", "none": None}  #: as stored -> as osculate takes it
MOST_DEGREE = 25
_LEAST = 0  # Degree: the least that the orders need

_EDGES = ("Edges", (
    ("First", LINK, QT_TRANSLATE_NOOP("App::Property", "The edge that the blend leaves")),
    ("FirstEnd", "App::PropertyEnumeration", QT_TRANSLATE_NOOP(
        "App::Property", "Where the blend leaves the first edge")),
    ("FirstPosition", "App::PropertyFloatConstraint", QT_TRANSLATE_NOOP(
        "App::Property", "The place inside the first edge, as a share of its length")),
    ("Second", LINK, QT_TRANSLATE_NOOP("App::Property", "The edge at which the blend arrives")),
    ("SecondEnd", "App::PropertyEnumeration", QT_TRANSLATE_NOOP(
        "App::Property", "Where the blend arrives at the second edge")),
    ("SecondPosition", "App::PropertyFloatConstraint", QT_TRANSLATE_NOOP(
        "App::Property", "The place inside the second edge, as a share of its length")),
))
_BLEND = ("Blend", (
    ("FirstOrder", "App::PropertyIntegerConstraint", QT_TRANSLATE_NOOP(
        "App::Property", "Order of contact with the first edge, 0 to 8")),
    ("SecondOrder", "App::PropertyIntegerConstraint", QT_TRANSLATE_NOOP(
        "App::Property", "Order of contact with the second edge, 0 to 8")),
    ("Degree", "App::PropertyIntegerConstraint", QT_TRANSLATE_NOOP(
        "App::Property", "The degree; 0 for the least that the orders need, their sum and 1")),
    ("Fairness", "App::PropertyEnumeration", QT_TRANSLATE_NOOP(
        "App::Property", "What chooses the free numbers: least variation of curvature, least "
                         "bending, or none (speed 1, the others 0)")),
    ("Symmetric", "App::PropertyBool", QT_TRANSLATE_NOOP(
        "App::Property", "Whether chosen numbers are equal at both ends")),
))
_ENDS_MADE = ("Result", (
    ("EndsMade", "App::PropertyString", QT_TRANSLATE_NOOP(
        "App::Property", "Where the blend leaves both edges, the nearest ends being found")),
))


class BlendCurve(Constructed):
    """Proxy of a Part::FeaturePython; documents name this class."""

    groups = (_EDGES, _BLEND, *map(beta_properties.group, SIDES))
    result_groups = (_ENDS_MADE, RESULT)
    starts = {
        **dict.fromkeys(("FirstEnd", "SecondEnd"), list(CHOICES)),
        **dict.fromkeys(("FirstPosition", "SecondPosition"), (0.5, 0.0, 1.0, 0.05)),
        **dict.fromkeys(("FirstOrder", "SecondOrder"), (3, 0, osculate.MAX_ORDER, 1)),
        "Degree": (_LEAST, 0, MOST_DEGREE, 1),
        "Fairness": list(FAIRNESS),
        **{beta_properties.number_name(side, 1): 1.0 for side in SIDES},
    }

    def construct(self, obj):
        edges = resolve_each(links_of(obj))
        orders = obj.FirstOrder, obj.SecondOrder
        return osculate.blend(
            *edges, order=orders, ends=ends_of(edges, (obj.FirstEnd, obj.SecondEnd),
                                               (obj.FirstPosition, obj.SecondPosition)),
            beta=tuple(beta_properties.given(obj, *end) for end in zip(SIDES, orders)),
            degree=obj.Degree or None, fairness=FAIRNESS[obj.Fairness], symmetric=obj.Symmetric)

    def show_choices(self, obj, result):
        first, second = result.reports
        set_if_changed(obj, "EndsMade", f"{first.ends[0]}-{second.ends[1]}")
        for side, numbers in zip(SIDES, result.beta):
            beta_properties.show(obj, side, numbers)

    def set_editors(self, obj):
        super().set_editors(obj)
        for side in SIDES:
            is_inside = getattr(obj, f"{side}End").startswith("inside")
            obj.setEditorMode(f"{side}Position", SHOWN if is_inside else READ_ONLY)
            beta_properties.set_editors(obj, side, getattr(obj, f"{side}Order"))

    def onChanged(self, obj, name):
        if name.endswith(("Fixed", "Order", "End")) and not FreeCAD.isRestoring() \
                and hasattr(obj, "SchemaVersion"):  # else its properties are not there yet
            self.set_editors(obj)


def make_blend_curve(doc, first, second, *, order=3, ends=None, positions=(0.5, 0.5), beta=None,
                     degree=None, fairness="mvc", symmetric=False, name="BlendCurve"):
    """Adds a BlendCurve to a document and recomputes it.

    doc:     the App.Document
    first, second: (object, "Edge1") pairs; the path may lead down an App::Part ("Sketch.Edge1").
             The same open edge twice is closed by the blend.
    order, beta, degree, fairness, symmetric: as for osculate.blend
    ends:    a pair of "nearest", "start", "end", "inside-forward" and "inside-backward", or None
             for the nearest ends, which are found at every recompute
    positions: the places inside the edges, as shares of their lengths from their starts

    Raises ValueError before anything is changed. A link that leads to no edge, and what a blend
    cannot meet, is no error here: the object says so in its Status.
    """
    settings = blend_settings(order=order, ends=ends, positions=positions, beta=beta,
                              degree=degree, fairness=fairness, symmetric=symmetric)
    return make_object(doc, name=name, First=first, Second=second, **settings)


def make_object(doc, *, name="BlendCurve", **properties):
    """Adds a BlendCurve with some of its properties set, and recomputes it."""
    return make(doc, BlendCurve, name, **properties)


def blend_settings(*, order, ends, positions, beta, degree, fairness, symmetric):
    """The properties of a BlendCurve from the arguments of make_blend_curve, as a dict."""
    orders = tuple(order) if isinstance(order, (tuple, list)) else (order, order)
    ends = (NEAREST, NEAREST) if ends is None else tuple(ends)
    beta = ((), ()) if beta is None else beta
    _check(orders, ends, positions, beta, degree, fairness)
    settings = {"Degree": degree or _LEAST, "Symmetric": bool(symmetric),
                "Fairness": "none" if fairness is None else fairness}
    for side, *values in zip(SIDES, orders, ends, positions, beta):
        settings[f"{side}Order"], settings[f"{side}End"], settings[f"{side}Position"] = values[:3]
        settings.update(beta_properties.settings(side, values[3]))
    return settings


def _check(orders, ends, positions, beta, degree, fairness):
    for order, end, position, numbers in zip(orders, ends, positions, beta):
        if not 0 <= order <= osculate.MAX_ORDER:
            raise ValueError(f"order: must be 0 to {osculate.MAX_ORDER}, not {order}")
        if end not in CHOICES:
            raise ValueError(f"ends: must be None or a pair of {', '.join(CHOICES)}, not {end!r}")
        if not 0.0 <= position <= 1.0:
            raise ValueError(f"positions: must be from 0 to 1, not {position}")
        if len(numbers) > order:
            raise ValueError(f"beta: an end of order {order} has {order} numbers, got "
                             f"{len(numbers)}")
        if numbers and numbers[0] is not None and not numbers[0] > 0.0:
            raise ValueError(f"beta: beta_1 must be > 0, not {numbers[0]}")
    if degree is not None and not 1 <= degree <= MOST_DEGREE:
        raise ValueError(f"degree: must be 1 to {MOST_DEGREE}, not {degree}")
    if fairness not in FAIRNESS.values():
        raise ValueError(f"fairness: must be \"mvc\", \"bending\" or None, not {fairness!r}")


def links_of(obj):
    """The EdgeLinks of both edges. Raises LinkError if one is empty."""
    return tuple(EdgeLink.of_property(getattr(obj, side)) for side in SIDES)
