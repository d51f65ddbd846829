"""The task panel of a construction: a form around a session, observers, overlays."""

import FreeCADGui

from osculate.features.edge_link import EdgeLink, LinkError
from osculate.gui import preferences
from osculate.gui.construct.edge_choice import EdgeChoice
from osculate.gui.construct.handle_set import HandleSet
from osculate.gui.construct.marks import CurveMark, edge_marks, join_marks, state_of
from osculate.gui.construct.session import Session
from osculate.gui.construct.step_keys import StepKeys
from osculate.gui.observers import ModelObserver, SelectionObserver
from osculate.gui.panel.transaction_answers import TransactionAnswers
from osculate.gui.qt import translate
from osculate.gui.selection import selected_links


class ConstructPanel(TransactionAnswers):
    """What FreeCADGui.Control shows while a curve is constructed or edited.

    A subclass says what it makes and from how many edges. OK keeps all as one step of undo, Cancel
    leaves the document as it was.
    """

    edge_count = 2    #: how many edges it starts from
    edge_names = ()   #: the properties that link to them

    def __init__(self, document, obj=None):
        self._is_edit = obj is not None
        self._keeps = True
        self.preferences = preferences.load()
        self.edges = self.make_choice()
        self._joins_marked, self._join_marks = None, ()
        self._curve_mark = CurveMark()
        self._last_result = None  # that the handles are of
        title = (translate("Osculate", "Edit {}").format(obj.Label) if obj else self.title())
        self.session = Session(document, title, obj)
        self.handles = HandleSet(self.preferences.label_points)
        self.form = self.make_form()
        self.form.panel = self  # as long as there is a form, there is a panel
        self._observers = [ModelObserver(self._model_changed, self._document_closed,
                                         lambda: self.session.is_busy),
                           SelectionObserver(self.take_selection),
                           StepKeys(self.session.back, self.session.forward)]
        self._connect()
        if obj is not None:
            self._take_links_of(obj)
        self._mark_edges()
        self.show()

    # What a subclass does

    def title(self):
        """The name of what is made, in the user's language."""
        raise NotImplementedError

    def make_form(self):
        """The ConstructForm."""
        raise NotImplementedError

    def make_choice(self):
        """What holds the links that were picked."""
        return EdgeChoice(self.edge_count)

    def selected(self):
        """Links to what is selected. Raises LinkError."""
        return selected_links()

    def links_in(self, obj):
        """The links of an object, None for each that leads nowhere."""
        return [_link_or_none(getattr(obj, name)) for name in self.edge_names]

    def link_settings(self):
        """The properties that follow from the edges, just selected, as a dict."""
        return {name: (link.resolve_object(), link.sub)
                for name, link in zip(self.edge_names, self.edges.links)}

    def make_object(self, document, **settings):
        """Adds the object to the document with some properties set, and returns it."""
        raise NotImplementedError

    def what_to_select(self):
        """A sentence that asks for edges."""
        raise NotImplementedError

    def energies(self):
        """(before, now): what the energies of the curve are compared with, and they themselves."""
        return self.session.energies

    def extra_marks(self, _obj, _result):
        """Nodes that are drawn beside edges, curve, joins and handles."""
        return []

    def handles_of(self, _obj, _result):
        """The Handles of the object and its construction."""
        return []

    def dragged(self, _obj, _result, key, distance):
        """The properties that a handle at a distance asks for, as a dict."""
        raise NotImplementedError

    def freed(self, key):
        """The properties when a handle was double-clicked: what it stands for is chosen again."""
        raise NotImplementedError

    # Edges

    def take_selection(self):
        """Takes what is selected as the edges that are awaited; says what to select where that does
        not serve.
        """
        if self.edges.awaited is None:
            return
        try:
            if self.edges.take(self._single_edges(self.selected())):
                self._use_edges()
        except LinkError as error:
            self.form.advice.say(str(error), "warning")
            return
        self._advise()

    def _single_edges(self, links):
        """The links, if they are edges that were meant one by one."""
        if len(links) > self.edge_count:
            raise LinkError(translate("Osculate", "These are {} edges.").format(len(links))
                            + " " + self.what_to_select())
        for link in links:
            self.session.require_linkable(link)
        return links

    def _use_edges(self):
        """Makes the object once all edges are there, or gives it other ones."""
        if self.edges.is_complete:
            settings = self.link_settings()
            if self.session.obj is None:
                self.session.create(self.make_object, **settings)
            else:
                self.session.do(**settings)
        FreeCADGui.Selection.clearSelection()  # its colour would hide that of the marks
        self._mark_edges()
        self.show()

    def _take_links_of(self, obj):
        self.edges.show_links(self.links_in(obj))

    def _follow_links(self):
        """A step back or another one's edit may have given the object other edges."""
        obj = self.session.obj
        links = self.links_in(obj) if obj else []
        if links and None not in links and links != self.edges.links:
            self.edges.links = links
            self._mark_edges()

    def _await_edge(self, index):
        self.edges.await_edge(index)
        FreeCADGui.Selection.clearSelection()
        self._advise()
        self.form.show_edges(self.edges)

    def _advise(self):
        self.form.advice.say("" if self.edges.awaited is None else self.what_to_select())

    # What happens

    def _connect(self):
        self.session.changed.connect(self.show)
        form = self.form
        form.edited.connect(self._edited)
        form.settled.connect(self.session.settle)
        form.edge_awaited.connect(self._await_edge)
        form.back.clicked.connect(self.session.back)
        form.forward.clicked.connect(self.session.forward)
        self.handles.moved.connect(self._dragged)
        self.handles.let_loose.connect(self.session.settle)
        self.handles.taken_back.connect(self.session.give_up)
        self.handles.doubled.connect(lambda key: self.session.do(**self.freed(key)))
        form.destroyed.connect(self._form_destroyed)  # FreeCAD may close a dialog without asking

    def _edited(self, settings, is_settled):
        self.session.set(**settings)
        if is_settled:
            self.session.settle()

    def _dragged(self, key, distance):
        obj = self.session.obj
        if obj is not None and self._last_result is not None:
            self.session.set(**self.dragged(obj, self._last_result, key, distance))

    def _model_changed(self):
        if self.session.was_made and self.session.obj is None:
            self.reject()  # undo or another command took the object away
        else:
            self._mark_edges()
            self.session.follow_model()

    def show(self):
        """Shows the object as it is now, in the form and in the 3D view."""
        session, form = self.session, self.form
        self._follow_links()
        form.show_edges(self.edges)
        form.show_steps(session.can_go_back, session.can_go_forward)
        form.show_parts(session.obj is not None)
        if session.obj is not None:
            form.show_object(session.obj, session.result)
            form.show_outcome(session.result, session.error, self.energies())
        self._advise()
        self._draw()

    def _draw(self):
        obj, result = self.session.obj, self.session.result
        if result is None and self.handles.is_dragging:
            return  # the way back from where nothing can be made
        self._last_result = result
        handles = self.handles_of(obj, result) if result is not None else []
        extras = self.extra_marks(obj, result) if result is not None else []
        self._mark_joins(result.reports if result is not None else ())
        self._curve_mark.show(result.curve if result is not None else None)
        self.handles.show(self.session.document_name, handles, *self._edge_marks,
                          self._curve_mark.node, *extras, *self._join_marks)

    def _mark_edges(self):
        self._edge_marks = edge_marks(self.edges.links, self.preferences.side_colors)

    def _mark_joins(self, reports):
        state = state_of(reports)
        if state != self._joins_marked:  # while a handle is dragged they stay
            self._joins_marked = state
            self._join_marks = join_marks(reports, self.preferences)

    # The end

    def accept(self):
        if self.session.obj is None:
            return self.reject()
        if self.session.error:
            self.form.advice.say(translate("Osculate", "There is nothing to keep yet: mend what is "
                                                       "wrong, or Cancel."), "error")
            return False
        return self._leave(keeps=True)

    def reject(self):
        return self._leave(keeps=False)

    def _leave(self, keeps):
        self._keeps = keeps
        obj = self.session.obj
        if self._is_edit and obj is not None:
            FreeCADGui.getDocument(obj.Document.Name).resetEdit()  # its end calls `finish`
        else:
            self.finish()
        return True

    def finish(self):
        """Closes the panel; what was done stays, unless it was cancelled."""
        self._end()
        FreeCADGui.Control.closeDialog()

    def _end(self):
        if self._stop(document_closes=False):
            if self._keeps:
                self.session.commit()
            else:
                self.session.cancel()

    def _form_destroyed(self, *_):
        self._keeps = self._is_edit
        self._end()

    def _document_closed(self, name):
        if name == self.session.document_name:
            self._stop(document_closes=True)
            FreeCADGui.Control.closeDialog()

    def _stop(self, document_closes):
        """Ends observers and overlay; False if that was done before."""
        observers, self._observers = self._observers, []
        for observer in observers:
            observer.stop()
        if observers:
            self.handles.remove(document_closes)
        return bool(observers)


def _link_or_none(value):
    try:
        return EdgeLink.of_property(value)
    except LinkError:
        return None
