"""The base of panels of Bézier solids around one object with steps back and forward."""

import FreeCADGui

from osculate.gui.construct.session import Session
from osculate.gui.construct.step_keys import StepKeys
from osculate.gui.qt import translate
from osculate.gui.solid_panel.task_panel import TaskPanel


class SessionPanel(TaskPanel):
    """Edits an object, or makes one where none is given; `session` knows it.

    Its form is told by `show_object` whenever the object is another one.
    """

    def __init__(self, document, form, title, obj=None):
        self._is_edit = obj is not None
        self.session = Session(document, title, obj)
        super().__init__(document, form, ends_well=self._is_edit)
        self._observers.append(StepKeys(self.session.back, self.session.forward))
        self.session.changed.connect(self.show)

    # What a subclass does

    def show_object(self, obj):
        """Shows the object as it is now."""
        raise NotImplementedError

    # What all do

    def show(self):
        """Shows the object, if there is one, and why it has no result."""
        obj = self.session.obj
        if obj is not None:
            self.show_object(obj)
            self.form.show_trouble(self.session.error)

    def works(self):
        return self.is_busy or self.session.is_busy

    def model_changed(self):
        if self.session.was_made and self.session.obj is None:
            self.reject()  # undo or another command took the object away
        else:
            self.session.follow_model()

    def problem(self):
        if self.session.error:
            return translate("Osculate", "There is nothing to keep yet: mend what is wrong, or "
                                         "Cancel.")
        return ""

    def keep(self):
        self.session.commit()

    def take_back(self):
        self.session.cancel()

    def close(self):
        document = FreeCADGui.getDocument(self.document_name)
        if self._is_edit and document.getInEdit():
            document.resetEdit()  # its end calls `finish`
        else:
            super().close()
