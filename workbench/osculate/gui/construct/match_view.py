"""How a MatchedCurve is seen in the tree, and that a double-click opens its panel."""

from osculate.features.matched_curve import show_original
from osculate.gui import resources
from osculate.gui.editable_view import EditableView


class MatchedCurveView(EditableView):
    """View provider proxy of a MatchedCurve; documents name this class."""

    def getIcon(self):
        return resources.icon_path("match")

    def make_panel(self, obj):
        from osculate.gui.construct.match_panel import MatchPanel
        return MatchPanel(obj.Document, obj)

    def onDelete(self, vobj, _subelements):
        """The edge as it was is seen again."""
        if vobj.Object.HideOriginal:
            show_original(vobj.Object, True)
        return True
