"""The task panel that makes or edits a CurvatureComb."""

import FreeCADGui

from osculate.features.constructed import refuse_loop
from osculate.features.curvature_comb import automatic_scale_of, links_of, make_object
from osculate.features.edge_link import LinkError
from osculate.gui.comb.comb_form import CombForm
from osculate.gui.observers import SelectionObserver
from osculate.gui.qt import translate
from osculate.gui.selection import selected_sources
from osculate.gui.solid_panel.session_panel import SessionPanel
from osculate.gui.view_wheel import ViewWheel

_NOTCH = 1.12  # how much longer a notch of the wheel makes the teeth


class CombPanel(SessionPanel):
    """Makes or edits a CurvatureComb; every change is seen at once."""

    def __init__(self, document, obj=None):
        form = CombForm()
        super().__init__(document, form, form.windowTitle(), obj)
        form.edited.connect(self._edited)
        form.settled.connect(self.session.settle)
        form.selection_wanted.connect(self._take)
        self._wheel = ViewWheel(document.Name)
        self._wheel.turned.connect(self._wheel_turned)
        self._observers += [self._wheel, SelectionObserver(self.take_selection)]
        self.show()

    def what_to_select(self):
        """A sentence that asks for edges."""
        return translate("Osculate", "Select edges, faces, sketches or whole objects, and press "
                                     "Take selection.")

    def take_selection(self):
        """Makes the comb of what is selected, if there is none yet."""
        if self.session.obj is None and FreeCADGui.Selection.getSelectionEx("*", 0):
            self._take(adds=False)

    def _take(self, adds):
        """Gives the comb what is selected: instead of its edges, or as well."""
        try:
            sources = self._selected()
        except LinkError as error:
            self.form.advice.say(str(error), "warning")
            return
        if not sources:
            self.form.advice.say(self.what_to_select())
            return
        if self.session.obj is None:
            self.session.create(make_object, Sources=sources)
        else:
            kept = self._sources() if adds else []
            self.session.do(Sources=kept + [source for source in sources if source not in kept])
        FreeCADGui.Selection.clearSelection()  # its colour would hide that of the curves
        self.show()

    def _sources(self):
        return [(link.resolve_object(), link.sub) for link in links_of(self.session.obj)]

    def _selected(self):
        """(object, sub) pairs. Raises LinkError for what is in another document, or depends on the
        comb.
        """
        links = selected_sources()
        for link in links:
            if link.document != self.session.document_name:
                raise LinkError(translate("Osculate", "The edges must be in one document, {}.")
                                .format(self.session.document.Label))
            if self.session.obj is not None:
                refuse_loop(self.session.obj, link)
        return [(link.resolve_object(), link.sub) for link in links]

    def _edited(self, settings, is_settled):
        self.session.set(**settings)
        if is_settled:
            self.session.settle()

    def _wheel_turned(self, notches):
        if self.session.obj is not None:
            self.session.do(**self.form.scaled_by(_NOTCH ** notches))

    def model_changed(self):
        self._wheel.watch_new_views()
        super().model_changed()

    def show(self):
        has_object = self.session.obj is not None
        self.form.advice.say("" if has_object else self.what_to_select())
        self.form.show_parts(has_object)
        super().show()

    def show_object(self, obj):
        self.form.show_object(obj, automatic_scale_of(obj))

    def accept(self):
        return self.reject() if self.session.obj is None else super().accept()
