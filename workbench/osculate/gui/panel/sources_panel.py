"""The base of the task panels of what is drawn along edges."""

from osculate.gui.observers import SelectionObserver
from osculate.gui.panel.takes_selection import TakesSelection
from osculate.gui.qt import translate
from osculate.gui.selection import selected_sources
from osculate.gui.solid_panel.session_panel import SessionPanel


class SourcesPanel(TakesSelection, SessionPanel):
    """Makes or edits an EdgeOverlay through a SourcesForm; every change is seen at once."""

    def __init__(self, document, form, obj=None):
        super().__init__(document, form, form.windowTitle(), obj)
        form.edited.connect(self._edited)
        form.settled.connect(self.session.settle)
        form.selection_wanted.connect(self.take)
        self._observers.append(SelectionObserver(self.take_selection))

    def make_object(self, document, **settings):
        """Adds the object to the document with some properties set, and returns it."""
        raise NotImplementedError

    def what_to_select(self):
        """A sentence that asks for edges."""
        return translate("Osculate", "Select edges, faces, sketches or whole objects, and press "
                                     "Take selection.")

    def create_from(self, sources):
        self.session.create(self.make_object, Sources=sources)
        return True

    def selected(self):
        """(object, sub) pairs. Raises LinkError for what is in another document, or depends on the
        object.
        """
        links = selected_sources()
        for link in links:
            self.session.require_linkable(link)
        return [(link.resolve_object(), link.sub) for link in links]

    def _edited(self, settings, is_settled):
        self.session.set(**settings)
        if is_settled:
            self.session.settle()

    def show_object(self, obj):
        self.form.show_object(obj)
