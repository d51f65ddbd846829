"""The command To B-Rep solid."""

import FreeCAD
from FreeCAD import Qt

from osculate.features.solid_brep import make_solid_brep
from osculate.gui.commands.command import SolidCommand
from osculate.gui.solid_panel.selected import selected_solids
from osculate.gui.transaction import transaction

QT_TRANSLATE_NOOP = Qt.QT_TRANSLATE_NOOP


class SolidToBRep(SolidCommand):
    """Adds a SolidBRep for each selected solid, which is hidden behind it."""

    name = "Osculate_SolidToBRep"
    icon = "solid-brep"
    menu_text = QT_TRANSLATE_NOOP("Osculate_SolidToBRep", "To B-Rep solid")
    tool_tip = QT_TRANSLATE_NOOP(
        "Osculate_SolidToBRep",
        "Makes Part solids with the exact faces of the selected Bézier solids, which they follow: "
        "for booleans, STEP and all that Part can do.")

    def Activated(self):
        doc = FreeCAD.ActiveDocument
        with transaction(doc, Qt.translate(self.name, self.menu_text)):
            for solid in selected_solids():
                brep = make_solid_brep(doc, solid)
                brep.Label = Qt.translate("Osculate", "{} as B-Rep").format(solid.Label)
                if brep.isValid():
                    solid.Visibility = False
