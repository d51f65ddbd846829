"""How numbers are written for a person: few digits, a unit, and a dash for what does not exist."""

import math

MISSING = "–"
_SMALL = 1e-3  # smaller numbers are written with a power of ten
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
