"""Which point of some curves is seen nearest to a pixel."""

import numpy

_FINER = 16  # points between two samples, where it is looked at more closely


class CurvePicker:
    """Finds points along an osculate.travels.CurveTravel."""

    def __init__(self, travel):
        self._travel = travel
        runs = travel.comb.runs
        inside = numpy.ones(max(len(travel.s) - 1, 0), bool)
        inside[runs[:-1, 1]] = False  # from one run to the next there is no line
        self._first = numpy.flatnonzero(inside)

    def arc_length_at(self, screen, pixel, reach=numpy.inf):
        """The arc length of the point of the curves that a Screen shows nearest to a pixel; None if
        it is farther than `reach`. Pixels are those of the device.
        """
        pixels = screen.pixels_of(self._travel.comb.point)
        line, _, apart = _nearest(pixels[self._first], pixels[self._first + 1], pixel)
        if line is None or apart > reach:
            return None
        return self._refined(screen, pixel, self._first[line])

    def _refined(self, screen, pixel, sample):
        """The arc length of the nearest point between a sample and the next."""
        travel = self._travel
        place = int(travel.places[sample])
        first, last = travel.comb.parameter[sample:sample + 2]
        for _ in range(2):
            parameters = numpy.linspace(first, last, _FINER + 1)
            pixels = screen.pixels_of(travel.curves[place].evaluate(parameters)[:, 0])
            line, share, _ = _nearest(pixels[:-1], pixels[1:], pixel)
            if line is None:
                break
            first, last = parameters[line:line + 2]
        parameter = first if line is None else first + share * (last - first)
        return travel.arc_length_at(place, float(parameter))


def _nearest(first, last, pixel):
    """(number, share, distance) of the line between (n, 2) pixels that is nearest to one, and where
    on it; (None, 0, inf) if none can be seen.
    """
    along = last - first
    with numpy.errstate(invalid="ignore", divide="ignore"):
        share = ((pixel - first) * along).sum(axis=1) / (along ** 2).sum(axis=1)
        share = numpy.clip(numpy.nan_to_num(share), 0.0, 1.0)
        apart = numpy.linalg.norm(first + share[:, None] * along - pixel, axis=1)
    if not len(apart) or numpy.isnan(apart).all():
        return None, 0.0, numpy.inf
    number = int(numpy.nanargmin(apart))
    return number, float(share[number]), float(apart[number])
