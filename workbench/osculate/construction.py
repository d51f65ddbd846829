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
    symmetric: True makes the numbers equal at both ends, up to the lower order: one that is given at
        one end alone holds at the other too, those given at neither are chosen as one.

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
