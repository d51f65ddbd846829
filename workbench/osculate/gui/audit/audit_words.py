"""What the panel of an audit calls things, in the user's language."""

from osculate import VERDICTS
from osculate.features.join_check import continuity_name
from osculate.gui.qt import translate
from osculate.gui.verdict import look_of


def order_name(order):
    """"G2"; "gap" for -1."""
    return continuity_name(order) if order >= 0 else translate("Osculate", "gap")


def residual_name(order):
    """What the residual of an order is: "G0 gap", "G1 angle", "G2", ..."""
    return {0: translate("Osculate", "G0 gap"),
            1: translate("Osculate", "G1 angle")}.get(order, f"G{order}")


def verdicts_of(rows, index):
    """The verdicts of a row of AuditRows as words."""
    return [VERDICTS[code] for code in rows.verdicts[index]]


def look_of_row(rows, index):
    """The VerdictLook of a row of AuditRows."""
    return look_of(int(rows.order[index]), verdicts_of(rows, index))
