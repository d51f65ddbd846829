"""Control points that are dragged in the 3D views of a document, across the line of sight."""

import math

from pivy import coin

from osculate.gui.construct.drag_target import DragTarget
from osculate.gui.overlays import nodes, sprites
from osculate.gui.overlays.screen import Screen
from osculate.gui.qt import Signal

_REACH = 12.0  # pixels around a point in which the mouse takes it


class PointHandles(DragTarget):
    """Tells where the user drags the points; `node` goes into the scene, where they are drawn.

    Pixels are those of the device. `hot` is the number of a point; held is (number, offset in
    pixels from the mouse to the point).
    """

    moved = Signal(int, object)  #: number of a point, its new place (x, y, z); while it is dragged
    hovered = Signal()           #: another point, or none, is at the mouse

    def __init__(self, document_name):
        super().__init__(document_name)
        self._points = []
        self._place = coin.SoTranslation()
        self._mark = coin.SoSeparator()
        self.node = nodes.without_extent(nodes.untouchable(self._place, self._mark))

    def show(self, points, color, caption):
        """Follows the points; `caption` of the hot one, as caption(number) says."""
        self._watch_new_views()
        self._points = points
        self._mark.removeAllChildren()
        if self.hot is None or self.hot >= len(points):
            self.hot = None
            return
        self._place.translation = tuple(map(float, points[self.hot]))
        self._mark.addChild(sprites.ring(color))
        text, text_points = caption(self.hot)
        self._mark.addChild(sprites.caption(text, color, text_points))

    def remove(self):
        """Leaves no trace in any view."""
        self._leave_views()
        self._points = []
        self._mark.removeAllChildren()

    # What HandleMouse tells

    def hover(self, view, pixel, density):
        """The mouse is at a pixel; True if a point is there."""
        hot = self._under(view, pixel, density)
        if hot != self.hot:
            self.hot = hot
            self.hovered.emit()
        return hot is not None

    def take(self, view, pixel, density):
        """The mouse was pressed; True if a point was taken."""
        number = self._under(view, pixel, density)
        if number is None:
            return False
        x, y = Screen(view).pixel_of(self._to_world(view).multVecMatrix(self._vector(number)))
        self._held = number, (x - pixel[0], y - pixel[1])
        if number != self.hot:
            self.hot = number
            self.hovered.emit()
        return True

    def drag(self, view, pixel):
        """The mouse moved with a point: it stays as far from the viewer as it is."""
        number, offset = self._held
        if number >= len(self._points):
            return
        to_world = self._to_world(view)
        place = Screen(view).beneath([a + b for a, b in zip(pixel, offset)],
                                     to_world.multVecMatrix(self._vector(number)))
        if place is not None:
            own = to_world.inverse().multVecMatrix(coin.SbVec3f(*place))
            self.moved.emit(number, tuple(own))

    def double_click(self, _view, _pixel, _density):
        return False

    # Within

    def _under(self, view, pixel, density):
        """The number of the point nearest to a pixel, None if none is in reach."""
        screen, to_world = Screen(view), self._to_world(view)
        nearest, least = None, _REACH * density
        for number in range(len(self._points)):
            x, y = screen.pixel_of(to_world.multVecMatrix(self._vector(number)))
            distance = math.hypot(x - pixel[0], y - pixel[1])
            if distance < least:
                nearest, least = number, distance
        return nearest

    def _vector(self, number):
        return coin.SbVec3f(*map(float, self._points[number]))

    def _to_world(self, view):
        """The matrix from the system that the points are drawn in, as within an App::Part."""
        search = coin.SoSearchAction()
        search.setNode(self.node)
        search.setSearchingAll(True)
        search.apply(view.getSceneGraph())
        path = search.getPath()
        if path is None:
            return coin.SbMatrix.identity()
        matrix = coin.SoGetMatrixAction(coin.SbViewportRegion())
        matrix.apply(path)
        return matrix.getMatrix()
