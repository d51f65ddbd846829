"""From a row of an audit to Match, and back."""

from dataclasses import dataclass
from typing import Tuple

import FreeCAD
import FreeCADGui

from osculate.features.audit import add_fix, why_not_matched
from osculate.features.edge_link import LinkError
from osculate.gui.construct.match_panel import MatchPanel
from osculate.gui.qt import QtCore, translate
from osculate.gui.task_dock import show_panel


class FixError(Exception):
    """A row cannot be matched; the message is a sentence for the user."""


@dataclass(frozen=True)
class Fix:
    """What Match is asked for: the second of two edges changes."""

    document: str
    audit: str                #: the name of the Audit
    edges: Tuple[int, int]    #: their numbers in the audit
    links: tuple              #: EdgeLinks to the edge that stays and to the one that changes
    ends: Tuple[str, str]     #: which ends of them meet
    order: int
    hides: bool               #: the object of the changed edge, which is nothing but that edge

    @classmethod
    def of(cls, obj, index):
        """The fix of a row of an Audit. Raises FixError where Match cannot help."""
        audited = obj.Proxy.audited(obj)
        row = audited.report.rows[index]
        if row.kind == "knot":
            raise FixError(translate("Osculate", "An inner knot of one edge: Match changes edges "
                                                 "where they meet. Join can smooth it."))
        links = [audited.model.edge_link(number) for number in row.edges]
        ends = list(row.ends)
        try:
            reasons = [why_not_matched(link) for link in links]
            if reasons[1] and not reasons[0]:
                links.reverse()
                ends.reverse()
            elif reasons[1]:
                raise FixError(reasons[1])
            hides = links[1].owner().Shape.countElement("Edge") == 1
        except LinkError as error:
            raise FixError(str(error)) from error
        order = obj.Required if row.order < obj.Required else min(row.order + 1, obj.OrderAsked)
        return cls(obj.Document.Name, obj.Name, row.edges, tuple(links), tuple(ends), order, hides)

    def audit_object(self):
        """The Audit; None if it is gone."""
        document = FreeCAD.listDocuments().get(self.document)
        return document.getObject(self.audit) if document else None


class FixPanel(MatchPanel):
    """Match on the edges of a row. OK also gives the audit the new curve in the place of the edge;
    all is one step of undo. Then the panel of the audit comes back.
    """

    def __init__(self, fix):
        self._fix = fix
        self._is_back = False
        super().__init__(fix.audit_object().Document)
        self.edges.show_links(list(fix.links))
        self._use_edges()

    def link_settings(self):
        settings = super().link_settings()
        if self.session.obj is None:
            settings.update(Order=self._fix.order, ReferenceEnd=self._fix.ends[0],
                            ChangedEnd=self._fix.ends[1], HideOriginal=self._fix.hides)
        return settings

    def accept(self):
        audit = self._fix.audit_object()
        if self.session.obj is not None and not self.session.error and audit is not None:
            add_fix(audit, self.session.obj)
            audit.Document.recompute([audit])
        return super().accept()

    def _end(self):
        super()._end()
        if not self._is_back:
            self._is_back = True
            fix = self._fix
            QtCore.QTimer.singleShot(0, lambda: _reopen(fix))


def begin_later(fix):
    """Opens Match once the panel that is open is gone."""
    QtCore.QTimer.singleShot(0, lambda: _begin(fix))


def _begin(fix):
    if fix.audit_object() is not None and not FreeCADGui.Control.activeDialog():
        show_panel(FixPanel(fix))


def _reopen(fix):
    obj = fix.audit_object()
    if obj is not None and not FreeCADGui.Control.activeDialog():
        obj.ViewObject.Proxy.edit_row(fix.edges)
