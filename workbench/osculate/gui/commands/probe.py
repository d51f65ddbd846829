"""The command Probe."""

from FreeCAD import Qt

from osculate.gui.commands.command import ConstructCommand
from osculate.gui.probe.probe_panel import ProbePanel

QT_TRANSLATE_NOOP = Qt.QT_TRANSLATE_NOOP


class Probe(ConstructCommand):
    """Makes a probe on what is selected, and opens its panel."""

    name = "Osculate_Probe"
    icon = "probe"
    panel = ProbePanel
    menu_text = QT_TRANSLATE_NOOP("Osculate_Probe", "Probe")
    tool_tip = QT_TRANSLATE_NOOP(
        "Osculate_Probe",
        "Moves along curves and shows frame, osculating circle, planes, curvature and torsion, and "
        "the construction of de Casteljau; it stays in the document and follows every edit.\n"
        "Select edges, sketches or whole objects.")
