"""The words of a plot, in the user's language."""

from osculate.combs import SYMBOLS
from osculate.gui import comb_words, numbers
from osculate.gui.qt import translate


def words():
    """Those of a PlotLook."""
    return {"gap": translate("Osculate", "gap"), "cut": translate("Osculate", "cut, up to {}"),
            "zero": translate("Osculate", "zero everywhere"),
            "missing": translate("Osculate", "does not exist")}


def reading(at, quantities, label, size):
    """A line on a PlotPoint of curves of a size in mm, with what the plot shows of it."""
    parts = [f"{SYMBOLS[quantity]} {_value(at, quantity, size)}"
             for quantity in dict.fromkeys(("curvature", "torsion", *quantities))]
    return "    ".join((f"s {numbers.quantity(at.s, 'mm')}", label, *parts))


def short_reading(at, size):
    """(name, text) of the label in the 3D view."""
    return (f"s {numbers.quantity(at.s, 'mm')}",
            f"κ {_value(at, 'curvature', size)}   τ {_value(at, 'torsion', size)}")


def _value(at, quantity, size):
    value = comb_words.value_at(at.geometry, quantity, size)
    return numbers.MISSING if value is None else comb_words.value_text(quantity, value)
