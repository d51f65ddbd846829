"""Control points that are dragged in the 3D views of a document, across the line of sight."""

import math

import FreeCADGui
from pivy import coin

from osculate.gui.construct.handle_mouse import HandleMouse
from osculate.gui.overlays import nodes, sprites
from osculate.gui.overlays.screen import Screen
from osculate.gui.qt import QtCore, Signal

_REACH = 12.0  # pixels around a point in which the mouse takes it


class PointHandles(QtCore.QObject):
    """Tells where the user drags the points; `node` goes into the scene, where they are drawn.

    HandleMouse brings the mouse of each view; pixels are those of the device.
    """

    moved = Signal(int, object)  #: number of a point, its new place (x, y, z); while it is dragged
    let_loose = Signal()         #: a drag ended
    taken_back = Signal()        #: a drag was broken off
    hovered = Signal()           #: another point, or none, is at the mouse

    def __init__(self, document_name):
        super().__init__()
        self._document = document_name
        self._mice = {}      # 3D view -> HandleMouse
        self._points = []
        self._place = coin.SoTranslation()
        self._mark = coin.SoSeparator()
        self.node = nodes.without_extent(nodes.untouchable(self._place, self._mark))
        self.hot = None      #: number of the point at the mouse
        self._held = None    # (number, offset in pixels from the mouse to the point) of the dragged

    @property
    def is_dragging(self):
        return self._held is not None

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
        for mouse in self._mice.values():
            mouse.stop()
        self._mice = {}
        self._points, self.hot, self._held = [], None, None
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

    def let_go(self):
        """The mouse was released; True if a point was held."""
        if self._held is None:
            return False
        self._held = None
        self.let_loose.emit()
        return True

    def break_off(self):
        """Escape was pressed; True if a point was held."""
        if self._held is None:
            return False
        self._held = None
        self.taken_back.emit()
        return True

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

    def _watch_new_views(self):
        document = FreeCADGui.getDocument(self._document)
        for view in document.mdiViewsOfType("Gui::View3DInventor"):
            if view not in self._mice:
                self._mice[view] = HandleMouse(view, self)
