"""Legends at the upper left of the 3D view, which stand side by side."""

import FreeCAD
from pivy import coin

from osculate.gui.overlays import nodes

_CORNER = (-0.999, 0.999, 0.0)  # upper left, in the legend's own camera


class Legends:
    """The legends of one document, from left to right."""

    _of_document = {}  # name -> the Legends
    _observer = None

    @classmethod
    def of(cls, document_name):
        if cls._observer is None:
            cls._observer = _Ends()
            FreeCAD.addDocumentObserver(cls._observer)
        return cls._of_document.setdefault(document_name, cls())

    @classmethod
    def forget(cls, document_name):
        cls._of_document.pop(document_name, None)

    @classmethod
    def forget_object(cls, obj):
        """An object was deleted."""
        legends = cls._of_document.get(obj.Document.Name)
        for legend in list(legends) if legends else ():
            if legend.object_name == obj.Name:
                legend.remove()

    def __init__(self):
        self._legends = []

    def __iter__(self):
        return iter(self._legends)

    def place(self, legend):
        """Gives a legend its place, at the right of those that are there."""
        if legend not in self._legends:
            self._legends.append(legend)
        self._arrange()

    def remove(self, legend):
        """The others close up."""
        if legend in self._legends:
            self._legends.remove(legend)
            self._arrange()

    def _arrange(self):
        left = 0
        for legend in self._legends:
            left = legend.draw(left)


class _Ends:
    """Sees objects go, and documents, whose names others may take."""

    def slotDeletedObject(self, obj):
        Legends.forget_object(obj)

    def slotDeletedDocument(self, document):
        Legends.forget(document.Name)


class Legend:
    """Explains what is drawn of an object; `node` goes into the scene.

    picture: a function of what it shows, the size of the text in points, and how many points from
        the side it stands; it returns a node that hangs from its upper left corner, and where the
        picture ends.
    """

    def __init__(self, document_name, object_name, picture):
        self.object_name = object_name
        self._make_picture = picture
        self._legends = Legends.of(document_name)
        self._picture = coin.SoSeparator()
        self._content = None
        place = coin.SoTranslation()
        place.translation = _CORNER
        self.node = nodes.without_extent(nodes.untouchable(_camera(), place, self._picture))

    @property
    def is_shown(self):
        return self in self._legends

    def show(self, what, text_points):
        """Shows what `picture` takes, in text of a size."""
        content = what, text_points
        if content != self._content or self not in self._legends:
            self._content = content
            self._legends.place(self)

    def remove(self):
        """Draws nothing until it is shown again."""
        self._legends.remove(self)
        self._picture.removeAllChildren()

    def draw(self, left):
        """Draws it `left` points from the side; returns where the next one begins."""
        picture, right = self._make_picture(*self._content, left)
        self._picture.removeAllChildren()
        self._picture.addChild(picture)
        return right


def _camera():
    """A camera that sees -1 to 1 in both directions, whatever the view shows."""
    camera = coin.SoOrthographicCamera()
    camera.viewportMapping = coin.SoCamera.LEAVE_ALONE
    camera.position = (0.0, 0.0, 1.0)
    camera.nearDistance, camera.farDistance, camera.height = 0.1, 10.0, 2.0
    return camera
