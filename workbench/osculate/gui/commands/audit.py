"""The command Audit."""

from FreeCAD import Qt

from osculate.gui.audit.audit_panel import AuditPanel
from osculate.gui.commands.command import ConstructCommand

QT_TRANSLATE_NOOP = Qt.QT_TRANSLATE_NOOP


class Audit(ConstructCommand):
    """Audits what is selected, and opens its panel."""

    name = "Osculate_Audit"
    icon = "audit"
    panel = AuditPanel
    menu_text = QT_TRANSLATE_NOOP("Osculate_Audit", "Audit")
    tool_tip = QT_TRANSLATE_NOOP(
        "Osculate_Audit",
        "Checks all joins of whole objects at once, worst first, with a table, filters and labels; "
        "it stays in the document and follows every edit.\nSelect objects.")
