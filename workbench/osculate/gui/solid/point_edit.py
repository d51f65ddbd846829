"""A drag of a control point: one step of the panel that edits the solid."""

import FreeCAD


class PointEdit:
    """Moves control points of the BezierSolid of a Session."""

    def __init__(self, session):
        self._session = session
        self._has_moved = False

    def move(self, number, place):
        """Puts a point somewhere, as the first or a further move of a drag."""
        obj = self._session.obj
        if obj is not None and number < len(obj.Points):
            self._has_moved = True
            points = obj.Points
            points[number] = FreeCAD.Vector(*place)
            self._session.set(Points=points)

    def finish(self):
        """Ends the drag: what depends on the solid follows."""
        if self._has_moved:
            self._session.settle()
        self._has_moved = False

    def cancel(self):
        """Takes the drag back."""
        if self._has_moved:
            self._session.give_up()
        self._has_moved = False
