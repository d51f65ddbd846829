"""How an ExtendedCurve is seen in the tree, and that a double-click opens its panel."""

from osculate.gui import resources
from osculate.gui.editable_view import EditableView


class ExtendedCurveView(EditableView):
    """View provider proxy of an ExtendedCurve; documents name this class."""

    def getIcon(self):
        return resources.icon_path("extend")

    def make_panel(self, obj):
        from osculate.gui.construct.extend_panel import ExtendPanel
        return ExtendPanel(obj.Document, obj)
