"""How a BlendCurve is seen in the tree, and that a double-click opens its panel."""

from osculate.gui import resources
from osculate.gui.editable_view import EditableView


class BlendCurveView(EditableView):
    """View provider proxy of a BlendCurve; documents name this class."""

    def getIcon(self):
        return resources.icon_path("blend")

    def make_panel(self, obj):
        from osculate.gui.construct.blend_panel import BlendPanel
        return BlendPanel(obj.Document, obj)
