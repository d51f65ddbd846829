"""The document object ExtendedCurve: a curve that continues an edge beyond one of its ends."""

import FreeCAD
import Part

import osculate
from osculate.features import extended_curve_properties as names
from osculate.features.blend_curve import FAIRNESS, MOST_DEGREE
from osculate.features.constructed import RESULT, Constructed
from osculate.features.edge_link import EdgeLink, VertexLink
from osculate.features.extended_curve_properties import (
    BETA, GEOMETRIC, MAGNITUDE, NATURAL, NONE, PARAMETRIC, POSITION, REPARAMETRISED, TANGENTIAL,
    VECTOR, VERTEX, beta_numbers, tangential_numbers)
from osculate.features.feature import make
from osculate.features.joins import END_NAMES
from osculate.features.properties import HIDDEN, READ_ONLY, SHOWN, set_if_changed


class ExtendedCurve(Constructed):
    """Proxy of a Part::FeaturePython; documents name this class."""

    groups = names.GROUPS
    result_groups = (*names.RESULT_GROUPS, RESULT)
    starts = names.STARTS

    def construct(self, obj):
        edge = EdgeLink.of_property(obj.Source).resolve()
        options = {"end": obj.End, "order": obj.Order}
        if obj.WantedLengthFixed:
            options["length"] = obj.WantedLength.Value
        if obj.Continuation == NATURAL:
            return osculate.extend(edge, natural=True, **options)
        return osculate.extend(edge, degree=obj.Degree or None, fairness=FAIRNESS[obj.Fairness],
                               **options, **_contact(obj), **_targets(obj))

    def shape(self, obj, result):
        if not obj.IncludeSource:
            return result.edge
        pieces = [EdgeLink.of_property(obj.Source).resolve(), result.edge]
        return Part.Wire(pieces if obj.End == "end" else pieces[::-1])

    def show_choices(self, obj, result):
        if not obj.WantedLengthFixed:
            set_if_changed(obj, "WantedLength", result.energy["length_mm"])
        beta_numbers.show(obj, result.beta[0])
        tangential_numbers.show(obj, tangential_of(result, obj.Order))

    def show(self, obj, result):
        super().show(obj, result)
        set_if_changed(obj, "FreeNumbers", result.free_numbers)

    def set_editors(self, obj):
        super().set_editors(obj)
        for name, mode in _modes(obj).items():
            obj.setEditorMode(name, mode)
        order = obj.Order if obj.Continuation == GEOMETRIC else 0
        beta_numbers.set_editors(obj, order if obj.Numbers == BETA else 0)
        tangential_numbers.set_editors(obj, order if obj.Numbers == TANGENTIAL else 0)

    def onChanged(self, obj, name):
        is_choice = name.endswith(("Fixed", "Target")) or name in ("Order", "Continuation",
                                                                   "Numbers")
        if is_choice and not FreeCAD.isRestoring() and hasattr(obj, "SchemaVersion"):
            self.set_editors(obj)  # without it its properties are not there yet


def _contact(obj):
    """The options of osculate.extend that say how the continuation leaves the edge."""
    if obj.Continuation == PARAMETRIC:
        return {"parametric": True}
    if obj.Continuation == REPARAMETRISED:
        return {"parameter": obj.Parameter}
    if obj.Numbers == TANGENTIAL:
        return {"tangential": tangential_numbers.given(obj, obj.Order)}
    return {"beta": beta_numbers.given(obj, obj.Order)}


def _targets(obj):
    """The options that say where it ends."""
    return {"to_point": _point(obj),
            "to_direction": tuple(obj.Direction) if obj.DirectionTarget else None,
            "to_curvature": {NONE: None, MAGNITUDE: obj.Curvature,
                             VECTOR: tuple(obj.CurvatureVector)}[obj.CurvatureTarget]}


def _point(obj):
    if obj.PointTarget == VERTEX:
        return tuple(VertexLink.of_property(obj.PointVertex).resolve().Point)
    return tuple(obj.PointPosition) if obj.PointTarget == POSITION else None


def _modes(obj):
    """Which of the properties that say what is wanted are seen and can be edited."""
    def seen_if(condition):
        return SHOWN if condition else HIDDEN

    is_solved = obj.Continuation != NATURAL
    modes = dict.fromkeys(("Degree", "Fairness", "PointTarget", "DirectionTarget",
                           "CurvatureTarget"), seen_if(is_solved))
    modes.update({
        "WantedLength": SHOWN if obj.WantedLengthFixed else READ_ONLY,
        "Numbers": seen_if(obj.Continuation == GEOMETRIC),
        "Parameter": seen_if(obj.Continuation == REPARAMETRISED),
        "PointVertex": seen_if(is_solved and obj.PointTarget == VERTEX),
        "PointPosition": seen_if(is_solved and obj.PointTarget == POSITION),
        "Direction": seen_if(is_solved and obj.DirectionTarget),
        "Curvature": seen_if(is_solved and obj.CurvatureTarget == MAGNITUDE),
        "CurvatureVector": seen_if(is_solved and obj.CurvatureTarget == VECTOR),
    })
    return modes


def tangential_of(result, order):
    """The tangential coordinates in mm of the poles C_1 ... up to an order, of an extension."""
    poles = result.curve.poles
    tangent = result.reports[0].sides[0].tangent
    return [] if tangent is None else [float((pole - poles[0]) @ tangent)
                                       for pole in poles[1:order + 1]]


def make_extended_curve(doc, source, *, end="end", order=4, degree=None, beta=None, length=None,
                        tangential=None, to_point=None, to_direction=None, to_curvature=None,
                        parametric=False, parameter=None, natural=False, fairness="mvc",
                        include_source=False, name="ExtendedCurve"):
    """Adds an ExtendedCurve to a document and recomputes it.

    doc:     the App.Document
    source:  an (object, "Edge1") pair; the path may lead down an App::Part ("Sketch.Edge1")
    to_point: a point, or an (object, "Vertex1") pair whose vertex is followed
    include_source: True makes the shape a wire of the edge and its continuation
    the others: as for osculate.extend

    Raises ValueError before anything is changed. A link that leads nowhere, and what an extension
    cannot meet, is no error here: the object says so in its Status.
    """
    settings = {"End": _checked_end(end), "IncludeSource": bool(include_source),
                **_extension_settings(order, degree, length, fairness),
                **_contact_settings(order, beta, tangential, parametric, parameter, natural),
                **_target_settings(to_point, to_direction, to_curvature)}
    return make_object(doc, name=name, Source=source, **settings)


def make_object(doc, *, name="ExtendedCurve", **properties):
    """Adds an ExtendedCurve with some of its properties set, and recomputes it."""
    return make(doc, ExtendedCurve, name, **properties)


def _checked_end(end):
    _require(end in END_NAMES, f"end: must be \"start\" or \"end\", not {end!r}")
    return end


def _extension_settings(order, degree, length, fairness):
    most = osculate.MAX_ORDER
    _require(0 <= order <= most, f"order: must be 0 to {most}, not {order}")
    _require(degree is None or 1 <= degree <= MOST_DEGREE,
             f"degree: must be 1 to {MOST_DEGREE}, not {degree}")
    _require(length is None or length > 0.0, f"length: must be > 0, not {length}")
    _require(fairness in FAIRNESS.values(),
             f"fairness: must be \"mvc\", \"bending\" or None, not {fairness!r}")
    settings = {"Order": order, "Degree": degree or 0, "WantedLengthFixed": length is not None,
                "Fairness": "none" if fairness is None else fairness}
    if length is not None:
        settings["WantedLength"] = length
    return settings


def _contact_settings(order, beta, tangential, parametric, parameter, natural):
    given = {"beta": beta is not None, "tangential": tangential is not None,
             "parametric": bool(parametric), "parameter": parameter is not None,
             "natural": bool(natural)}
    chosen = [name for name, is_given in given.items() if is_given]
    _require(len(chosen) <= 1, f"{' and '.join(chosen)}: give one of them")
    if natural or parametric:
        return {"Continuation": NATURAL if natural else PARAMETRIC}
    if parameter is not None:
        least, most = names.LEAST_PARAMETER, names.MOST_PARAMETER
        _require(least <= parameter <= most,
                 f"parameter: must be {least:g} to {most:g}, not {parameter}")
        return {"Continuation": REPARAMETRISED, "Parameter": parameter}
    numbers = next((values for values in (beta, tangential) if values is not None), ())
    kind = "tangential" if tangential is not None else "beta"
    _require(len(numbers) <= order, f"{kind}: an end of order {order} has {order} numbers, got "
                                    f"{len(numbers)}")
    _require(not numbers or numbers[0] is None or numbers[0] > 0.0,
             f"{kind}: the first number must be > 0")
    if tangential is not None:
        return {"Numbers": TANGENTIAL, **tangential_numbers.settings(tangential)}
    return beta_numbers.settings(numbers)


def _target_settings(point, direction, curvature):
    settings = {}
    if point is not None:
        if len(point) == 2:
            settings.update(PointTarget=VERTEX, PointVertex=tuple(point))
        else:
            settings.update(PointTarget=POSITION, PointPosition=FreeCAD.Vector(*point))
    if direction is not None:
        settings.update(DirectionTarget=True, Direction=FreeCAD.Vector(*direction))
        _require(settings["Direction"].Length > 0.0, "to_direction: must not be zero")
    if isinstance(curvature, (int, float)):
        _require(curvature >= 0.0, f"to_curvature: a number must be >= 0, not {curvature}; give a "
                                   "vector for the side it bends to")
        settings.update(CurvatureTarget=MAGNITUDE, Curvature=curvature)
    elif curvature is not None:
        settings.update(CurvatureTarget=VECTOR, CurvatureVector=FreeCAD.Vector(*curvature))
    return settings


def _require(good, message):
    if not good:
        raise ValueError(message)
