"""What combs are called, in the user's language, and how their values are written."""

from osculate.comb_drawing import is_rounding
from osculate.combs import SYMBOLS, UNITS
from osculate.gui import numbers
from osculate.gui.qt import translate


def name_of(quantity):
    """"Curvature", "Torsion", ..."""
    return {"curvature": translate("Osculate", "Curvature"),
            "torsion": translate("Osculate", "Torsion"),
            "curvature_rate": translate("Osculate", "Rate of curvature"),
            "curvature_rate2": translate("Osculate", "Second rate of curvature"),
            "torsion_rate": translate("Osculate", "Rate of torsion")}[quantity]


def title_of(quantity):
    """"Curvature κ"."""
    return f"{name_of(quantity)} {SYMBOLS[quantity]}"


def mark_name(kind):
    """"inflection", ..."""
    return {"inflection": translate("Osculate", "inflection"),
            "vertex": translate("Osculate", "vertex (κ stationary)"),
            "cusp": translate("Osculate", "cusp"),
            "peak": translate("Osculate", "peak")}[kind]


def value_text(quantity, value, digits=3):
    """A value with its unit; of a curvature with its radius."""
    text = numbers.quantity(value, UNITS[quantity], digits)
    if quantity == "curvature" and value > 0.0:
        text += f" (R {numbers.quantity(1.0 / value, 'mm', digits)})"
    return text


def scale_text(quantity, scale):
    """What a length of teeth stands for, e.g. "10 mm = 0.05 mm⁻¹"."""
    length = 10.0
    return f"{length:g} mm = {value_text(quantity, length / scale)}"


def value_at(geometry, quantity, size):
    """The value of a quantity at a PointGeometry of curves of a size in mm: 0 for what is only
    rounding, None for what does not exist.
    """
    value = getattr(geometry, quantity)
    return 0.0 if value is not None and is_rounding(abs(value), quantity, size) else value
