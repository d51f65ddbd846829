"""Which view a document object gets: the GUI says so when it starts; without it there is none.

Nothing in osculate.features imports the GUI.
"""

_makers = {}


def register(kind, maker):
    """From now on `maker(view_object)` gives objects of a proxy class their view providers."""
    _makers[kind] = maker


def give_view(obj):
    """Gives a document object its view provider, if there is a GUI; `maker` sees whether one that
    was loaded has it already.
    """
    maker = _makers.get(type(obj.Proxy))
    if maker is not None and obj.ViewObject is not None:
        maker(obj.ViewObject)
