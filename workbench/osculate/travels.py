"""Curves put one behind the other and travelled from end to end."""

import numpy

from osculate.chains import chains_of
from osculate.combs import comb


class CurveTravel:
    """Curves in chains, in the order and direction of travel, sampled by arc length.

    Arrays have a row for each sample. Numbers of curves are those of the list that was given;
    *places* count the curves in the order of travel.
    """

    def __init__(self, curves, quantities, tolerances, density, tolerance=0.005):
        self.quantities = quantities
        self.chains = chains_of(curves, tolerances)
        self.order = [link.curve for chain in self.chains for link in chain.links]
        self._reversed = [link.is_reversed for chain in self.chains for link in chain.links]
        self._ranges = [curves[number].parameter_range for number in self.order]
        self.curves = [curves[number].reversed() if is_reversed else curves[number]
                       for number, is_reversed in zip(self.order, self._reversed)]
        self.comb = comb(self.curves, density=density, tolerance=tolerance, quantities=quantities)
        self.starts = numpy.concatenate(([0.0], numpy.cumsum(self.comb.lengths)))
        self.length = float(self.starts[-1])
        self.places = numpy.zeros(len(self.comb.parameter), int)
        for first, last, place in self.comb.runs:
            self.places[first:last + 1] = place
        self.s = self.starts[self.places] + self.comb.arc_length

    def place_at(self, s):
        """(place, parameter) at an arc length from the start; beyond the ends the end. At a join
        the side that leaves it. The parameter is that in the direction of travel.
        """
        s = min(max(float(s), 0.0), self.length)
        place = int(numpy.searchsorted(self.starts[1:-1], s, "right"))
        curve = self.curves[place]
        length = min(s - self.starts[place], self.comb.lengths[place], curve.length())
        return place, curve.parameter_at_length(length)

    def arc_length_at(self, place, parameter):
        """The arc length from the start of the travel, of a parameter in the direction of travel;
        beyond the range of the curve that of its end.
        """
        first, last = self._ranges[place]
        if parameter <= first:
            return float(self.starts[place])
        length = self.curves[place].trimmed(first, min(parameter, last)).length()
        return float(self.starts[place] + min(length, self.comb.lengths[place]))

    def own_parameter(self, place, parameter):
        """The parameter of a curve as it was given, from that in the direction of travel."""
        first, last = self._ranges[place]
        own = first + last - parameter if self._reversed[place] else parameter
        return float(min(max(own, first), last))

    def own_parameters(self):
        """(n,) parameters of the samples, of each curve as it was given."""
        own = self.comb.parameter.copy()
        for place in numpy.flatnonzero(self._reversed):
            members = self.places == place
            own[members] = numpy.clip(sum(self._ranges[place]) - own[members],
                                      *self._ranges[place])
        return own
