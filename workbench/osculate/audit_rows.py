"""The rows of an audit as numbers to rank, sort and filter: arrays, so that a hundred thousand rows
take milliseconds.
"""

from dataclasses import dataclass
from typing import Optional

import numpy


@dataclass(frozen=True)
class RowFilter:
    """Which rows are wanted; all conditions must hold."""

    below: Optional[int] = None      #: of lower order than this; 0: the gaps
    deviates_in: Optional[int] = None  #: the residual of this order is at least `least`
    least: float = 0.0               #: mm, degrees, then a share


class AuditRows:
    """All rows of an AuditReport.

    order: the order of continuity of each, -1 for a gap
    residuals: (N, K+1): mm, degrees, then a share; infinite where there is none
    missed_by: by how many tolerances each misses the next order; of one that has all orders asked
        for, what it uses of the last one's tolerance. As the core ranks them.
    rank: from 1, the worst row
    """

    def __init__(self, report, tolerances):
        columns = report.columns()
        self.kind, self.edges, self.point = columns.kind, columns.edges, columns.point
        self.order, self.verdicts, self.residuals = (columns.order, columns.verdicts,
                                                     columns.residuals)
        self.highest = self.residuals.shape[1] - 1
        following = numpy.minimum(self.order + 1, self.highest).astype(int)
        allowed = numpy.array([tolerances.of_order(k) for k in range(self.highest + 1)])
        self.missed_by = (self.residuals[numpy.arange(len(self)), following] / allowed[following])
        worst_first = numpy.lexsort((-self.missed_by, self.order))  # it is stable
        self.rank = numpy.empty(len(self), int)
        self.rank[worst_first] = numpy.arange(1, len(self) + 1)

    def __len__(self):
        return len(self.order)

    def count(self, order):
        """How many rows have this order."""
        return int((self.order == order).sum())

    def chosen(self, wanted):
        """The indices of the rows that a RowFilter wants, ascending."""
        holds = numpy.ones(len(self), bool)
        if wanted.below is not None:
            holds &= self.order < wanted.below
        if wanted.deviates_in is not None and wanted.deviates_in <= self.highest:
            residual = self.residuals[:, wanted.deviates_in]
            holds &= numpy.isfinite(residual) & (residual >= wanted.least)
        return numpy.flatnonzero(holds)

    def worst(self, below=None):
        """The indices of the rows of lower order than `below`, or of all, worst first."""
        members = self.chosen(RowFilter(below=below))
        return members[numpy.argsort(self.rank[members])]

    def sorted(self, members, key, descending=False):
        """Some indices in the order of a key: "rank", "order", "edges", "missed_by", or the number
        of an order, whose residual counts. Equal ones stay worst first; what has no value is last.
        """
        members = members[numpy.argsort(self.rank[members])]
        keys = self._keys(key, members)
        missing = numpy.zeros(len(members), bool)
        if not isinstance(key, str):
            missing = ~numpy.isfinite(keys[-1])
        if descending:
            keys = [-values for values in keys]
        return members[numpy.lexsort((*keys, missing))]

    def _keys(self, key, members):
        """Arrays, the last one first."""
        if key == "edges":
            return [self.edges[members, 1].astype(int), self.edges[members, 0].astype(int)]
        values = self.residuals[:, key] if not isinstance(key, str) else getattr(self, key)
        return [values[members].astype(float)]

    def index_of(self, edges):
        """The worst row of a pair of edges; None if there is none."""
        found = numpy.flatnonzero((self.edges == tuple(edges)).all(axis=1))
        return int(found[numpy.argmin(self.rank[found])]) if len(found) else None
