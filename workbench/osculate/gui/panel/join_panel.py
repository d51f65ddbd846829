"""The task panel of Analyze join: widgets around an analysis, an overlay and observers."""

import FreeCAD
import FreeCADGui

from osculate.features.edge_link import LinkError
from osculate.features.join_check import is_at
from osculate.gui import preferences, report_export, zoom
from osculate.gui.keep import keep_join
from osculate.gui.observers import ModelObserver, SelectionObserver
from osculate.gui.overlays.join_overlay import join_overlay
from osculate.gui.overlays.scene import SceneOverlay
from osculate.gui.panel.panel_form import PanelForm
from osculate.gui.panel.analysis import JoinAnalysis, Options
from osculate.gui.qt import QtWidgets, button_bits, translate
from osculate.gui.selection import selected_links, what_to_select


class JoinPanel:
    """What FreeCADGui.Control shows while joins are analysed. Nothing in the document changes
    unless the user keeps a join as an object.
    """

    can_keep = True  #: whether the form offers "Keep as object"

    def __init__(self):
        self.preferences = preferences.load()
        self.analysis = JoinAnalysis(self.default_options())
        self.form = PanelForm(self.analysis.options, self.preferences, self.can_keep)
        self.overlay = SceneOverlay()
        self._kept = []  # names of the checks that were added from here
        self._observers = [ModelObserver(self.analysis.refresh, self._document_closed),
                           SelectionObserver(self._selection_changed)]
        self.analysis.changed.connect(self._show)
        self.form.destroyed.connect(self.close)  # FreeCAD may close a dialog without asking
        self._connect_form()

    def default_options(self):
        return Options(self.preferences.order, self.preferences.preset)

    def _connect_form(self):
        form, analysis = self.form, self.analysis
        form.edges.ends_chosen.connect(analysis.set_ends)
        form.edges.swapped.connect(analysis.swap)
        form.joins.chosen.connect(analysis.select)
        form.joins.activated.connect(self._zoom)
        form.tolerances.changed.connect(analysis.set_options)
        form.actions.copy_requested.connect(self.copy)
        form.actions.save_requested.connect(self.save)
        form.actions.keep_requested.connect(self.keep)
        form.follow.toggled.connect(self._follow_toggled)

    def _selection_changed(self):
        if self.form.follow.isChecked() or self.analysis.place is None:
            self.take_selection()

    def take_selection(self):
        """Analyses what is selected; says what to select where that does not serve."""
        try:
            links = selected_links()
        except LinkError as error:
            self.form.advice.say(str(error), "warning")
            return
        if links:
            self._take_links(links)
        else:
            self.form.advice.say("" if self.analysis.place else what_to_select())

    def _take_links(self, links):
        self.form.advice.say("")
        self.analysis.take_links(links)
        if len(links) == 1 and not self.analysis.joins and not self.analysis.error:
            self.form.advice.say(translate("Osculate", "{} has no inner joins. Hold Ctrl and "
                                                       "select the edge that it meets.")
                                 .format(links[0].label()))

    def _show(self):
        self.form.show_analysis(self.analysis)
        report, place = self.analysis.report, self.analysis.place
        if report is None:
            self.overlay.clear()
        else:
            self.overlay.show(place.first.document, join_overlay(
                report, self.preferences, labelled=not self._has_label(place)))

    def _has_label(self, place):
        """Whether a check that was kept here already labels the place."""
        document = FreeCAD.getDocument(place.first.document)
        checks = filter(None, map(document.getObject, self._kept))
        return any(is_at(check, place) and check.Visibility for check in checks)

    def _zoom(self, place):
        self.analysis.select(place)
        zoom.zoom_to(self.analysis.report)

    def _follow_toggled(self, follows):
        preferences.parameters().SetBool("FollowSelection", follows)
        if follows:
            self.take_selection()

    def copy(self, kind):
        """Puts the current report as "text", or all as "json" or "csv", on the clipboard."""
        text = (str(self.analysis.report) if kind == "text"
                else report_export.text_of(self.analysis.joins, kind))
        QtWidgets.QApplication.clipboard().setText(text)

    def save(self):
        """Asks for a file and writes all joins to it."""
        path = self.ask_path()
        if not path:
            return
        try:
            report_export.save(self.analysis.joins, path)
        except (OSError, ValueError) as error:
            self.form.advice.say(str(error), "error")
        else:
            self.form.advice.say(translate("Osculate", "Saved to {}").format(path))

    def ask_path(self):
        """The file that the user names, or an empty text."""
        return QtWidgets.QFileDialog.getSaveFileName(
            self.form, translate("Osculate", "Save the joins"), "joins.csv",
            "CSV (*.csv);;JSON (*.json)")[0]

    def keep(self):
        """Adds the current join to its document as a JoinCheck, in one step of undo."""
        try:
            obj = keep_join(self.analysis.place, self.analysis.options)
        except LinkError as error:
            self.form.advice.say(str(error), "error")
            return
        self._kept.append(obj.Name)
        self._show()
        self.form.advice.say(translate("Osculate", "{} was added to the document.")
                             .format(obj.Label))

    def _document_closed(self, name):
        place = self.analysis.place
        if place is not None and name in (place.first.document, place.second.document):
            self.overlay.forget()
            self.reject()

    def close(self, *_):
        """Leaves no trace: observers and overlay go. May be called again."""
        for observer in self._observers:
            observer.stop()
        self._observers = []
        self.overlay.remove()

    # What FreeCAD asks of a task panel:

    def getStandardButtons(self):
        return button_bits(QtWidgets.QDialogButtonBox.StandardButton.Close)

    def isAllowedAlterDocument(self):
        return True

    def isAllowedAlterSelection(self):
        return True

    def isAllowedAlterView(self):
        return True

    def needsFullSpace(self):
        return True

    def reject(self):
        self.close()
        FreeCADGui.Control.closeDialog()
        return True
