"""Writes continuity_g0_to_g4.FCStd: five pairs of curves, joined with the orders G0, G1, ... G4.

    freecadcmd resources/samples/make_samples.py

The five first curves are one spatial quintic. The second curves follow from its derivatives P',
P'', ... by the beta constraints (docs/theory.md, section 3), Q' = b1 P', Q'' = b1^2 P'' + b2 P',
..., up to the order of the pair; the next pole is moved off by some millimetres, which ends the
contact there. All coordinates are sums of powers of two, so that text files keep them exactly.
"""
import os
import sys
import traceback
from fractions import Fraction
from math import comb, perm
from pathlib import Path

import FreeCAD
import Part

DEGREE = 5
FIRST = [(0, 0, 0), (12, 0, 0), (24, 3, 0), (35, 10, 3), (43, 20, 8), (48, 32, 12)]
BETA = (Fraction(3, 4), Fraction(-1, 2), Fraction(3, 2), Fraction(-3))
# Where the first pole that is free lies, seen from where contact of one more order would have it.
OFFSETS = {0: (6, -2, -2), 1: (4, -1, -2), 2: (4, -2, 2), 3: (4, -2, 3), 4: (4, 2, 6)}
SPACING_MM = 45
FILE = Path(__file__).resolve().parent / "continuity_g0_to_g4.FCStd"


def combine(*terms):
    """The sum of factor * vector."""
    return tuple(sum(Fraction(factor) * vector[i] for factor, vector in terms) for i in range(3))


def end_derivatives(poles):
    """Derivatives 0..5 at the end of a quintic: n!/(n-k)! times the k-th backward difference."""
    return [combine(*((perm(DEGREE, k) * (-1) ** j * comb(k, j), poles[DEGREE - j])
                      for j in range(k + 1)))
            for k in range(DEGREE + 1)]


def contact_derivatives(p):
    """The beta constraints of orders 0..4, with the fifth derivative that b5 = 0 gives."""
    b1, b2, b3, b4 = BETA
    return [p[0],
            combine((b1, p[1])),
            combine((b1 ** 2, p[2]), (b2, p[1])),
            combine((b1 ** 3, p[3]), (3 * b1 * b2, p[2]), (b3, p[1])),
            combine((b1 ** 4, p[4]), (6 * b1 ** 2 * b2, p[3]), (4 * b1 * b3 + 3 * b2 ** 2, p[2]),
                    (b4, p[1])),
            combine((b1 ** 5, p[5]), (10 * b1 ** 3 * b2, p[4]),
                    (10 * b1 ** 2 * b3 + 15 * b1 * b2 ** 2, p[3]),
                    (5 * b1 * b4 + 10 * b2 * b3, p[2]))]


def poles_from_derivatives(q):
    """C_i = sum_k C(i, k) (n-k)!/n! Q^(k)."""
    return [combine(*((Fraction(comb(i, k), perm(DEGREE, k)), q[k]) for k in range(i + 1)))
            for i in range(DEGREE + 1)]


def second_curve(order):
    """Poles of a quintic in contact with FIRST of this order and no higher one."""
    poles = poles_from_derivatives(contact_derivatives(end_derivatives(FIRST)))
    for i in range(order + 1, DEGREE + 1):
        poles[i] = combine((1, poles[i]), (i - order, OFFSETS[order]))
    return poles


def exact(value):
    if Fraction(float(value)) != value:
        raise ValueError(f"{value} is no double")
    return float(value)


def edge(poles, shift):
    curve = Part.BezierCurve()
    curve.setPoles([FreeCAD.Vector(exact(x + shift), exact(y), exact(z)) for x, y, z in poles])
    return curve.toShape()


def write(path):
    document = FreeCAD.newDocument("ContinuityG0ToG4")
    for order in range(5):
        for part, poles in (("a", FIRST), ("b", second_curve(order))):
            feature = document.addObject("Part::Feature", f"G{order}{part}")
            feature.Shape = edge(poles, SPACING_MM * order)
    document.recompute()
    path.unlink(missing_ok=True)  # or FreeCAD keeps a backup beside it
    document.saveAs(str(path))


if "OSCULATE_SAMPLE_IMPORT" not in os.environ:
    try:
        write(FILE)
        print("written", FILE.name)
        code = 0
    except Exception:
        traceback.print_exc()
        code = 1
    sys.stdout.flush()
    os._exit(code)
