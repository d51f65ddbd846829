"""How numbers are written for a person: few digits, a unit, and a dash for what does not exist."""

import math

MISSING = "–"
_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def number(value, digits=4):
    """`value` with `digits` significant digits, e.g. "0.0125", "-3.2·10⁻⁷"; a dash for None."""
    if value is None:
        return MISSING
    if math.isinf(value) or math.isnan(value):
        return "∞" if value > 0 else "−∞" if value < 0 else MISSING
    mantissa, _, exponent = f"{value:.{digits}g}".partition("e")
    if not exponent:
        return mantissa
    return f"{mantissa}·10{str(int(exponent)).translate(_SUPERSCRIPTS)}"


def quantity(value, unit, digits=4):
    """A number with its unit."""
    text = number(value, digits)
    return f"{text} {unit}" if unit and text != MISSING else text


def residual(order, value, digits=3):
    """The residual or tolerance of an order: mm, degrees, from 2 on a share in percent."""
    if value is None or not math.isfinite(value):
        return MISSING
    if order == 0:
        return quantity(value, "mm", digits)
    if order == 1:
        return number(value, digits) + "°"
    return quantity(100.0 * value, "%", digits)
