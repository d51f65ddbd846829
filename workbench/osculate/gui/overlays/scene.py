"""Puts an overlay into the 3D views of a document and takes it out again."""

import FreeCADGui
from pivy import coin


class SceneOverlay:
    """One overlay, in every 3D view of the document that it is shown in."""

    def __init__(self):
        self._root = coin.SoSeparator()
        self._root.setName("OsculateOverlay")
        self._scenes = []
        self._document = None

    def show(self, document_name, node):
        """Shows a node instead of what was shown before."""
        if document_name != self._document:
            self.remove()
            self._document = document_name
        self._enter_new_views()
        self.clear()
        self._root.addChild(node)

    def clear(self):
        """Shows nothing."""
        self._root.removeAllChildren()

    def remove(self):
        """Leaves no trace in any view."""
        self.clear()
        for scene in self._scenes:
            scene.removeChild(self._root)
        self.forget()

    def forget(self):
        """The document is closing: its views are gone or going."""
        self._scenes = []
        self._document = None

    def _enter_new_views(self):
        document = FreeCADGui.getDocument(self._document)
        for view in document.mdiViewsOfType("Gui::View3DInventor"):
            scene = view.getSceneGraph()
            if scene.findChild(self._root) < 0:
                scene.addChild(self._root)
                self._scenes.append(scene)
