"""The task panel of Subdivide."""

from itertools import combinations

from osculate.gui.qt import translate
from osculate.gui.solid_panel.derived_panel import DerivedPanel
from osculate.gui.solid_panel.fields import ChoiceField, NumbersField

POINT, REFINED, HALVES = "point", "refined", "halves"


class SubdividePanel(DerivedPanel):
    """Makes parts of a solid that share its map; the solid itself is hidden."""

    icon = "solid-subdivide"
    hides_source = True

    def title(self):
        return translate("Osculate", "Subdivide")

    def label(self):
        return translate("Osculate", "Part of {}").format(self.source.Label)

    def make_fields(self, _value):
        edges = ["{}–{}".format(*corners) for corners in combinations(range(4), 2)]
        names = [translate("Osculate", "Share of corner {}").format(corner) for corner in range(4)]
        return {
            "how": (translate("Osculate", "Into"), ChoiceField((
                (POINT, translate("Osculate", "four, around a point")),
                (REFINED, translate("Osculate", "eight, by the middles of the edges")),
                (HALVES, translate("Osculate", "halves, through an edge"))))),
            "place": (translate("Osculate", "Shares of the corners"),
                      NumbersField((1,) * 4, names)),
            "edge": (translate("Osculate", "Edge between corners"), ChoiceField(
                [(edge, edge) for edge in edges])),
        }

    def show_fields(self):
        how = self.fields["how"].value()
        self.fields.show_row("place", how == POINT)
        self.fields.show_row("edge", how == HALVES)

    def values(self):
        how = self.fields["how"].value()
        if how == REFINED:
            return self.value.refined()
        if how == HALVES:
            return list(self.value.bisected(*map(int, self.fields["edge"].value().split("–"))))
        return self.value.subdivided(shares_of(self.fields["place"].value()))


def shares_of(numbers):
    """Numbers >= 0 as shares with the sum 1. Raises ValueError."""
    if min(numbers) < 0.0 or not any(numbers):
        raise ValueError(translate("Osculate", "Shares must be 0 or more, at least one of them "
                                               "more."))
    return [number / sum(numbers) for number in numbers]
