"""The task panel of Extend."""

import FreeCADGui

from osculate.features.constructed import refuse_loop
from osculate.features.edge_link import LinkError
from osculate.features.extended_curve import make_object
from osculate.features.extended_curve_properties import POSITION, VERTEX
from osculate.gui.construct import extend_handles
from osculate.gui.construct.construct_panel import ConstructPanel
from osculate.gui.construct.extend_form import ExtendForm
from osculate.gui.overlays import nodes
from osculate.gui.qt import translate
from osculate.gui.selection import end_near_click, selected_point

_ROOM = 0.02  # around the far end, as a share of the length


class ExtendPanel(ConstructPanel):
    """Makes or edits an ExtendedCurve."""

    edge_count = 1
    edge_names = ("Source",)

    def __init__(self, document, obj=None):
        self._awaits_point = False
        super().__init__(document, obj)
        self.form.targets.pick_toggled.connect(self._await_point)

    def title(self):
        return translate("Osculate", "Extend")

    def make_form(self):
        return ExtendForm(self.preferences)

    def make_object(self, document, **settings):
        return make_object(document, **settings)

    def what_to_select(self):
        return translate("Osculate", "Select the edge that is to go on, near the end where it "
                                     "does, or the vertex there.")

    def link_settings(self):
        """The end nearest to the click is continued."""
        link = self.edges.links[0]
        end = end_near_click(link.resolve())
        return {**super().link_settings(), **({"End": end} if end else {})}

    # The point at which it ends

    def take_selection(self):
        if not self._awaits_point:
            super().take_selection()
            return
        try:
            settings = self._point_settings()
        except LinkError as error:
            self.form.advice.say(str(error), "warning")
            return
        if settings:
            self._awaits_point = False
            self.session.do(**settings)
            FreeCADGui.Selection.clearSelection()

    def _point_settings(self):
        """The target from what is selected: a vertex, or where an edge or a face was clicked."""
        link, point = selected_point()
        if link is not None:
            if link.document != self.session.document_name:
                raise LinkError(translate("Osculate", "The vertex must be in the same document."))
            refuse_loop(self.session.obj, link)
            return {"PointTarget": VERTEX, "PointVertex": (link.resolve_object(), link.sub)}
        return {"PointTarget": POSITION, "PointPosition": point} if point else {}

    def _await_point(self, is_on):
        self._awaits_point = is_on
        if is_on:
            self.edges.await_edge(None)
            FreeCADGui.Selection.clearSelection()
        self.show()

    def _await_edge(self, index):
        self._awaits_point = False
        super()._await_edge(index)
        self.form.targets.show_picking(False)

    def _advise(self):
        if self._awaits_point:
            self.form.advice.say(translate("Osculate", "Click a vertex, which is followed, or a "
                                                       "place on an edge or a face."))
        else:
            super()._advise()

    def show(self):
        super().show()
        self.form.targets.show_picking(self._awaits_point)

    # In the 3D view

    def handles_of(self, obj, result):
        return extend_handles.handles_of(obj, result, self.preferences.side_colors[0])

    def extra_marks(self, obj, result):
        """Room for the handle at the far end, which may be the point nearest to the viewer."""
        return [nodes.room(result.curve.poles[-1], _ROOM * result.energy["length_mm"])]

    def dragged(self, obj, result, key, distance):
        return extend_handles.dragged(result, key, distance)

    def freed(self, key):
        return extend_handles.freed(key)
