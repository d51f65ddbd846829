"""The panel on a JoinCheck: what is changed in it changes the object; Cancel takes it back."""

import FreeCADGui

from osculate.features.edge_link import LinkError
from osculate.features.join_check import configure, is_at, place_of
from osculate.features.tolerance_properties import tolerance_values_in
from osculate.gui.keep import require_one_document
from osculate.gui.panel.join_panel import JoinPanel
from osculate.gui.panel.analysis import Options
from osculate.gui.qt import QtWidgets, button_bits, translate


class EditPanel(JoinPanel):
    """Edits one JoinCheck inside one transaction."""

    can_keep = False

    def __init__(self, obj):
        self._object = obj
        super().__init__()
        self.form.follow.setChecked(False)
        obj.Document.openTransaction(translate("Osculate", "Edit {}").format(obj.Label))
        self._take_object()
        self.analysis.changed.connect(self._write_object)

    def default_options(self):
        obj = self._object
        return Options(obj.OrderAsked, obj.Preset, tolerance_values_in(obj))

    def _take_object(self):
        try:
            self.analysis.take_place(place_of(self._object))
        except LinkError as error:
            self.form.advice.say(f"{error} " + translate("Osculate", "Select two edges."), "error")

    def _write_object(self):
        place, options = self.analysis.place, self.analysis.options
        obj = self._object
        if place is None or (is_at(obj, place) and options == self.default_options()):
            return
        try:
            require_one_document(place, obj.Document.Name)
            first = place.first.resolve_object(), place.first.sub
            second = place.second.resolve_object(), place.second.sub
        except LinkError as error:
            self.form.advice.say(str(error), "error")
            return
        obj.First, obj.Second = first, second
        configure(obj, order=options.order, ends=place.ends, preset=options.preset,
                  values=options.values, knot=place.knot)
        obj.Document.recompute([obj])

    def _follow_toggled(self, follows):
        if follows:
            self.take_selection()

    def getStandardButtons(self):
        buttons = QtWidgets.QDialogButtonBox.StandardButton
        return button_bits(buttons.Ok, buttons.Cancel)

    def accept(self):
        return self._leave()

    def reject(self):
        self._object.Document.abortTransaction()
        return self._leave()

    def _leave(self):
        """Ends the edit mode, whose end calls `finish`."""
        FreeCADGui.getDocument(self._object.Document.Name).resetEdit()
        return True

    def finish(self):
        """Closes the panel and keeps what was changed, unless it was taken back before."""
        self.close()
        self._object.Document.commitTransaction()
        FreeCADGui.Control.closeDialog()
