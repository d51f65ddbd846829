"""What the panel analyses, how, and what came out: no widgets."""

import math
from dataclasses import dataclass, replace
from typing import Optional

from osculate.features.joins import JoinPlace, analyze_links
from osculate.features.edge_link import LinkError
from osculate.features.tolerance_choice import ToleranceValues, tolerances_of
from osculate.gui.qt import QtCore, Signal


@dataclass(frozen=True)
class Options:
    """How joins are analysed; `values` count where the preset is "custom"."""

    order: int
    preset: str
    values: Optional[ToleranceValues] = None

    def tolerances(self):
        return tolerances_of(self.preset, self.values)


class JoinAnalysis(QtCore.QObject):
    """The joins of the chosen edges and their reports, worst first; one of them is current.

    `changed` follows every analysis. Errors never leave it: they stand in `error`.
    """

    changed = Signal()

    def __init__(self, options):
        super().__init__()
        self.options = options
        self.joins = []      #: (JoinPlace, JoinReport), worst first
        self.error = ""      #: a sentence for the user, empty if the analysis worked
        self._links = []
        self._place = None   #: set where one given place is analysed instead of links
        self._current = None

    @property
    def place(self):
        """The current JoinPlace, or None; also known where its analysis failed."""
        return self._current

    @property
    def report(self):
        """The JoinReport of the current place, or None."""
        return dict(self.joins).get(self._current)

    @property
    def is_one_join(self):
        """Whether ends can be chosen: one join between two edges."""
        return self._place is not None and not self._place.knot

    def take_links(self, links):
        """Takes other edges."""
        if len(links) == 2:
            self.take_place(JoinPlace(*links))
        else:
            self._links, self._place, self._current = list(links), None, None
            self.refresh()

    def take_place(self, place):
        """Takes one given join."""
        self._links, self._place, self._current = [], place, place
        self.refresh()

    def set_options(self, options):
        self.options = options
        self.refresh()

    def set_ends(self, ends):
        """Takes other ends of the one join; None the nearest."""
        self.take_place(replace(self._place, ends=ends))

    def swap(self):
        """Travels the one join the other way: the second edge arrives, the first leaves."""
        place = self._place
        ends = place.ends and place.ends[::-1]
        self.take_place(replace(place, first=place.second, second=place.first, ends=ends))

    def select(self, place):
        """Makes another join of the list the current one."""
        self._current = place
        self.changed.emit()

    def refresh(self):
        """Analyses again, after a change of the model or of the options."""
        self.joins, self.error = [], ""
        try:
            self.joins = sorted(self._analyze(), key=_badness)
        except (LinkError, ValueError, TypeError, RuntimeError) as error:
            self.error = str(error)
        if self._place is None and self._current not in dict(self.joins):
            self._current = self.joins[0][0] if self.joins else None
        self.changed.emit()

    def _analyze(self):
        tolerances = self.options.tolerances()
        if self._place is not None:
            return [(self._place, self._place.analyze(self.options.order, tolerances))]
        return analyze_links(self._links, self.options.order, tolerances) if self._links else []


def _badness(join):
    """Sorts the lowest order first, and among equals that which misses the next one by most."""
    report = join[1]
    following = report.order + 1
    if following >= len(report.residuals):
        return report.order, 0.0
    residual = report.residuals[following]
    share = math.inf if residual is None else residual / report.tolerances[following]
    return report.order, -share
