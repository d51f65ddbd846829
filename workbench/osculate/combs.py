"""Combs: curvature, torsion and their rates along curves, in arrays."""

from typing import NamedTuple

import numpy

from osculate import _core, shapes

#: What a comb has along a curve, by the names of its arrays.
COMB_QUANTITIES = ("curvature", "torsion", "curvature_rate", "curvature_rate2", "torsion_rate")

SYMBOLS = {"curvature": "κ", "torsion": "τ", "curvature_rate": "dκ/ds",
           "curvature_rate2": "d²κ/ds²", "torsion_rate": "dτ/ds"}
UNITS = {"curvature": "mm⁻¹", "torsion": "mm⁻¹", "curvature_rate": "mm⁻²",
         "curvature_rate2": "mm⁻³", "torsion_rate": "mm⁻²"}


class CombMark(NamedTuple):
    """A point of interest of a comb; it is one of the samples."""

    kind: str              #: "inflection", "vertex", "cusp" or "peak"
    quantity: str          #: whose magnitude has a local maximum, for a peak; else "curvature"
    curve: int             #: number of the curve
    sample: int            #: index into the arrays of the comb
    uncertainty_mm: float  #: how far along the curve it can be from the true place


class Comb(NamedTuple):
    """Samples of all curves, one after the other. What does not exist is NaN."""

    parameter: numpy.ndarray        #: (n,): of the curve
    arc_length: numpy.ndarray       #: (n,): from the start of the curve, mm
    point: numpy.ndarray            #: (n, 3): mm
    tangent: numpy.ndarray          #: (n, 3): unit vector in the direction of the parameter
    normal: numpy.ndarray           #: (n, 3): unit vector towards the centre of curvature
    binormal: numpy.ndarray         #: (n, 3): tangent x normal
    curvature: numpy.ndarray        #: (n,): κ >= 0, 1/mm
    torsion: numpy.ndarray          #: (n,): τ, signed, 1/mm
    curvature_rate: numpy.ndarray   #: (n,): dκ/ds, 1/mm²
    curvature_rate2: numpy.ndarray  #: (n,): d²κ/ds², 1/mm³
    torsion_rate: numpy.ndarray     #: (n,): dτ/ds, 1/mm²
    is_tooth: numpy.ndarray         #: (n,): True for the even samples, False for added ones
    runs: numpy.ndarray             #: (m, 3): first sample, last sample, number of the curve
    lengths: numpy.ndarray          #: (curves,): mm
    marks: tuple                    #: of CombMark, in the order of the samples


def comb(curves, *, density=24, tolerance=0.005, quantities=COMB_QUANTITIES):
    """Samples of curves with curvature, torsion and their rates by arc length, as a Comb.

    curves: a Part.Edge or Curve, or a sequence of them. Each is travelled in its own direction.
    density: even intervals of the parameter for each Bézier segment, 2 to 10000; a segment of
        degree n has 2n at least.
    tolerance: samples are added where one of the quantities bends away from the chord between two
        samples by more than this share of itself, and where the curve turns by more than 15
        degrees; 0 adds none.
    quantities: some of COMB_QUANTITIES, for which samples are added and peaks are looked for; all
        are in the Comb anyway.

    A *run* is the samples between two places where a quantity can jump: knots, inflections, cusps
    and the ends of curves. At these places there are two samples, with the values of either side;
    nothing may be interpolated between them. Where the curvature is zero torsion and rates are
    limits at the ends of a run, and NaN within it.

    Marks are located by root finding, not the best sample: inflections (the curve bends to the
    other side), vertices (dκ/ds = 0), cusps, and for each of the quantities its peaks, the local
    maxima of its magnitude. Arc lengths have a relative error of about 1e-9. The GIL is released.

    Raises TypeError for what is no curve, ValueError that names the argument and the rule.
    """
    names = names_of(quantities)
    values = _core.comb_arrays(_curves_from(curves), density, tolerance, names)
    return Comb(*values[:-1], tuple(CombMark(*mark) for mark in values[-1]))


def names_of(quantities):
    """Names of COMB_QUANTITIES as a tuple, each once. Raises ValueError for others, and for none;
    TypeError for what is no name.
    """
    names = (quantities,) if isinstance(quantities, str) else tuple(quantities)
    for name in names:
        if not isinstance(name, str):
            raise TypeError(f"quantities: must be names, got {type(name).__name__}")
        if name not in COMB_QUANTITIES:
            raise ValueError(f"quantities: {name!r} is none of {', '.join(COMB_QUANTITIES)}")
    if not names:
        raise ValueError("quantities: at least one is needed")
    return tuple(dict.fromkeys(names))


def _curves_from(curves):
    if isinstance(curves, _core.Curve) or shapes.is_edge(curves):
        return [shapes.curve_from(curves, "curves")]
    try:
        members = list(curves)
    except TypeError:
        return [shapes.curve_from(curves, "curves")]  # says what is wrong
    return [shapes.curve_from(member, f"curves[{number}]") for number, member in enumerate(members)]
