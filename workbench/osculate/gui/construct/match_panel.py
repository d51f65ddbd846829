"""The task panel of Match."""

import osculate
from osculate.features.departure import NEAREST
from osculate.features.matched_curve import CHANGED_CHOICES, SIDES, make_object
from osculate.gui.construct.construct_panel import ConstructPanel
from osculate.gui.construct.match_form import MatchForm
from osculate.gui.overlays.displacement import displacement_marks
from osculate.gui.qt import translate


class MatchPanel(ConstructPanel):
    """Makes or edits a MatchedCurve."""

    edge_names = SIDES

    def __init__(self, document, obj=None):
        super().__init__(document, obj)
        self.form.swapped.connect(self._swap)

    def title(self):
        return translate("Osculate", "Match")

    def make_form(self):
        return MatchForm(self.preferences)

    def make_object(self, document, **settings):
        return make_object(document, **settings)

    def what_to_select(self):
        return translate("Osculate", "Select the edge that stays, then the edge that is to change "
                                     "so that it meets the first.")

    def energies(self):
        """The edge as it was, and as it is now."""
        result = self.session.result
        if result is None:
            return None, None
        return osculate.energies(self.session.obj.Proxy.original), result.energy

    def _swap(self):
        """The other edge is changed; places inside an edge become the end that lies there."""
        obj = self.session.obj
        ends = obj.ReferenceEnd, obj.ChangedEnd
        self.edges.show_links(self.edges.links[::-1])
        self.session.do(
            Reference=obj.Changed, Changed=obj.Reference, ReferenceEnd=ends[1],
            ChangedEnd=ends[0] if ends[0] in CHANGED_CHOICES else NEAREST)

    def extra_marks(self, obj, result):
        return displacement_marks(obj.Proxy.original, result, self.preferences.label_points)
