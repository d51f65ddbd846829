"""The command Curvature comb."""

from FreeCAD import Qt

from osculate.gui.comb.comb_panel import CombPanel
from osculate.gui.commands.command import ConstructCommand

QT_TRANSLATE_NOOP = Qt.QT_TRANSLATE_NOOP


class CurvatureComb(ConstructCommand):
    """Makes the comb of what is selected, and opens its panel."""

    name = "Osculate_CurvatureComb"
    icon = "curvature-comb"
    panel = CombPanel
    menu_text = QT_TRANSLATE_NOOP("Osculate_CurvatureComb", "Curvature comb")
    tool_tip = QT_TRANSLATE_NOOP(
        "Osculate_CurvatureComb",
        "Shows curvature, torsion or their rates along curves as a comb, which stays in the "
        "document and follows every edit.\nSelect edges, faces, sketches or whole objects.")
