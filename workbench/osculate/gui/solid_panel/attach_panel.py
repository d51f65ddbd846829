"""The task panel of Attach neighbour."""

from osculate.gui.qt import translate
from osculate.gui.solid_panel.derived_panel import DerivedPanel
from osculate.gui.solid_panel.fields import (
    ChoiceField, CountField, NumberField, NumbersField, PointField)
from osculate.gui.solid_panel.subdivide_panel import shares_of

SMOOTH, PLACE = "smooth", "place"


class AttachPanel(DerivedPanel):
    """Makes a neighbour over a face that meets the solid with C^s."""

    icon = "solid-attach"

    def title(self):
        return translate("Osculate", "Attach neighbour")

    def label(self):
        return translate("Osculate", "Neighbour of {}").format(self.source.Label)

    def make_fields(self, value):
        names = [translate("Osculate", "Share of the face's corner {}").format(number)
                 for number in (1, 2, 3)]
        return {
            "face": (translate("Osculate", "Over the face"), ChoiceField(
                [(face, translate("Osculate", "{}, opposite to corner {}").format(
                    "–".join(str(corner) for corner in range(4) if corner != face), face))
                 for face in range(4)])),
            "order": (translate("Osculate", "Contact C"), CountField(
                min(1, value.degree), 0, value.degree)),
            "reach": (translate("Osculate", "Reach"), NumberField(1.0, "", 1e-3, 1e3)),
            "lean": (translate("Osculate", "Lean"), NumbersField((1, 1, 1), names)),
            "corner": (translate("Osculate", "New corner"), ChoiceField((
                (SMOOTH, translate("Osculate", "follows smoothly")),
                (PLACE, translate("Osculate", "at a place"))))),
            "point": (translate("Osculate", "Place"), PointField((0, 0, 0))),
        }

    def show_fields(self):
        has_free_corner = self.fields["order"].value() < self.value.degree
        self.fields.show_row("corner", has_free_corner and self.value.dimension == 3)
        self.fields.show_row("point", has_free_corner and self._is_placed())
        self.fields["reach"].widget.setToolTip(translate(
            "Osculate", "How far the neighbour's domain reaches beyond the face, as a share of the "
                        "solid's own"))

    def values(self):
        face, order = self.fields["face"].value(), self.fields["order"].value()
        options = {}
        if self._is_placed() and order < self.value.degree:
            options["apex_point"] = self.fields["point"].value()
        made = self.value.join(self._apex(face), order, face=face, **options)
        if not options and self.value.dimension == 3:
            self.fields["point"].show_value(_corner(made, face))
        return [made]

    def _is_placed(self):
        return self.value.dimension == 3 and self.fields["corner"].value() == PLACE

    def _apex(self, face):
        """The new corner in barycentric coordinates: beyond the face, over a place of it."""
        reach = self.fields["reach"].value()
        apex = [(1.0 + reach) * share for share in shares_of(self.fields["lean"].value())]
        apex.insert(face, -reach)
        return apex


def _corner(value, number):
    """A corner of a BezierTetrahedron, which may have none where its weight is 0."""
    corner = value.evaluate([float(index == number) for index in range(4)])
    return [float(x) if x == x else 0.0 for x in corner]
