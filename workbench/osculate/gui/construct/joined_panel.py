"""The task panel of Join."""

import sys

from osculate.features.joined_curve import links_of, make_object, property_of
from osculate.gui.construct.construct_panel import ConstructPanel
from osculate.gui.construct.joined_form import JoinedForm
from osculate.gui.construct.link_set import LinkSet
from osculate.gui.qt import translate


class JoinedPanel(ConstructPanel):
    """Makes or edits a JoinedCurve."""

    edge_count = sys.maxsize

    def __init__(self, document, obj=None):
        super().__init__(document, obj)
        self.form.removed.connect(self._remove)
        self.form.moved.connect(self._move)

    def title(self):
        return translate("Osculate", "Join")

    def make_form(self):
        return JoinedForm(self.preferences)

    def make_choice(self):
        return LinkSet(least=2)

    def make_object(self, document, **settings):
        return make_object(document, **settings)

    def links_in(self, obj):
        return links_of(obj)

    def link_settings(self):
        return {"Edges": property_of((link.resolve_object(), link.sub)
                                     for link in self.edges.links)}

    def what_to_select(self):
        return translate("Osculate", "Select the edges of a chain, or a whole wire or sketch; an "
                                     "edge that is selected again is taken out.")

    def _remove(self, indices):
        if len(self.edges.links) - len(indices) < 2:
            self.form.advice.say(translate("Osculate", "At least two edges are joined."), "warning")
            return
        self.edges.remove(indices)
        self._use_edges()

    def _move(self, index, step):
        self.edges.move(index, step)
        self._use_edges()
