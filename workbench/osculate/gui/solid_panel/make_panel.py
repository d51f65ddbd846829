"""The base of panels whose parameters become solids while they are changed."""

from osculate.features.feature import FAILURES
from osculate.gui.qt import translate
from osculate.gui.solid_panel.made_solids import MadeSolids
from osculate.gui.solid_panel.task_panel import TaskPanel


class MakePanel(TaskPanel):
    """Makes BezierSolids of what a form says, at once and at every change."""

    hides_source = False  #: whether the solid that it starts from is hidden

    def __init__(self, document, form, source=None):
        super().__init__(document, form)
        self.document = document
        self.source = source
        self.error = ""
        container = source.getParentGeoFeatureGroup() if source else None
        self.made = MadeSolids(document, container)
        document.openTransaction(form.windowTitle())
        self._was_visible = source is not None and source.Visibility
        if source and self.hides_source:
            source.Visibility = False
        form.edited.connect(self.update)
        self.update()

    # What a subclass does

    def values(self):
        """The BezierTetrahedra that the form asks for, a list. Raises one of FAILURES."""
        raise NotImplementedError

    def label(self):
        """The label of what is made."""
        raise NotImplementedError

    # What all do

    def update(self):
        """Makes what the form asks for; where that cannot be the last solids stay."""
        self.is_busy = True
        try:
            values = self.values()
        except FAILURES as error:
            self.error = str(error)
        else:
            self.error = ""
            self.made.show(values, self.label())
            self.form.advice.say("")
            self.form.show_values(values)
        self.form.show_trouble(self.error)
        self.is_busy = False

    def problem(self):
        if self.error or not self.made.objects():
            return translate("Osculate", "There is nothing to keep yet: mend what is wrong, or "
                                         "Cancel.")
        return ""

    def model_changed(self):
        if self.made.are_gone:
            self.reject()  # undo or another command took them away

    def keep(self):
        self.document.recompute()
        self.document.commitTransaction()

    def take_back(self):
        self.document.abortTransaction()
        self.made.remove()  # if another transaction had ended this one
        if self._was_visible and not self.source.Visibility:
            self.source.Visibility = True
