"""The task panel of Blend."""

from osculate.features.blend_curve import SIDES, make_object
from osculate.gui.construct.blend_form import BlendForm
from osculate.gui.construct.construct_panel import ConstructPanel
from osculate.gui.qt import translate


class BlendPanel(ConstructPanel):
    """Makes or edits a BlendCurve."""

    edge_names = SIDES

    def title(self):
        return translate("Osculate", "Blend")

    def make_form(self):
        return BlendForm(self.preferences)

    def make_object(self, document, **settings):
        return make_object(document, **settings)

    def what_to_select(self):
        return translate("Osculate", "Select the two edges that the curve is to connect.")
