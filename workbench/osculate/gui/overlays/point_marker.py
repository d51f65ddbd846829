"""A point of a curve that is looked at: a ring with a label, moved as the mouse moves."""

from pivy import coin

from osculate.gui.overlays import nodes, sprites
from osculate.gui.overlays.placement import CORNERS, in_freest_corner


class PointMarker:
    """One such point; `node` goes into the scene and stays there."""

    def __init__(self, color, text_points):
        self._color, self._text_points = color, text_points
        self._place = coin.SoTranslation()
        self._label = coin.SoSeparator()
        self._content = nodes.separator(self._place, sprites.ring(color), self._label)
        self.node = nodes.untouchable()

    def show(self, point, name="", text="", avoided=()):
        """Marks a point; the label has `name` in a field of the colour, and `text`. It keeps off
        the directions `avoided`. Without a name there is none.
        """
        self._place.translation = tuple(map(float, point))
        self._label.removeAllChildren()
        if name:
            labels = [sprites.callout(name, text, self._color, self._text_points, corner)
                      for corner in CORNERS]
            self._label.addChild(in_freest_corner(labels, list(avoided)))
        if self.node.findChild(self._content) < 0:
            self.node.addChild(self._content)

    def hide(self):
        """Marks nothing."""
        place = self.node.findChild(self._content)
        if place >= 0:
            self.node.removeChild(place)
