"""How numbers are written for a person: few digits, a unit, and a dash for what does not exist."""

import math

MISSING = "–"
_SMALL = 1e-3  # smaller numbers are written with a power of ten
_ROUNDING = 1e-12  # of coordinates, as a share of what they belong to
_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def number(value, digits=4):
    """`value` with `digits` significant digits, e.g. "0.0125", "−3.2·10⁻⁷"; a dash for None."""
    if value is None or math.isnan(value):
        return MISSING
    if math.isinf(value):
        return "∞" if value > 0 else "−∞"
    mantissa, _, exponent = f"{value:.{digits}g}".partition("e")
    if 0.0 < abs(value) < _SMALL:
        mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
        mantissa = f"{float(mantissa):.{digits}g}"  # without zeros at the end
    power = f"·{power_of_ten(int(exponent))}" if exponent else ""
    return mantissa.replace("-", "−") + power


def quantity(value, unit, digits=4):
    """A number with its unit."""
    text = number(value, digits)
    return f"{text} {unit}" if unit and text != MISSING else text


def power_of_ten(exponent):
    """"10⁻⁶"."""
    return f"10{str(exponent).translate(_SUPERSCRIPTS)}"


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
