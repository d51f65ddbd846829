"""How an InterpolatedCurve is seen in the tree, and that a double-click opens its panel."""

from osculate.gui import resources
from osculate.gui.editable_view import EditableView


class InterpolatedCurveView(EditableView):
    """View provider proxy of an InterpolatedCurve; documents name this class."""

    def getIcon(self):
        return resources.icon_path("interpolate")

    def make_panel(self, obj):
        from osculate.gui.construct.interpolated_panel import InterpolatedPanel
        return InterpolatedPanel(obj.Document, obj)
