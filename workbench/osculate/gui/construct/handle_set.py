"""The handles of a construction in the 3D views of its document: drawn, hovered, dragged."""

from osculate.gui.construct.drag_target import DragTarget
from osculate.gui.construct.handle import HandleNode
from osculate.gui.overlays import nodes
from osculate.gui.overlays.scene import SceneOverlay
from osculate.gui.overlays.screen import Screen
from osculate.gui.qt import Signal


class HandleSet(DragTarget):
    """Shows Handles and tells where the user drags them.

    `hot` is the key of a handle; held is (key, distance from the mouse to the knob).
    """

    moved = Signal(object, float)  #: key of a handle, its new distance in mm; while it is dragged
    doubled = Signal(object)       #: key of a handle that was double-clicked

    def __init__(self, text_points):
        super().__init__()
        self._text_points = text_points
        self._overlay = SceneOverlay()
        self._handles = []
        self._extras = ()
        self._drawn, self._nodes = None, {}  # which handles there are; key -> HandleNode

    def show(self, document_name, handles, *extras):
        """Shows Handles, and nodes that belong to them, in all views of a document."""
        self._document, self._handles, self._extras = document_name, list(handles), extras
        if self._watch_new_views():
            self._drawn = None  # into the new view, too
        self._draw()

    def remove(self, document_closes=False):
        """Leaves no trace in any view."""
        self._leave_views()
        self._handles = []
        self._drawn, self._nodes = None, {}
        if document_closes:
            self._overlay.forget()
        self._overlay.remove()

    # What HandleMouse tells; pixels of the device

    def hover(self, view, pixel, density):
        """The mouse is at a pixel; True if a handle is there."""
        hot = self._key_under(view, pixel, density)
        if hot != self.hot:
            self.hot = hot
            self._draw()
        return hot is not None

    def take(self, view, pixel, density):
        """The mouse was pressed; True if a handle was taken."""
        handle = self._handle(self._key_under(view, pixel, density))
        if handle is None:
            return False
        place = self._place(view, handle, pixel)
        if place is None:
            return True  # it points at the viewer: where to is not to be seen
        self._held = handle.key, handle.distance - place
        self.hot = handle.key
        return True

    def drag(self, view, pixel):
        """The mouse moved with a handle."""
        key, offset = self._held
        handle = self._handle(key)
        place = self._place(view, handle, pixel) if handle else None
        if place is not None:
            self.moved.emit(key, place + offset)

    def double_click(self, view, pixel, density):
        key = self._key_under(view, pixel, density)
        if key is not None:
            self.doubled.emit(key)
        return key is not None

    def _key_under(self, view, pixel, density):
        screen = Screen(view)
        near = {handle.key: handle.pixels_from(screen, pixel, density) for handle in self._handles}
        near = {key: distance for key, distance in near.items() if distance is not None}
        return min(near, key=near.get, default=None)

    def _handle(self, key):
        return next((handle for handle in self._handles if handle.key == key), None)

    @staticmethod
    def _place(view, handle, pixel):
        return Screen(view).along(handle.origin, handle.direction, pixel)

    def _draw(self):
        """Moves what is drawn, or draws anew where there are other handles or extras.

        The hot handle is drawn last, over the others.
        """
        kind = (self._document, self.hot, self._extras,
                [(handle.key, handle.color) for handle in self._handles])
        if kind != self._drawn:
            self._drawn = kind
            self._nodes = {handle.key: HandleNode(handle, self._text_points)
                           for handle in sorted(self._handles, key=self._is_hot)}
            self._overlay.show(self._document, nodes.untouchable(
                *self._extras, *(node.node for node in self._nodes.values())))
        for handle in self._handles:
            self._nodes[handle.key].show(handle, self._is_hot(handle))

    def _is_hot(self, handle):
        return handle.key == self.hot
