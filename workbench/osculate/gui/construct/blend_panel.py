"""The task panel of Blend."""

from osculate.features.blend_curve import SIDES, make_object
from osculate.gui.construct import blend_handles
from osculate.gui.construct.blend_form import BlendForm
from osculate.gui.construct.construct_panel import ConstructPanel
from osculate.gui.construct.porcupine import Porcupine
from osculate.gui.qt import translate


class BlendPanel(ConstructPanel):
    """Makes or edits a BlendCurve."""

    edge_names = SIDES

    def __init__(self, document, obj=None):
        self._porcupine = Porcupine()
        super().__init__(document, obj)
        self.form.combs.toggled.connect(lambda _is_on: self.show())

    def title(self):
        return translate("Osculate", "Blend")

    def make_form(self):
        return BlendForm(self.preferences)

    def make_object(self, document, **settings):
        return make_object(document, **settings)

    def what_to_select(self):
        return translate("Osculate", "Select the two edges that the curve is to connect; the same "
                                     "edge twice closes it.")

    def extra_marks(self, _obj, result):
        if not self.form.combs.isChecked():
            return []
        self._porcupine.show(self.edges.links, result.curve)
        return [self._porcupine.node]

    def handles_of(self, obj, result):
        return blend_handles.handles_of(obj, result, self.preferences.side_colors)

    def dragged(self, obj, result, key, distance):
        return blend_handles.dragged(result, key, distance)

    def freed(self, key):
        return blend_handles.freed(key)
