"""The task panel that makes or edits an Audit."""

import os
import tempfile

import FreeCADGui

from osculate.features.audit import make_object
from osculate.features.audited_model import whole_shape
from osculate.features.constructed import refuse_loop
from osculate.features.edge_link import EdgeLink, LinkError
from osculate.features.long_work import Stopped
from osculate.gui import preferences, zoom
from osculate.gui.audit.audit_form import AuditForm, sources_text
from osculate.gui.audit.fix import Fix, FixError, begin_later
from osculate.gui.audit.page_picture import save_view, waiting
from osculate.gui.observers import SelectionObserver
from osculate.gui.overlays.join_overlay import join_overlay
from osculate.gui.overlays.scene import SceneOverlay
from osculate.gui.panel.takes_selection import TakesSelection
from osculate.gui.qt import QtWidgets, translate
from osculate.gui.selection import plain_path
from osculate.gui.solid_panel.session_panel import SessionPanel

_FILTERS = {"csv": "CSV (*.csv)", "json": "JSON (*.json)", "html": "HTML (*.html)"}


class AuditPanel(TakesSelection, SessionPanel):
    """Makes or edits an Audit; every change is seen at once."""

    def __init__(self, document, obj=None):
        self.preferences = preferences.load()
        self.overlay = SceneOverlay()
        form = AuditForm(self.preferences)
        super().__init__(document, form, form.windowTitle(), obj)
        self._joined = None  # (Audited, index): the row that the overlay shows
        form.edited.connect(lambda settings: self.session.do(**settings))
        form.selection_wanted.connect(self.take)
        form.row_chosen.connect(self._row_chosen)
        form.row_wanted.connect(lambda index: self.go_to(index, zooms=True))
        form.match_wanted.connect(self.match)
        form.export_wanted.connect(self.export)
        self._observers.append(SelectionObserver(self.take_selection))
        self.show()

    # The objects

    def what_to_select(self):
        """A sentence that asks for objects."""
        return translate("Osculate", "Select objects, and press Take selection: their joins are "
                                     "audited.")

    def create_from(self, sources):
        options = self.preferences
        try:
            self.session.create(_make_complete, Sources=sources, OrderAsked=options.order,
                                Preset=options.preset, Required=min(1, options.order))
        except Stopped:
            self.reject()  # the document is as it was
            return False
        return True

    def selected(self):
        """(object, path) pairs of what is selected, whole. Raises LinkError for what has no edges,
        is in another document, or depends on the audit.
        """
        links = {}
        for selected in FreeCADGui.Selection.getSelectionEx("*", 0):
            for sub in selected.SubElementNames or ("",):
                path, dot, _ = plain_path(sub).rpartition(".")
                links[EdgeLink.of(selected.Object, path + dot)] = None
        for link in links:
            self._require(link)
        return [(link.resolve_object(), link.sub) for link in links]

    def _require(self, link):
        if link.document != self.session.document_name:
            raise LinkError(translate("Osculate", "The objects must be in one document, {}.")
                            .format(self.session.document.Label))
        if not whole_shape(link).Edges:
            raise LinkError(translate("Osculate", "{} has no edges.").format(link.owner().Label))
        if self.session.obj is not None:
            refuse_loop(self.session.obj, link)

    # What is shown

    def model_changed(self):
        if not self.works():
            super().model_changed()

    def show_object(self, obj):
        self.form.show_object(obj)
        self._mark_current()

    # The current row

    @property
    def audited(self):
        obj = self.session.obj
        return obj.Proxy.audited(obj) if obj is not None else None

    def show_row(self, edges):
        """Goes to the worst join of a pair of edges, if there is one."""
        index = self.audited.rows.index_of(edges) if self.audited is not None else None
        if index is not None:
            self.form.table.show_current(index)
            self.go_to(index, self.form.zoom.isChecked())

    def _row_chosen(self, index):
        self.go_to(index, self.form.zoom.isChecked())

    def go_to(self, index, zooms):
        """Selects the edges of a row and shows its join; goes there in the 3D view, or not."""
        FreeCADGui.Selection.clearSelection()
        try:
            for link in self._links(index):
                FreeCADGui.Selection.addSelection(link.resolve_object(), link.sub)
        except LinkError as error:
            self.form.advice.say(str(error), "warning")
        report = self._mark_current()
        if zooms and report is not None:
            zoom.zoom_to(report)

    def _links(self, index):
        edges = self.audited.rows.edges[index].tolist()
        return [self.audited.model.edge_link(number) for number in dict.fromkeys(edges)]

    def _mark_current(self):
        """Draws the join of the current row and says whether it can be matched; returns its
        JoinReport, or None.
        """
        index, audited = self.form.table.current, self.audited
        if index is None or audited is None:
            self._joined = None
            self.overlay.clear()
            self.form.show_match(None)
            return None
        report = audited.report.analyze(audited.report.rows[index])
        if self._joined != (audited, index):
            self._joined = audited, index
            self.overlay.show(self.document_name, join_overlay(report, self.preferences))
            self.form.show_match(self._why_not_matched(index))
        return report

    def _why_not_matched(self, index):
        try:
            Fix.of(self.session.obj, index)
        except FixError as error:
            return str(error)
        return ""

    # What can be done

    def match(self):
        """Keeps the audit, and opens Match on the current row; then the panel comes back."""
        index = self.form.table.current
        try:
            fix = Fix.of(self.session.obj, index)
        except FixError as error:
            self.form.advice.say(str(error), "warning")
            return
        if self.accept():
            begin_later(fix)

    def export(self, kind):
        """Asks for a file and writes all joins to it: "csv" or "json"; or "html", a page."""
        path = self.ask_path(kind) if self.audited is not None else ""
        if not path:
            return
        report = self.audited.report
        write = {"csv": report.to_csv, "json": report.to_json, "html": self._write_page}[kind]
        try:
            write(path)
        except OSError as error:
            self.form.advice.say(translate("Osculate", "{} cannot be written: {}").format(
                path, error.strerror or error), "error")
        else:
            self.form.advice.say(translate("Osculate", "Saved to {}").format(path))

    def _write_page(self, path):
        with tempfile.TemporaryDirectory() as folder, waiting():
            pictures = []
            if self.form.with_view.isChecked():
                picture = os.path.join(folder, "view.png")
                if save_view(self.document_name, picture):
                    pictures.append((picture, translate("Osculate", "The 3D view")))
            self.audited.report.to_html(path, title=sources_text(self.session.obj),
                                        pictures=pictures)

    def ask_path(self, kind):
        """The file that the user names, or an empty text."""
        return QtWidgets.QFileDialog.getSaveFileName(
            self.form, translate("Osculate", "Save the joins"),
            f"{self.session.obj.Label}.{kind}", _FILTERS[kind])[0]

    # The end

    def stop(self, document_closes=False):
        if document_closes:
            self.overlay.forget()
        else:
            self.overlay.remove()
        return super().stop(document_closes)


def _make_complete(document, **settings):
    """Makes an Audit. Raises Stopped where the user stops it."""
    obj = make_object(document, **settings)
    if obj.Proxy.was_stopped:
        raise Stopped(obj.Proxy.error)
    return obj
