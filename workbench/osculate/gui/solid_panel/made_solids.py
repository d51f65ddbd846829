"""BezierSolids that a panel makes: they follow its parameters inside one transaction."""

import FreeCADGui

from osculate.features.bezier_solid import make_bezier_solid, settings_of
from osculate.features.properties import set_if_changed


class MadeSolids:
    """As many objects as there are values, in a group where there are several."""

    def __init__(self, document, container=None):
        """container: the App::Part that they belong into."""
        self._document = document
        self._container = container.Name if container else None
        self._names, self._group = [], None
        self._label = None
        self._was_empty = not document.Objects

    def objects(self):
        """The objects that are there."""
        return list(filter(None, map(self._document.getObject, self._names)))

    @property
    def are_gone(self):
        """Whether another one took some of them away."""
        return len(self.objects()) < len(self._names)

    def show(self, values, label):
        """Makes the objects those of some BezierTetrahedra, with a label for new ones."""
        if label != self._label:
            self.remove()
            self._label = label
        is_first = not self._names
        for name in self._names[len(values):]:
            self._document.removeObject(name)
        del self._names[len(values):]
        for obj, value in zip(self.objects(), values):
            for name, setting in settings_of(value).items():
                set_if_changed(obj, name, setting)
        for value in values[len(self._names):]:
            self._add(value)
        self._sort_into_group()
        self._document.recompute(self.objects())
        if is_first and self._was_empty:
            FreeCADGui.SendMsgToActiveView("ViewFit")

    def remove(self):
        """Takes all of them away."""
        for obj in self.objects():
            self._document.removeObject(obj.Name)
        self._names = []
        self._remove_group()

    def _add(self, value):
        obj = make_bezier_solid(self._document, value)
        obj.Label = self._label
        self._names.append(obj.Name)
        if self._container:
            self._document.getObject(self._container).addObject(obj)

    def _sort_into_group(self):
        if len(self._names) < 2:
            self._remove_group()
            return
        group = self._group and self._document.getObject(self._group)
        if group is None:
            group = self._document.addObject("App::DocumentObjectGroup", "BezierSolids")
            group.Label = self._label
            self._group = group.Name
            if self._container:
                self._document.getObject(self._container).addObject(group)
        if group.Group != self.objects():
            group.Group = self.objects()

    def _remove_group(self):
        group = self._group and self._document.getObject(self._group)
        if group:
            group.Group = []
            self._document.removeObject(group.Name)
        self._group = None
