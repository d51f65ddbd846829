"""A drag of a control point in the document: one step of undo."""

import FreeCAD

translate = FreeCAD.Qt.translate


class PointEdit:
    """Moves control points of a BezierSolid, each drag in a transaction of its own."""

    def __init__(self, obj):
        self._document, self._name = obj.Document.Name, obj.Name
        self._is_open = False

    @property
    def _obj(self):
        document = FreeCAD.listDocuments().get(self._document)
        return document and document.getObject(self._name)

    def move(self, number, place):
        """Puts a point somewhere, as the first or a further step of a drag."""
        obj = self._obj
        if obj is None:
            return
        if not self._is_open:
            obj.Document.openTransaction(translate("Osculate", "Move control point"))
            self._is_open = True
        points = obj.Points
        points[number] = FreeCAD.Vector(*place)
        obj.Points = points
        obj.recompute()

    def finish(self):
        """Ends the drag: what depends on the solid follows."""
        obj = self._obj
        if self._is_open and obj is not None:
            obj.Document.recompute([obj, *obj.InListRecursive])
            obj.Document.commitTransaction()
        self._is_open = False

    def cancel(self):
        """Takes the drag back."""
        obj = self._obj
        if self._is_open and obj is not None:
            obj.Document.abortTransaction()
            obj.recompute()
            obj.purgeTouched()
        self._is_open = False
