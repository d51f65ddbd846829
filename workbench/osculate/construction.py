"""The construction of curves that flow into others."""

from osculate import _core, shapes


def blend(a, b, *, order=3, ends=None, beta=None, degree=None, fairness="mvc", symmetric=False):
    """A polynomial Bézier curve over [0, 1] that leaves one curve and arrives at another, each with
    its own order of geometric contact, as a Construction. The two curves are not changed.

    a, b: Part.Edge (any curve type, trimmed, reversed, placed, rational, periodic) or Curve. One
        open curve as both is closed by the blend, from its end to its start.
    order: of contact, 0 to 8, or a pair (order at a, order at b).
    ends: where the blend leaves a and b; None takes their nearest ends. Else a pair, for each curve
        "start", "end", or (t, direction) for a parameter inside it: (t, "forward") continues the
        part before t, in the direction of the parameter, (t, "backward") the part after t, against
        it. The part that is continued must have a length.
    beta: ((beta_1, ..) at a, (beta_1, ..) at b), as many numbers as the order at most; those that
        are None or left out are chosen. beta_k = (d^k s/dt^k) / chord, without dimension: s the arc
        length of the blend and t its parameter, both measured from that end into the blend, the
        chord from end to end. beta_1 > 0: the speed there, 1 for the chord.
    degree: from order_a + order_b + 1, the least, which None takes, to 25. Poles above the least
        are free too; where fairness chooses, the result is never worse than that of the least.
    fairness: how numbers are chosen. "mvc" minimises ln("mvc" + 1e-12) + 0.3 "speed" of
        `Construction.energy` (scale-invariant minimum variation of curvature: Moreton and Sequin
        1992), "bending" the same with "bending"; the best of several starts, always the same curve
        for the same arguments. None takes beta_1 = 1 and 0 for the others.
    symmetric: True makes the numbers equal at both ends, up to the lower order: one that is given
        at one end alone holds at the other too, those given at neither are chosen as one.

    `warnings` of the result names cramped ends, and where rounding keeps a join from the order
    asked for. The curve is computed without the GIL.

    Raises ContactError (a ValueError) where no such curve can be: ends that coincide, a degree that
    cannot carry the orders, a singular end without derivatives of the order asked for. Raises
    ValueError that names the argument and the rule for other values, TypeError for what is no curve
    or of the wrong kind.
    """
    first = shapes.curve_from(a, "a")
    second = shapes.curve_from(b, "b")
    if ends is None and shapes.are_same(a, b):
        second, ends = first, ("end", "start")  # b may be the same edge reversed
    return _core.blend(first, second, order, ends, beta, degree, fairness, symmetric)


def extend(a, *, end="end", order=4, degree=None, beta=None, length=None, tangential=None,
           to_point=None, to_direction=None, to_curvature=None, parametric=False, parameter=None,
           natural=False, fairness="mvc"):
    """A polynomial Bézier curve that continues one curve beyond its end with contact of an order,
    as a Construction. The curve is not changed; the new one begins at that end.

    a: Part.Edge (any curve type, trimmed, reversed, placed, rational, periodic) or Curve.
    end: "end", or "start" for the other one, from where the new curve travels backwards.
    order: of contact, 0 to 8.
    degree: 1 to 25; None for the lowest from the order up that can meet the request. A degree below
        the order is taken on request, where a curve of it exists: a cubic meets every curve that
        bends and twists with G4. Where none does, the error says which degree can.
    beta: (beta_1, ..), as many numbers as the order at most; those that are None or left out are
        free. beta_k = (d^k s/dt^k) / chord of the new curve, without dimension; see blend. All of
        them, with a degree not above the order, fix the chord too.
    tangential: the tangential coordinates of the poles C_1, C_2, .. in mm, measured along the
        tangent from the end, in place of beta: as many as the order at most, None where free.
    length: of the new curve in mm. Where neither it nor to_point nor numbers in mm are given: the
        reach of the curve, the distance from this end to its other end or its middle, the larger.
    to_point: where the new curve ends.
    to_direction: its tangent there, in the direction of travel; of any length.
    to_curvature: there, in 1/mm: a number for the magnitude of the curvature, a vector for the
        curvature vector (curvature times normal).
    parametric: True for C^m in the curve's own parameter in place of G^m. The new curve then has
        the parameter range [0, h], h the length of the last knot interval; else it is over [0, 1].
    parameter: t > 0: the curve with C^m, and of it by de Casteljau the part up to t, so that it is
        G^m: shorter for t < 1.
    natural: True for the curve's own continuation: a circle goes on as the same circle. A B-spline
        where one Bézier segment of a rational curve cannot. Only length, end and order can be
        given; the join is analysed up to that order.
    fairness: how numbers that the request leaves free are chosen: "mvc" or "bending", see blend.
        None: there must be none. A first leg that is free keeps at least 0.35 of an even one.

    `free_numbers` of the result tells how many numbers the request left free. Its `warnings` name a
    cramped join, a sharp bend towards the targets, and where rounding keeps the join from its
    order. The same arguments always give the same curve; it is computed without the GIL.

    Raises ContactError (a ValueError) where no such curve can be, with what can: a degree too low,
    requests that contradict each other, more conditions than free numbers or, without fairness,
    fewer, a singular end without derivatives of the order. Raises ValueError that names the
    argument and the rule for other values, TypeError for what is no curve or of the wrong kind.
    """
    return _core.extend(
        shapes.curve_from(a, "a"), end=end, order=order, degree=degree, beta=beta, length=length,
        tangential=tangential, to_point=to_point, to_direction=to_direction,
        to_curvature=to_curvature, parametric=parametric, parameter=parameter, natural=natural,
        fairness=fairness)


def join(curves, *, tolerance=0.0):
    """One B-spline that runs through the curves of a chain, as a Construction: of the highest
    degree among them, with the lowest knot multiplicities that their parametric continuity allows
    after the best linear re-parametrisation.

    curves: Part.Edge or Curve, in a list or another iterable, or a Part.Wire. They are travelled in
        the order of the list, each in the direction that its ends suggest. Only where that leaves a
        gap are they sorted by their ends; then the first keeps its direction.
    tolerance: mm. 0: the point set is that of the curves to rounding (1.1e-13 of the coordinates,
        and the known errors of converted curves). Above 0, gaps are closed, each end moving half of
        it, and the multiplicities at the joins lowered further, C^1 everywhere first, as long as no
        point moves farther than this. Inner knots of the curves lose only what they do not need.

    The first curve keeps its parameter. Those of the others are scaled, one factor each, so that
    the speeds agree where they meet smoothly; behind a corner so that the mean speed stays the
    same. Weights are scaled to agree at the joins; rational curves are judged in homogeneous form,
    as B-splines need it, so that the arcs of a circle keep double knots. A closed chain makes a
    closed curve: periodic where its closing is C^1 or better, else clamped.

    Of the result, `reports` and `input_reports` have a JoinReport for each place where two curves
    meet, in the order of travel, the closing last: of the curve, with its `parameter` there, and of
    the curves as they were. `max_displacement_mm` bounds how far points moved, measured at equal
    parameters. `warnings` names corners, closed gaps, joins at two speeds, and a sorted list.

    Raises ContactError (a ValueError) where the curves make no chain, with the pair and its gap, or
    branch, and where scaled knots or weights leave the range of doubles. Raises ValueError for an
    empty list, the same curve twice and a bad tolerance, TypeError for what is no curve.
    """
    return _core.join(shapes.curves_from(curves, "curves"), tolerance)


def nu_spline(points, *, tension=0.0, parameters=None, ends="natural", closed=False):
    """The cubic B-spline through points that is G2 and has a tension at each of them: the nu-spline
    (Nielson 1974), as a Curve.

    points: (n, 3) in mm, or a sequence of vectors; n at least 2, closed at least 3.
    tension: >= 0, a number for all points or one for each, without dimension. 0 gives the C2 cubic
        spline; the larger, the straighter the curve runs beside the point, towards the polygon. The
        shape does not change when points or parameters are scaled: nu_i = tension_i times the mean
        of 1/h of the parameter steps beside the point, and P'' jumps there by nu_i P'.
    parameters: of the points, increasing; of a closed curve one more, the end of its period. Or how
        to choose them, from 0 to the length of the polygon: None or "centripetal" (steps like the
        square roots of the distances: Lee 1989), "chordal", "uniform".
    ends: of an open curve. "natural" (least energy; no curvature at the end), "bessel" (the
        derivative of the parabola through the three points there), or a pair, for each end one of
        these or a tangent (x, y, z) in the direction of travel: the derivative divided by the mean
        speed of the end span, so that a unit vector is neutral.
    closed: True goes on from the last point to the first; do not repeat that. The curve is then
        periodic.

    Among all C1 curves through the points at these parameters it has the least int |P''|^2 dt + sum
    nu_i |P'(t_i)|^2 (natural ends, or closed). Knots are double, simple where the tension is 0. The
    cost is linear in n; the GIL is released.

    Raises ValueError that names the argument and the rule, TypeError for what is of the wrong kind.
    """
    return _core.nu_spline(points, tension, parameters, ends, closed)


def match(a, b, *, order=2, ends=None, keep=4, spans=None, degree=None, beta=None):
    """Curve b changed as little as possible near one end so that it meets curve a with geometric
    contact of an order, as a Construction. Curve a is not changed.

    a, b: Part.Edge (any curve type, trimmed, reversed, placed, rational, periodic) or Curve. One
        closed curve as both is changed at one end so that it meets its other end.
    order: of contact, 0 to 8.
    ends: where b meets a; None takes their nearest ends. Else a pair: for a "start", "end" or
        (t, direction) as for blend, for b "start" or "end".
    keep: at the far end of b the derivatives up to this one stay, 0 to 8, so that b keeps its
        contact of that order with whatever it meets there. Where the change does not reach the far
        end's span, everything stays.
    spans: how many spans of b, from the join, may change at most; None: as many as are useful
        (farther ones would change by less than a hundredth). All poles and knots beyond stay bit
        for bit.
    degree: of the result; None keeps that of b and raises it, as little as possible, where it is
        below the order or where b has too few poles for both ends. A higher degree leaves more
        freedom; where b has several spans all its poles are then new, on the same curve.
    beta: the free numbers (beta_1, ..) at the join, at most as many as the order; those that are
        None or left out are chosen. beta_k = (d^k s/dt^k) / u, without dimension: s the arc length
        of the new curve, t the parameter of its span at the join over [0, 1], both from the join;
        u the reach of that span as it was, from the join to its other end or its middle, the
        larger.

    What is least is the integral of the squared displacement at equal parameters over the arc
    length of b as it was. Weights stay, and so does the contact of b with itself at its inner
    knots. `max_displacement_mm` bounds the displacement, `change` tells what was changed, `reports`
    has the join with a. Where they meet already (preset `exact`) and neither beta nor a higher
    degree is asked for, the curve is b as it is. The curve is computed without the GIL.

    Raises ContactError (a ValueError) where the degree, the spans or the singular end of a cannot
    carry the order; ValueError that names the argument and the rule for other values, also for the
    same open curve twice; TypeError for what is no curve or of the wrong kind.
    """
    first = shapes.curve_from(a, "a")
    second = first if a is b else shapes.curve_from(b, "b")
    options = (keep, spans, degree, beta)
    if not shapes.are_same(a, b):
        return _core.match(first, second, order, ends, *options)
    if not _core.is_closed(first, None):
        raise ValueError("b: is the same curve as a, which is open; give two curves, or one closed "
                         "curve for its closing join")
    met = ("end", "start") if ends is None else ends
    if sorted(met) != ["end", "start"]:
        raise ValueError('ends: a closed curve meets itself with ("end", "start") or '
                         f'("start", "end"), got {ends!r}')
    return _core.match_closing(first, met[1], order, *options)
