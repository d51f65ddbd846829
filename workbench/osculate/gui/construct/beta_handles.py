"""The handles of β1 and β2 at an end of a curve, along its tangent there."""

import numpy

from osculate.features import beta_properties
from osculate.gui import numbers
from osculate.gui.construct.beta_row import with_subscript
from osculate.gui.construct.handle import Handle

#: Where the handles are, in chords from the end: that of β1 at β1/3, where a cubic has its pole;
#: that of β2 at 1/3 + β2/20, as far as it moves the pole of a quintic, on a track of its own.
#: Neither depends on the order, the degree or the other, so that a handle stays where it is put.
_FOOT = {1: 0.0, 2: 1.0 / 3.0}
_SHARE = {1: 1.0 / 3.0, 2: 1.0 / 20.0}
_LEAST_BETA_1 = 0.02  # as far as a handle can be pushed


def handles_at(obj, result, index, side, color):
    """The Handles at one end of the curve of an osculate.Construction, with keys (side, k).

    index: 0 for its start, 1 for its end. side: as the properties of the object name the end.
    """
    origin, direction, chord = end_of(result.curve, index)
    if direction is None:
        return []
    handles = []
    for k, beta in enumerate(result.beta[index][:2], start=1):
        name = with_subscript("β", k)
        handles.append(Handle(
            key=(side, k), origin=origin, direction=direction, foot=_FOOT[k] * chord,
            distance=(_FOOT[k] + _SHARE[k] * beta) * chord, text=name,
            caption=f"{name} = {numbers.number(beta)}", color=color,
            is_fixed=getattr(obj, beta_properties.fixed_name(side, k)), is_beside=k == 2))
    return handles


def dragged(result, index, key, distance):
    """The properties of the object when a handle is at a distance in mm from its end."""
    side, k = key
    _, _, chord = end_of(result.curve, index)
    number = (distance / chord - _FOOT[k]) / _SHARE[k]
    return {beta_properties.number_name(side, k): max(number, _LEAST_BETA_1) if k == 1 else number,
            beta_properties.fixed_name(side, k): True}


def freed(key):
    """The properties when a handle is let go for good."""
    return {beta_properties.fixed_name(*key): False}


def end_of(curve, index):
    """(point, unit tangent into the curve or None, chord) of an end."""
    poles = curve.poles
    chord = float(numpy.linalg.norm(poles[-1] - poles[0]))
    derivative = curve.evaluate(curve.parameter_range[index], 1, "left" if index else "right")[1]
    speed = numpy.linalg.norm(derivative)
    sign = -1.0 if index else 1.0
    point = tuple(map(float, poles[-index]))
    direction = tuple(map(float, sign * derivative / speed)) if speed > 0.0 else None
    return point, direction, chord
