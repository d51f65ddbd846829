"""A join of a real part made smoother: the arc and the line that meet with G1 are each cut back,
and a G3 blend takes the place of what was cut off.
"""
import osculate
from osculate.features import make_blend_curve, make_join_check
from osculate.features.beta_properties import number_name
from osculate.features.blend_curve import SIDES

import models

SHARE_CUT = 0.7  # of the shorter edge's length, from each edge


def curve_of(link):
    return osculate.Curve.from_edge(link.resolve())


def evenness(join):
    """How equal the lengths of the two edges of a join are: 1 for equal ones."""
    lengths = sorted(curve_of(link).length() for link in (join[0].first, join[0].second))
    return lengths[0] / lengths[1]


def kept_part(curve, end, cut_mm):
    """The curve without what lies next to one of its ends."""
    first, last = curve.parameter_range
    if end == "end":
        return curve.trimmed(first, curve.parameter_at_length(curve.length() - cut_mm))
    return curve.trimmed(curve.parameter_at_length(cut_mm), last)


def replace_join(document, place):
    """Adds what is kept of both edges of a join, a G3 blend between them and checks of its joins;
    returns the blend and the checks.
    """
    curves = [curve_of(link) for link in (place.first, place.second)]
    cut_mm = SHARE_CUT * min(curve.length() for curve in curves)
    kept = [models.add(document, f"Kept{number}", kept_part(curve, end, cut_mm).to_edge())
            for number, (curve, end) in enumerate(zip(curves, place.ends), 1)]
    blend = make_blend_curve(document, *((feature, "Edge1") for feature in kept), order=3)
    checks = [make_join_check(document, (kept[0], "Edge1"), (blend, "Edge1")),
              make_join_check(document, (blend, "Edge1"), (kept[1], "Edge1"))]
    for obj in (blend, *checks):
        if obj.Status != "OK":
            raise RuntimeError(f"{obj.Label}: {obj.Status}")
    return blend, checks


def show_blend(place, before, blend, checks):
    """Says what the join was and what has taken its place."""
    print(f"{place.label()} was {before.headline}; now a blend of degree {blend.CurveDegree}, "
          f"{blend.Length.Value:.4g} mm long:")
    for check in checks:
        print(f"  {check.First[0].Label} – {check.Second[0].Label}: {check.Headline}")
    for side in SIDES:
        numbers = ", ".join(f"β{k} {getattr(blend, number_name(side, k)):.3f}" for k in (1, 2, 3))
        print(f"  {side.lower()} end: {numbers}")
    print(f"  bending {blend.Bending:.3f}, variation of curvature {blend.Variation:.3f}, "
          f"unevenness of speed {blend.Speed:.3f}")
