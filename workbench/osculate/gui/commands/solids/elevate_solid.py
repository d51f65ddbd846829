"""The command Raise degree."""

import FreeCAD
from FreeCAD import Qt

from osculate.features.bezier_solid import settings_of
from osculate.features.control_net import MOST_DEGREE
from osculate.gui.commands.command import SolidCommand
from osculate.gui.solid_panel.selected import selected_solids
from osculate.gui.transaction import transaction

QT_TRANSLATE_NOOP = Qt.QT_TRANSLATE_NOOP


class ElevateSolid(SolidCommand):
    """Gives each selected solid a degree more."""

    name = "Osculate_ElevateSolid"
    icon = "solid-elevate"
    menu_text = QT_TRANSLATE_NOOP("Osculate_ElevateSolid", "Raise degree")
    tool_tip = QT_TRANSLATE_NOOP(
        "Osculate_ElevateSolid",
        "Gives the selected Bézier solids one degree more: they stay as they are and have more "
        "control points.")

    def IsActive(self):
        return super().IsActive() and all(solid.isValid() and solid.Degree < MOST_DEGREE
                                          for solid in selected_solids())

    def Activated(self):
        doc = FreeCAD.ActiveDocument
        with transaction(doc, Qt.translate(self.name, self.menu_text)):
            for solid in selected_solids():
                value = solid.Proxy.restore(solid)
                for name, setting in settings_of(value.elevated()).items():
                    setattr(solid, name, setting)
            doc.recompute()
