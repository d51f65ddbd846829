"""What a page says in words: the joins of an audit, its options and what it could not read."""

from osculate import number_text

_PAIRS = {"all": "all pairs of edges at a vertex",
          "wire": "edges that follow each other in a wire",
          "tangent": "all pairs of edges at a vertex but corners of more than {:g}°"}

_KINDS = {"vertex": "vertex", "knot": "inner knot", "seam": "closing"}

_DEFAULT_NAME = "Shape"

#: Deviations below this share of their tolerance are only said to be nearly zero.
_ROUNDING = 1e-6


def counted(count, name):
    """E.g. "1 join" or "6,140 joins"."""
    return f"{count:,} {name}" if count == 1 else f"{count:,} {name}s"


def title_of(report):
    """The name of what was audited: of a file its own, without the folder."""
    return report.source.replace("\\", "/").rsplit("/", 1)[-1] if report.source else _DEFAULT_NAME


def kind(row):
    return _KINDS[row.kind]


def edges(row):
    """Texts for the one or two edges of an AuditRow."""
    first, second = row.edges
    if row.kind == "knot":
        return [f"Edge{first} before", f"and after {number_text.number(row.parameter, 6)}"]
    if row.kind == "seam":
        return [f"Edge{first} {row.ends[0]}", f"and {row.ends[1]}"]
    return [f"Edge{number} {end}" for number, end in zip((first, second), row.ends)]


def missing(row):
    """What a join misses in a few words, e.g. "misses G1 by 90°"; empty if nothing, and for a gap.
    """
    following = row.order + 1
    if following >= len(row.verdicts):
        return ""
    if row.verdicts[following] == "undecided":
        return f"G{following} undecided"
    amount = number_text.residual(following, row.residuals[following])
    if amount == number_text.MISSING:
        return f"G{following} does not exist here"
    return f"misses G{following} by {amount}" if following else ""


def deviations(row, tolerances):
    """Gap, angle and relative difference of the curvatures of an AuditRow, beside the dict
    `tolerances` of the audit.
    """
    return [_deviation(order, row.deviation.get(name), tolerance_of(tolerances, order))
            for order, name in enumerate(("gap_mm", "tangent_angle_deg", "curvature_relative"))]


def _deviation(order, value, tolerance):
    is_rounding = value is not None and 0.0 < value < _ROUNDING * tolerance
    return "≈ 0" if is_rounding else number_text.residual(order, value)


def place(row, size):
    """Coordinates of a join of a model of a size."""
    return "({})".format(", ".join(number_text.coordinate(value, size, 6)
                                   for value in row.point.tolist()))


def kinds(summary):
    """How many joins there are of each kind, are undecided, and do not count."""
    counts = summary["kinds"]
    text = (f"{counts['vertex']:,} at vertices, {counts['knot']:,} at inner knots, "
            f"{counts['seam']:,} where closed edges close")
    left_out, undecided = summary["corners_left_out"], summary["undecided"]
    if left_out:
        text += f"; {left_out:,} corners do not count"
    if undecided:
        text += f"; {undecided:,} with an order that double precision leaves undecided"
    return text + "."


def options(choices):
    """(name, value) of what an audit was asked for."""
    preset = choices["preset"]
    yield "Tolerances", "own values" if preset == "custom" else preset
    for order in range(choices["order"] + 1):
        yield f"G{order}", number_text.residual(order, tolerance_of(choices["tolerances"], order))
    yield "Joins", _PAIRS[choices["pairs"]].format(choices["corner_deg"] or 0.0)
    touch = choices["touch_mm"]
    yield "Ends that share no vertex", (f"join within {number_text.number(touch)} mm" if touch
                                        else "do not join")


def tolerance_of(tolerances, order):
    """Of an order from the dict `tolerances` of the options of an audit."""
    return list(tolerances.values())[min(order, len(tolerances) - 1)]


def reservations(report):
    """Sentences on what is not in a report."""
    if not report.is_complete:
        yield "The audit was stopped: only the joins of a first part of the edges are here."
    yield from report.notes
    for entry in report.skipped:
        if not entry.degenerated:
            yield f"Edge{entry.edge} was left out: {entry.reason}."
