"""Points that lie near each other, found in a time that grows with their number alone."""

import math
from collections import defaultdict
from itertools import product
from operator import add


def near_pairs(points, owners, reach):
    """(i, j, distance) with i < j of points of different owners within `reach` mm.

    Points are sorted into cells of the size `reach`: the cost grows with their number, not with its
    square.
    """
    pairs = []
    cells = defaultdict(list)
    for number, point in enumerate(points):
        cell = tuple(math.floor(coordinate / reach) for coordinate in point)
        for other in _neighbours(cells, cell):
            distance = math.dist(points[other], point)
            if owners[other] != owners[number] and distance <= reach:
                pairs.append((other, number, distance))
        cells[cell].append(number)
    return pairs


def _neighbours(cells, cell):
    for step in product((-1, 0, 1), repeat=3):
        yield from cells.get(tuple(map(add, cell, step)), ())
