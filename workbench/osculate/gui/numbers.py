"""How numbers are written for a person: few digits, a unit, and a dash for what does not exist."""

import math

from osculate.number_text import MISSING, number, quantity

__all__ = ["MISSING", "coordinate", "number", "quantity", "residual"]

_ROUNDING = 1e-12  # of coordinates, as a share of what they belong to


def coordinate(value, size, digits=5):
    """A coordinate of something of this size, to so many digits of the size: "0" for what is only
    the rounding of one.
    """
    if abs(value) <= _ROUNDING * size:
        return number(0.0)
    decimals = digits - 1 - math.floor(math.log10(size)) if size > 0.0 else 0
    if not 0 <= decimals <= digits or not math.isfinite(value):
        return number(value, digits)
    if round(value, decimals) == 0.0:
        return number(value, 2)
    text = f"{value:.{decimals}f}"
    return (text.rstrip("0").rstrip(".") if "." in text else text).replace("-", "−")


def residual(order, value, digits=3):
    """The residual or tolerance of an order: mm, degrees, from 2 on a share in percent."""
    if value is None or not math.isfinite(value):
        return MISSING
    if order == 0:
        return quantity(value, "mm", digits)
    if order == 1:
        return number(value, digits) + "°"
    return quantity(100.0 * value, "%", digits)
