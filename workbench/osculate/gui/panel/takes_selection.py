"""Task panels whose object is linked to what is selected."""

import FreeCADGui

from osculate.features.edge_link import LinkError
from osculate.features.edge_overlay import links_of


class TakesSelection:
    """Mixin of a SessionPanel with a form that has `advice` and `show_parts`: the buttons *Take
    selection* and *Add selection*.
    """

    def what_to_select(self):
        """A sentence that says what to select."""
        raise NotImplementedError

    def selected(self):
        """(object, path) pairs of what is selected. Raises LinkError for what cannot be taken."""
        raise NotImplementedError

    def create_from(self, sources):
        """Makes the object of (object, path) pairs; False where that was stopped."""
        raise NotImplementedError

    def take_selection(self):
        """Makes the object of what is selected, if there is none yet."""
        if self.session.obj is None and FreeCADGui.Selection.getSelectionEx("*", 0):
            self.take(adds=False)

    def take(self, adds):
        """Links the object to what is selected: instead of what it had, or as well."""
        try:
            sources = self.selected()
        except LinkError as error:
            self.form.advice.say(str(error), "warning")
            return
        if not sources:
            self.form.advice.say(self.what_to_select())
            return
        if self.session.obj is not None:
            kept = self._sources() if adds else []
            self.session.do(Sources=kept + [source for source in sources if source not in kept])
        elif not self.create_from(sources):
            return
        FreeCADGui.Selection.clearSelection()  # its colour would hide what is drawn
        self.show()

    def _sources(self):
        return [(link.resolve_object(), link.sub) for link in links_of(self.session.obj)]

    def show(self):
        has_object = self.session.obj is not None
        self.form.advice.say("" if has_object else self.what_to_select())
        self.form.show_parts(has_object)
        super().show()

    def accept(self):
        return self.reject() if self.session.obj is None else super().accept()
