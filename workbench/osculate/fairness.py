"""How fair curves are."""

from osculate import _core, shapes


def energies(a):
    """How fair a curve is, as `Construction.energy` has it, without what was minimised: a dict of
    "bending", "mvc" and "speed", without dimension, and "length_mm".

    a: Part.Edge or Curve. Raises TypeError for what is no curve.
    """
    return _core.energies(shapes.curve_from(a, "a"))
