"""A ValidityReport in the user's language."""

from osculate.gui import numbers
from osculate.gui.qt import translate

_MOST_PLACES = 4  # that are named


def verdict_of(report):
    """The verdict in a word."""
    if report.is_mirrored:
        return translate("Osculate", "mirror image")
    return {"valid": translate("Osculate", "valid"),
            "singular": translate("Osculate", "singular"),
            "inverted": translate("Osculate", "folds over itself"),
            "undecided": translate("Osculate", "undecided")}[report.verdict]


def where(report):
    """The places of a verdict, e.g. "at edge 0–3, corner 1"; empty where there is none."""
    if report.witness is not None:
        prefix = (translate("Osculate", "near {}") if report.verdict == "undecided"
                  else translate("Osculate", "at {}"))
        return prefix.format(coordinates(report.witness))
    names = [_name_of(corners, points) for corners, points in report.places]
    more = len(names) - _MOST_PLACES
    text = ", ".join(names[:_MOST_PLACES])
    if more > 0:
        text += " " + translate("Osculate", "and {} more").format(more)
    return translate("Osculate", "at {}").format(text) if names else ""


def coordinates(place):
    """Barycentric coordinates as they are written."""
    return "(" + "; ".join(numbers.number(float(share), 3) for share in place) + ")"


def _name_of(corners, points):
    """The corner, edge or face with these corners; a place inside by its coordinates."""
    text = "–".join(map(str, corners))
    if len(corners) == 1:
        return translate("Osculate", "corner {}").format(text)
    if len(corners) == 2:
        return translate("Osculate", "edge {}").format(text)
    if len(corners) == 3:
        return translate("Osculate", "face {}").format(text)
    if len(points) == 4:
        return translate("Osculate", "every point")
    return translate("Osculate", "inside, {}").format(coordinates(sum(points) / len(points)))


def places_of(report):
    """Barycentric coordinates of points that show where a verdict comes from."""
    if report.witness is not None:
        return [report.witness]
    return [point for _corners, points in report.places
            for point in (*points, sum(points) / len(points))]
