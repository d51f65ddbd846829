"""How combs are drawn: which way their teeth point, how long they are, where an envelope breaks."""

import math

import numpy

#: Teeth of curvature and its rates point away from the centre of curvature, those of torsion and
#: its rate along the binormal; negative values point the other way.
_DIRECTIONS = {"curvature": ("normal", -1.0), "curvature_rate": ("normal", -1.0),
               "curvature_rate2": ("normal", -1.0), "torsion": ("binormal", 1.0),
               "torsion_rate": ("binormal", 1.0)}

#: Length dimension of a quantity, 1/mm^n.
DIMENSIONS = {"curvature": 1, "torsion": 1, "curvature_rate": 2, "curvature_rate2": 3,
              "torsion_rate": 2}

#: The longest tooth of an automatic scale, and of any, as a share of the size of the curves.
_LONGEST, LIMIT = 0.25, 0.5

#: Values below this over the size of the curves, to the power of their dimension, are rounding.
_ROUNDING = 1e-6

#: Where the largest value is more than so many times what this share of the length stays below, it
#: does not count: the teeth of a small round would leave nothing to see of the rest.
_USUAL, _OUTSTANDING = 0.95, 20.0


class CombDrawing:
    """The geometry of a comb of one quantity, before it is scaled."""

    def __init__(self, comb, quantity):
        self.comb = comb
        self.values = getattr(comb, quantity)
        self.vectors = _vectors(comb, quantity)  #: (n, 3): teeth at scale 1, NaN: there is none
        self._exists = numpy.isfinite(self.vectors).all(axis=1)
        self.teeth = numpy.flatnonzero(self._exists & (comb.is_tooth | self._ends_run()))

    def _ends_run(self):
        ends = numpy.zeros(len(self.values), bool)
        ends[self.comb.runs[:, :2]] = True
        return ends

    def tips(self, scale, limit):
        """(n, 3) ends of the teeth at a scale in mm per unit, none longer than `limit` mm; and
        (n,) which were cut. With a negative scale they point to the other side.
        """
        is_cut = numpy.abs(self.values * scale) > limit
        factors = numpy.full(len(is_cut), scale)
        factors[is_cut] = math.copysign(limit, scale) / numpy.abs(self.values[is_cut])
        return self.comb.point + factors[:, None] * self.vectors, is_cut

    def lines(self):
        """The samples that the envelope passes, and how many there are in each of its pieces: it
        breaks where a run ends or a value does not exist.
        """
        follows = numpy.zeros(len(self.values), bool)  # a line leads here from the sample before
        follows[1:] = self._exists[1:] & self._exists[:-1]
        follows[self.comb.runs[:, 0]] = False
        leads = numpy.append(follows[1:], False) if len(follows) else follows
        members = numpy.flatnonzero(follows | leads)
        starts = numpy.flatnonzero(~follows[members])
        return members, numpy.diff(numpy.append(starts, len(members)))

    def jumps(self, tolerance=0.01):
        """(k, 2) samples on both sides of knots where the value jumps by more than a share of it.
        """
        runs = self.comb.runs
        same_curve = runs[1:, 2] == runs[:-1, 2]
        pairs = numpy.column_stack((runs[:-1, 1], runs[1:, 0]))[same_curve]
        tips = self.vectors[pairs]
        apart = numpy.linalg.norm(tips[:, 0] - tips[:, 1], axis=1)
        larger = numpy.abs(self.values[pairs]).max(axis=1, initial=0.0)
        return pairs[apart > tolerance * larger + self._rounding()]

    def _rounding(self):
        return 1e-9 * numpy.nanmax(numpy.abs(self.values), initial=0.0)


def _vectors(comb, quantity):
    name, sign = _DIRECTIONS[quantity]
    values = getattr(comb, quantity)
    vectors = sign * values[:, None] * getattr(comb, name)
    vectors[values == 0.0] = 0.0  # has no normal, and needs none
    if quantity == "curvature":
        vectors[numpy.isnan(comb.normal[:, 0]) & numpy.isfinite(values)] = 0.0  # flat to rounding
    return vectors


def size_of(combs):
    """The diagonal of the box around the curves of some combs, mm."""
    points = [comb.point for comb in combs if len(comb.point)]
    if not points:
        return 0.0
    least = numpy.min([part.min(axis=0) for part in points], axis=0)
    most = numpy.max([part.max(axis=0) for part in points], axis=0)
    return float(numpy.linalg.norm(most - least))


def automatic_scale(combs, quantity, size=None):
    """One scale for some combs, in mm of a tooth per unit of the quantity: 1, 2 or 5 times a power
    of ten, so that small edits do not change it. None where all values are zero.

    The longest tooth has 10 to 25 % of `size` (of the curves, if None). A few outstanding values,
    as those of small rounds beside large curves, do not count; their teeth are cut.
    """
    size = size_of(combs) if size is None else size
    reference = max((usual_largest(comb, quantity) for comb in combs), default=0.0)
    if is_rounding(reference, quantity, size):
        return None
    return nice(_LONGEST * size / reference)


def is_rounding(magnitude, quantity, size):
    """Whether a magnitude of a quantity is zero but for rounding, on curves of this size in mm."""
    return magnitude * size ** DIMENSIONS[quantity] <= _ROUNDING


def usual_largest(comb, quantity, members=slice(None), share=_USUAL,
                  outstanding=_OUTSTANDING):
    """The largest magnitude of a quantity on some samples. Where it is more than `outstanding`
    times what a share of the length stays below it is that, without what stands out.
    """
    magnitudes = numpy.abs(getattr(comb, quantity))[members]
    weights = _weights(comb)[members]
    exists = numpy.isfinite(magnitudes)
    magnitudes, weights = magnitudes[exists], weights[exists]
    if not len(magnitudes):
        return 0.0
    largest = float(magnitudes.max())
    if weights[magnitudes < largest / outstanding].sum() < share * weights.sum():
        return largest  # what follows would say so too, but has to sort
    order = numpy.argsort(magnitudes)
    lengths = numpy.cumsum(weights[order])
    usual = magnitudes[order][numpy.searchsorted(lengths, share * lengths[-1])]
    is_outstanding = 0.0 < outstanding * usual < largest
    return float(usual) if is_outstanding else largest


def _weights(comb):
    """The length that each sample stands for."""
    steps = numpy.diff(comb.arc_length)
    inside = numpy.ones(len(steps), bool)
    inside[comb.runs[:-1, 1]] = False  # from one run to the next there is none
    steps = numpy.where(inside, steps, 0.0)
    return 0.5 * (numpy.append(steps, 0.0) + numpy.append(0.0, steps))


def nice(number):
    """The largest of 1, 2, 5 times a power of ten that is not above a number."""
    power = 10.0 ** math.floor(math.log10(number))
    return power * max(step for step in (1.0, 2.0, 5.0) if step <= number / power * (1 + 1e-12))
