"""The dock Curve plot: widgets around a source of edges, a plot, a link to the 3D view."""

import functools
import os

import FreeCAD
import FreeCADGui

from osculate.comb_drawing import size_of
from osculate.features.edge_link import LinkError
from osculate.gui import preferences, resources
from osculate.gui.observers import ModelObserver, SelectionObserver
from osculate.gui.plot.plot_form import PlotForm
from osculate.gui.plot.plot_source import PlotSource
from osculate.gui.plot.plot_words import reading
from osculate.gui.plot.view_link import ViewLink
from osculate.gui.qt import Qt, QtWidgets, translate
from osculate.gui.selection import selected_sources

_NAME = "OsculateCurvePlotDock"  # by which the main window remembers where it was
_SIZE = (950, 400)               # where it is new; pixels at the usual 96 dots per inch
_FILTERS = (("SVG", ".svg"), ("PDF", ".pdf"), ("PNG", ".png"), ("CSV", ".csv"))


class PlotDock(QtWidgets.QDockWidget):
    """Plots what is selected. While it is hidden it watches and draws nothing."""

    def __init__(self, window):
        super().__init__(translate("Osculate", "Curve plot"), window)
        self.setObjectName(_NAME)
        self.setWindowIcon(resources.icon("curve-plot"))
        self.form = PlotForm()
        self.setWidget(self.form)
        self.source = PlotSource()
        self.is_pinned = False     #: the cursor stays where it is
        self._observers, self._link = [], None
        FreeCAD.addDocumentObserver(_Ends(self._document_closed))
        self.form.quantities_changed.connect(self.refresh)
        self.form.follow_toggled.connect(self._follow_toggled)
        self.form.save_requested.connect(self.save)
        self.form.pointed.connect(self._pointed)
        self.form.clicked.connect(self._pin)
        self.form.shown.connect(self._start)
        self.form.hidden.connect(self._stop)

    # Shown and hidden

    def _start(self):
        if not self._observers:
            self._observers = [ModelObserver(self.refresh, lambda _name: None),
                               SelectionObserver(self._selection_changed)]
            self._take_or_refresh()

    def _stop(self):
        for observer in self._observers:
            observer.stop()
        self._observers = []
        self._unlink()

    def _take_or_refresh(self):
        if self.form.follow.isChecked() or not self.source.links:
            self.take_selection()
        self._show_again()

    def _selection_changed(self):
        if self.form.follow.isChecked() or not self.source.links:
            self.take_selection()

    def _follow_toggled(self, follows):
        if follows:
            self.take_selection()

    def take_selection(self):
        """Plots what is selected; says what to select where that does not serve."""
        try:
            links = selected_sources()
        except LinkError as error:
            self.form.advice.say(str(error) + " " + what_to_select(), "warning")
            return
        if not links:
            self.form.advice.say("" if self.source.plot else what_to_select())
            return
        if len({link.document for link in links}) > 1:
            self.form.advice.say(translate("Osculate", "The edges must be in one document."),
                                 "warning")
            return
        self.form.advice.say("")
        if tuple(links) != self.source.links:
            self.source.take(links)
            self._look(keeps_window=False)

    # The plot

    def refresh(self):
        """Follows the model and the wishes of the user."""
        self._look(keeps_window=True)

    def _look(self, keeps_window):
        chosen = preferences.load()
        options = (("order", chosen.order), ("tolerances", chosen.preset))
        if self.source.links and self.source.look(self.form.quantities(), options):
            self._show(keeps_window)

    def _show_again(self):
        """After the dock was hidden."""
        self._look(keeps_window=True)
        if self.source.plot is not None and self._link is None:
            self._show(keeps_window=True)

    def _show(self, keeps_window):
        plot = self.source.plot
        self.is_pinned = False
        self.form.trouble.say(" ".join(self.source.problems),
                              "error" if plot is None else "warning")
        try:
            self.form.show_plot(plot, keeps_window)
        except ImportError as error:
            self.form.trouble.say(str(error), "error")
            return
        self._follow_in_view(plot)

    def _follow_in_view(self, plot):
        if self._link is not None and self._link.document_name != self.source.document:
            self._unlink()
        if plot is None:
            self._unlink()
            return
        if self._link is None:
            self._link = ViewLink(self.source.document)
            self._link.pointed.connect(self._pointed)
        self._link.follow(plot)

    def _unlink(self):
        if self._link is not None:
            self._link.stop()
            self._link = None

    def _document_closed(self, name):
        if name == self.source.document:
            if self._link is not None:
                self._link.forget()
                self._link = None
            self.source.clear()
            self.form.show_plot(None, False)
            self.form.trouble.say("")
            self.form.advice.say(what_to_select())

    # The cursor

    def _pointed(self, s):
        """The mouse is at an arc length, or left."""
        if not self.is_pinned:
            self.point_at(s)

    def _pin(self, s):
        """A click keeps the cursor where it is, or lets it follow the mouse again."""
        self.is_pinned = not self.is_pinned
        self.point_at(s)

    def point_at(self, s):
        """Shows the cursor at an arc length, in the plot and in the 3D view; None: nowhere."""
        plot, canvas = self.source.plot, self.form.canvas
        if plot is None or canvas is None or self._link is None:
            return
        at = None if s is None else plot.at(s)
        self._link.mark(at)
        if at is None:
            canvas.set_cursor_at(None, {})
            self.form.read("")
            return
        quantities = self.form.quantities()
        canvas.set_cursor_at(at.s, {quantity: getattr(at.geometry, quantity)
                                    for quantity in quantities})
        self.form.read(reading(at, quantities, self.source.labels[at.curve],
                               size_of([plot.comb])))

    # Files

    def save(self):
        """Asks for a file and writes the plot to it."""
        path = self.ask_path()
        if not path:
            return
        try:
            self.save_to(path)
        except (OSError, ValueError) as error:
            self.form.advice.say(str(error), "error")
        else:
            self.form.advice.say(translate("Osculate", "Saved to {}").format(path))

    def ask_path(self):
        """The file that the user names, or an empty text."""
        path, chosen = QtWidgets.QFileDialog.getSaveFileName(
            self.form, translate("Osculate", "Save the plot"), "curve-plot.svg",
            ";;".join(f"{name} (*{ending})" for name, ending in _FILTERS))
        if not path or os.path.splitext(path)[1]:
            return path
        path += next((ending for name, ending in _FILTERS if chosen.startswith(name)), ".svg")
        if os.path.exists(path):  # the dialog asked about another name
            self.form.advice.say(translate("Osculate", "{} exists; name it with its ending to "
                                                       "replace it.").format(path), "warning")
            return ""
        return path

    def save_to(self, path):
        """Writes what is seen; on white. Raises OSError, ValueError."""
        from osculate.plot_drawing import PlotLook
        from osculate.gui.plot.plot_words import words
        quantities = self.form.quantities()
        self.source.plot.save(
            path, labels=self.source.labels, size=(9.0, 1.0 + 1.6 * len(quantities)),
            look=PlotLook(words=words()), quantities=quantities, window=self.form.canvas.seen,
            limits=self.form.canvas.limits)


class _Ends:
    """Sees documents go, also while the dock is hidden: others may take their names."""

    def __init__(self, closed):
        self._closed = closed

    def slotDeletedDocument(self, document):
        self._closed(document.Name)


def what_to_select():
    return translate("Osculate", "Select edges, faces, sketches or whole objects to plot them.")


@functools.lru_cache(maxsize=None)
def the_dock():
    """The dock of the main window, made when it is first asked for."""
    window = FreeCADGui.getMainWindow()
    dock = PlotDock(window)
    if not window.restoreDockWidget(dock):
        window.addDockWidget(Qt.DockWidgetArea.BottomDockWidgetArea, dock)
        for size, orientation in zip(_SIZE, (Qt.Orientation.Horizontal, Qt.Orientation.Vertical)):
            window.resizeDocks([dock], [round(size * window.logicalDpiX() / 96)], orientation)
    return dock


def show_dock():
    """Shows the dock in front of others."""
    dock = the_dock()
    dock.show()
    dock.raise_()
    return dock
