"""The task panel of Interpolate."""

import sys

import FreeCAD

from osculate.features.edge_link import LinkError
from osculate.features.interpolated_curve import (
    links_of, make_object, own_tensions, points_of, property_of)
from osculate.gui.construct.construct_panel import ConstructPanel
from osculate.gui.construct.interpolated_form import InterpolatedForm
from osculate.gui.construct.link_set import LinkSet
from osculate.gui.construct.marks import point_marks
from osculate.gui.qt import translate
from osculate.gui.selection import selected_vertices


class InterpolatedPanel(ConstructPanel):
    """Makes or edits an InterpolatedCurve."""

    edge_count = sys.maxsize

    def __init__(self, document, obj=None):
        super().__init__(document, obj)
        self.form.removed.connect(self._remove)
        self.form.moved.connect(self._move)
        self.form.added.connect(self._add)

    def title(self):
        return translate("Osculate", "Interpolate")

    def make_form(self):
        return InterpolatedForm(self.preferences)

    def make_choice(self):
        return LinkSet(least=2)

    def make_object(self, document, **settings):
        return make_object(document, **settings)

    def selected(self):
        return selected_vertices()

    def links_in(self, obj):
        return links_of(obj)

    def link_settings(self):
        return {"Vertices": property_of((link.resolve_object(), link.sub)
                                        for link in self.edges.links)}

    def what_to_select(self):
        return translate("Osculate", "Select the vertices that the curve is to run through, or an "
                                     "object for all its vertices; one that is selected again is "
                                     "taken out. Or add points by their coordinates with ＋.")

    def extra_marks(self, _obj, _result):
        return self._point_marks()  # over the curve, which would hide the numbers

    def _mark_edges(self):
        self._edge_marks = self._point_marks() if self.session.result is None else []

    def _mark_joins(self, _reports):
        """Inner knots are always G2: rings would only hide the numbers."""

    def _point_marks(self):
        return point_marks(self._points(), self.preferences.side_colors[0])

    def _points(self):
        """The points of the object, or of the vertices that were picked so far."""
        try:
            if self.session.obj is not None:
                return points_of(self.session.obj)
            return [link.resolve().Point for link in self.edges.links]
        except LinkError:
            return []  # the panel says what is wrong

    def show(self):
        self._mark_edges()
        super().show()

    # Points

    def _remove(self, indices):
        obj = self.session.obj
        count = len(self._points())
        if count - len(indices) < 2:
            self.form.advice.say(translate("Osculate", "At least two points are needed."),
                                 "warning")
            return
        left = [index for index in range(count) if index not in indices]
        self._keep(obj, left)

    def _move(self, index, step):
        order = list(range(len(self._points())))
        if 0 <= index + step < len(order):
            order.insert(index + step, order.pop(index))
            self._keep(self.session.obj, order)

    def _keep(self, obj, order):
        """Keeps the points of these numbers in this order, each with its tension."""
        own = own_tensions(obj, len(self._points()))
        settings = {"Tensions": [own[index] for index in order]}
        if self.edges.links:
            self.edges.links = [self.edges.links[index] for index in order]
            settings.update(self.link_settings())
        else:
            settings["Points"] = [obj.Points[index] for index in order]
        self.session.do(**settings)

    def _add(self):
        """A point as far behind the last one as that is behind the one before it."""
        points = self._points()
        if len(points) < 2:
            self.session.create(self.make_object, Points=_FIRST_POINTS)
            self.edges.await_edge(None)
            self.edges.awaited = None
            self.show()
            return
        self.session.do(Points=[*points, points[-1] * 2.0 - points[-2]])


_FIRST_POINTS = [FreeCAD.Vector(x, y, 0) for x, y in ((0, 0), (20, 10), (40, 0))]
