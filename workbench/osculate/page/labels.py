"""Numbers beside places of a picture, so that none covers another."""

import math
from typing import NamedTuple

import numpy

_HEIGHT, _DIGIT, _PADDING = 16.0, 7.5, 7.0
_DISTANCES = (20.0, 32.0, 46.0, 62.0, 80.0, 100.0, 125.0, 150.0)
_DIRECTIONS = tuple((math.cos(0.25 * math.pi * i), math.sin(0.25 * math.pi * i))
                    for i in (7, 5, 1, 3, 6, 0, 4, 2))


class Label(NamedTuple):
    """A text in a box."""

    text: str
    place: tuple   #: what it belongs to
    center: tuple  #: of its box
    size: tuple

    def covers(self, other):
        """Whether two boxes overlap."""
        return all(abs(self.center[i] - other.center[i]) < 0.5 * (self.size[i] + other.size[i]) + 2
                   for i in (0, 1))

    def is_inside(self, size):
        return all(0.5 * own + 1 <= middle <= whole - 0.5 * own - 1
                   for own, middle, whole in zip(self.size, self.center, size))

    def has(self, place):
        """Whether the box lies over a place."""
        return all(abs(place[i] - self.center[i]) < 0.5 * self.size[i] + 5 for i in (0, 1))


def placed(texts, places, size):
    """A Label for each text at (n, 2) places of a picture of a size. Where there is no room nearby
    the last position tried is taken: a number that covers another is still better than none.
    """
    places = numpy.asarray(places, float).reshape(-1, 2).tolist()
    labels = []
    for text, place in zip(texts, places):
        labels.append(_free(text, place, labels, places, size))
    return labels


def _free(text, place, labels, places, size):
    box = len(text) * _DIGIT + _PADDING, _HEIGHT
    for distance in _DISTANCES:
        for x, y in _DIRECTIONS:
            label = Label(text, place, (place[0] + distance * x, place[1] + distance * y), box)
            if (label.is_inside(size) and not any(map(label.covers, labels))
                    and not any(map(label.has, places))):
                return label
    return label._replace(center=tuple(min(max(middle, 0.5 * own + 1), whole - 0.5 * own - 1)
                                       for middle, own, whole in zip(label.center, box, size)))
