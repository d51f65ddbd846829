"""The handles of an extension: β1 and β2, or the tangential coordinates of two poles, at the join;
its length at the far end.
"""

from osculate.features.extended_curve import tangential_of
from osculate.features.extended_curve_properties import (
    BETA, GEOMETRIC, NATURAL, NONE, tangential_numbers)
from osculate.gui import colors, numbers
from osculate.gui.construct import beta_handles
from osculate.gui.construct.beta_row import with_subscript
from osculate.gui.construct.handle import Handle

_SIDE = ""  # of the properties: there is one end
_TANGENTIAL, _LENGTH = "Tangential", "Length"
_LEAST_SHARE = 0.01  # of the length: how far it shrinks, or pole 1 is pushed, at once


def handles_of(obj, result, color):
    """The Handles of an ExtendedCurve and its construction."""
    handles = []
    if obj.Continuation == GEOMETRIC:
        handles += (beta_handles.handles_at(obj, result, 0, _SIDE, color) if obj.Numbers == BETA
                    else _tangential_handles(obj, result, color))
    if obj.Continuation in (GEOMETRIC, NATURAL) and obj.PointTarget == NONE:
        handles += _length_handles(obj, result)
    return handles


def dragged(result, key, distance):
    """The properties of an ExtendedCurve when a handle is at a distance in mm from its origin."""
    kind, k = key
    length = result.energy["length_mm"]
    if kind == _LENGTH:  # its origin is the far end
        return {"WantedLength": max(length + distance, _LEAST_SHARE * length),
                "WantedLengthFixed": True}
    if kind == _TANGENTIAL:
        return {tangential_numbers.number_name(k):
                max(distance, _LEAST_SHARE * length) if k == 1 else distance,
                tangential_numbers.fixed_name(k): True}
    return beta_handles.dragged(result, 0, key, distance)


def freed(key):
    """The properties when a handle is let go for good."""
    kind, k = key
    if kind == _LENGTH:
        return {"WantedLengthFixed": False}
    if kind == _TANGENTIAL:
        return {tangential_numbers.fixed_name(k): False}
    return beta_handles.freed(key)


def _tangential_handles(obj, result, color):
    origin, direction, _ = beta_handles.end_of(result.curve, 0)
    if direction is None:
        return []
    handles = []
    for k, coordinate in enumerate(tangential_of(result, min(obj.Order, 2)), start=1):
        name = with_subscript("C", k)
        handles.append(Handle(
            key=(_TANGENTIAL, k), origin=origin, direction=direction, foot=0.0,
            distance=coordinate, text=name,
            caption=f"{name}: {numbers.quantity(coordinate, 'mm')}", color=color,
            is_fixed=tangential_numbers.is_fixed(obj, k), is_beside=k == 2))
    return handles


def _length_handles(obj, result):
    origin, inward, _ = beta_handles.end_of(result.curve, 1)
    if inward is None:
        return []
    length = result.energy["length_mm"]
    return [Handle(key=(_LENGTH, 0), origin=origin, direction=tuple(-x for x in inward), foot=0.0,
                   distance=0.0, text="L", caption=f"L = {numbers.quantity(length, 'mm')}",
                   color=colors.MADE, is_fixed=obj.WantedLengthFixed)]
