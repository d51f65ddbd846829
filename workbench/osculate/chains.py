"""Curves put one behind the other: which follow on which, and which are travelled backwards."""

from typing import NamedTuple

import numpy

from osculate import _core
from osculate.near_points import near_pairs

#: An end that meets no other is joined with those within this multiple of the gap tolerance.
NEARNESS = 100.0

#: Such a gap is at most this share of the shorter of both curves: else they are no neighbours.
_WIDEST = 0.25


class ChainLink(NamedTuple):
    """One curve of a chain."""

    curve: int          #: in the list of curves
    is_reversed: bool   #: travelled against its own direction


class Chain(NamedTuple):
    """Curves in the order of travel."""

    links: tuple     #: of ChainLink
    is_closed: bool  #: its last end meets its first start


def chains_of(curves, tolerances):
    """All Chains of a list of Curves, which may be in any order and direction.

    Ends meet within the gap tolerance of `tolerances`; of more than two at one place those go on
    that turn least. An end that meets no other goes on at one within NEARNESS times as much, if
    that is less than a quarter of both curves. The first curve of a chain in the list keeps its
    direction, and a closed chain begins with it; chains come in the order of their first curves.
    """
    partners = _partners(curves, tolerances)
    chains, taken = [], set()
    for curve in range(len(curves)):
        if curve not in taken:
            chain = _chain_through(curve, partners)
            taken.update(link.curve for link in chain.links)
            chains.append(chain)
    return chains


# Ends are numbers: 2 i is the start of curve i, 2 i + 1 its end.

def _partners(curves, tolerances):
    """Which end goes on at which, in both directions."""
    partners = {}
    closed = [number for number, curve in enumerate(curves) if _core.is_closed(curve, tolerances)]
    for curve in closed:
        partners.update({2 * curve: 2 * curve + 1, 2 * curve + 1: 2 * curve})
    for first, second in _preferred(curves, tolerances.gap_mm):
        if first not in partners and second not in partners:
            partners.update({first: second, second: first})
    return partners


def _preferred(curves, gap_mm):
    """Pairs of ends, those that shall be joined first in front."""
    points, directions = [], []
    for curve in curves:
        for parameter, side, sign in zip(curve.parameter_range, ("right", "left"), (-1.0, 1.0)):
            at = curve.geometry(parameter, side)
            points.append(at.point.tolist())
            directions.append(None if at.tangent is None else sign * at.tangent)
    owners = numpy.repeat(numpy.arange(len(curves)), 2).tolist()
    pairs = near_pairs(points, owners, NEARNESS * gap_mm)
    meeting = [pair for pair in pairs if pair[2] <= gap_mm]
    met = {end for *ends, _ in meeting for end in ends}
    widest = [_WIDEST * curve.length() for curve in curves]
    apart = [(first, second, gap) for first, second, gap in pairs
             if met.isdisjoint((first, second))
             and gap <= min(widest[first // 2], widest[second // 2])]
    meeting.sort(key=lambda pair: (_turn(directions, *pair[:2]), pair[:2]))
    apart.sort(key=lambda pair: pair[2])
    return [pair[:2] for pair in meeting + apart]


def _turn(directions, first, second):
    """0 where one end goes straight on at the other, up to 2 where it turns back."""
    one, other = directions[first], directions[second]
    return 1.0 if one is None or other is None else round(1.0 + float(one @ other), 6)


def _chain_through(curve, partners):
    start = 2 * curve
    while start in partners:  # back to where the chain begins
        before = partners[start] ^ 1
        if before == 2 * curve:
            return Chain(_walk(2 * curve, partners), True)
        start = before
    return Chain(_walk(start, partners), False)


def _walk(start, partners):
    """ChainLinks from a curve that is entered at an end, until there is no next or it is reached
    again.
    """
    links, entered = [], start
    while entered is not None:
        links.append(ChainLink(entered // 2, entered % 2 == 1))
        entered = partners.get(entered ^ 1)
        if entered == start:
            break
    return tuple(links)
