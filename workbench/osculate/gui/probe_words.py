"""What a probe says, in the user's language."""

from osculate.features.probe import radius_of
from osculate.gui import comb_words, numbers
from osculate.gui.qt import translate


def kind_name(kind):
    """What a special point is called."""
    if kind in ("inflection", "vertex", "cusp"):
        return comb_words.mark_name(kind)
    return {"end": translate("Osculate", "end"), "join": translate("Osculate", "join"),
            "closing": translate("Osculate", "closing join"),
            "knot": translate("Osculate", "knot")}[kind]


def missing_text(geometry):
    """What a PointGeometry does not have, and why; empty if it has all."""
    if geometry.curvature is None:
        return translate("Osculate", "no curvature: the speed is zero here")
    if geometry.normal is None:
        return (translate("Osculate", "straight: no normal, no circle, no torsion")
                if geometry.frame_kind == "line" else
                translate("Osculate", "κ = 0: no normal, no circle, no torsion"))
    return translate("Osculate", "no torsion") if geometry.torsion is None else ""


def missing_lines(reading):
    """What the sides of a ProbeReading do not have, a line for each."""
    texts = [missing_text(side.geometry) for side in reading.sides]
    if len(set(texts)) == 1:
        texts = texts[:1]
    else:
        names = translate("Osculate", "before: {}"), translate("Osculate", "after: {}")
        texts = [name.format(text) if text else "" for name, text in zip(names, texts)]
    return [text for text in texts if text]


def label_lines(reading, size):
    """(name, text) of the label at a ProbeReading of curves of a size in mm."""
    geometries = [side.geometry for side in reading.sides]
    lines = [f"κ {_both(geometries, 'curvature', size)}",
             "R " + _joined([numbers.quantity(radius_of(geometry), "mm")
                             for geometry in geometries]),
             f"τ {_both(geometries, 'torsion', size)}"]
    return f"s {numbers.quantity(reading.s, 'mm')}", "\n".join(lines)


def value_text(geometry, quantity, size):
    """The value of a quantity with its unit; a dash for what does not exist."""
    return numbers.quantity(comb_words.value_at(geometry, quantity, size),
                            comb_words.UNITS[quantity])


def _both(geometries, quantity, size):
    return _joined([value_text(geometry, quantity, size) for geometry in geometries])


def _joined(texts):
    """Both texts, or one if they are the same."""
    return " | ".join(dict.fromkeys(texts))
