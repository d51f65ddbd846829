"""How a JoinedCurve is seen in the tree, and that a double-click opens its panel."""

from osculate.gui import resources
from osculate.gui.editable_view import EditableView


class JoinedCurveView(EditableView):
    """View provider proxy of a JoinedCurve; documents name this class."""

    def getIcon(self):
        return resources.icon_path("join")

    def make_panel(self, obj):
        from osculate.gui.construct.joined_panel import JoinedPanel
        return JoinedPanel(obj.Document, obj)
