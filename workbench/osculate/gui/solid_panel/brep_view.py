"""How a SolidBRep is seen in the tree."""

from osculate.gui import resources


class SolidBRepView:
    """View provider proxy of a SolidBRep; documents name this class."""

    def __init__(self, vobj):
        vobj.Proxy = self

    def attach(self, vobj):
        self._object = vobj.Object

    def getIcon(self):
        return resources.icon_path("solid-brep")

    def dumps(self):
        return None

    def loads(self, _state):
        return None

    __getstate__ = dumps
    __setstate__ = loads
