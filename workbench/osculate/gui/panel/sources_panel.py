"""The base of the task panels of what is drawn along edges."""

import FreeCADGui

from osculate.features.constructed import refuse_loop
from osculate.features.edge_link import LinkError
from osculate.features.edge_overlay import links_of
from osculate.gui.observers import SelectionObserver
from osculate.gui.qt import translate
from osculate.gui.selection import selected_sources
from osculate.gui.solid_panel.session_panel import SessionPanel


class SourcesPanel(SessionPanel):
    """Makes or edits an EdgeOverlay through a SourcesForm; every change is seen at once."""

    def __init__(self, document, form, obj=None):
        super().__init__(document, form, form.windowTitle(), obj)
        form.edited.connect(self._edited)
        form.settled.connect(self.session.settle)
        form.selection_wanted.connect(self._take)
        self._observers.append(SelectionObserver(self.take_selection))

    def make_object(self, document, **settings):
        """Adds the object to the document with some properties set, and returns it."""
        raise NotImplementedError

    def what_to_select(self):
        """A sentence that asks for edges."""
        return translate("Osculate", "Select edges, faces, sketches or whole objects, and press "
                                     "Take selection.")

    def take_selection(self):
        """Makes the object of what is selected, if there is none yet."""
        if self.session.obj is None and FreeCADGui.Selection.getSelectionEx("*", 0):
            self._take(adds=False)

    def _take(self, adds):
        """Gives the object what is selected: instead of its edges, or as well."""
        try:
            sources = self._selected()
        except LinkError as error:
            self.form.advice.say(str(error), "warning")
            return
        if not sources:
            self.form.advice.say(self.what_to_select())
            return
        if self.session.obj is None:
            self.session.create(self.make_object, Sources=sources)
        else:
            kept = self._sources() if adds else []
            self.session.do(Sources=kept + [source for source in sources if source not in kept])
        FreeCADGui.Selection.clearSelection()  # its colour would hide that of the curves
        self.show()

    def _sources(self):
        return [(link.resolve_object(), link.sub) for link in links_of(self.session.obj)]

    def _selected(self):
        """(object, sub) pairs. Raises LinkError for what is in another document, or depends on the
        object.
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

    def show(self):
        has_object = self.session.obj is not None
        self.form.advice.say("" if has_object else self.what_to_select())
        self.form.show_parts(has_object)
        super().show()

    def show_object(self, obj):
        self.form.show_object(obj)

    def accept(self):
        return self.reject() if self.session.obj is None else super().accept()
