"""Rings around control points in the 3D view."""

import FreeCAD

from osculate.gui import colors
from osculate.gui.overlays import nodes, sprites
from osculate.gui.overlays.scene import SceneOverlay


class PointMarks:
    """Shows which points are meant."""

    def __init__(self):
        self._overlay = SceneOverlay()

    def show(self, obj, rows):
        """Marks control points of a BezierSolid by their numbers."""
        points = obj.Points
        self.show_places(obj, [points[row] for row in rows if row < len(points)])

    def show_places(self, obj, places, color=colors.SIDES[0]):
        """Marks places in the coordinates of a BezierSolid."""
        container = obj.getParentGeoFeatureGroup()
        placement = container.getGlobalPlacement() if container else FreeCAD.Placement()
        rings = [nodes.at(placement.multVec(place), sprites.ring(color)) for place in places]
        self._overlay.show(obj.Document.Name,
                           nodes.without_extent(nodes.untouchable(*rings)))

    def remove(self, document_closes=False):
        """Leaves no trace, in views that stay."""
        if document_closes:
            self._overlay.forget()
        else:
            self._overlay.remove()
