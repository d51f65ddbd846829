"""The task panel of Blend."""

from osculate.features.blend_curve import SIDES, make_object
from osculate.gui import preferences
from osculate.gui.construct.blend_form import BlendForm
from osculate.gui.construct.blend_handles import dragged, freed, handles_of
from osculate.gui.construct.construct_panel import ConstructPanel
from osculate.gui.construct.handle_set import HandleSet
from osculate.gui.qt import translate


class BlendPanel(ConstructPanel):
    """Makes or edits a BlendCurve."""

    edge_names = SIDES

    def __init__(self, document, obj=None):
        self.handles = HandleSet(preferences.load().label_points)
        super().__init__(document, obj)
        self.handles.moved.connect(self._handle_moved)
        self.handles.let_loose.connect(self.session.settle)
        self.handles.taken_back.connect(self.session.give_up)
        self.handles.doubled.connect(lambda key: self.session.do(**freed(key)))

    def title(self):
        return translate("Osculate", "Blend")

    def make_form(self):
        return BlendForm(self.preferences)

    def make_object(self, document, **settings):
        return make_object(document, **settings)

    def what_to_select(self):
        return translate("Osculate", "Select the two edges that the curve is to connect.")

    def show_overlay(self):
        obj, result = self.session.obj, self.session.result
        if result is not None:
            self.handles.show(self.session.document_name,
                              handles_of(obj, result, self.preferences.side_colors))
        elif not self.handles.is_dragging:
            self.handles.remove()

    def remove_overlay(self, document_closes):
        self.handles.remove(document_closes)

    def _handle_moved(self, key, distance):
        if self.session.result is not None:
            self.session.set(**dragged(self.session.result, key, distance))
