"""The task panel of Project from 4D."""

from osculate.gui.qt import translate
from osculate.gui.solid_panel.derived_panel import DerivedPanel
from osculate.gui.solid_panel.fields import ChoiceField, NumbersField

PARALLEL, PERSPECTIVE = "parallel", "perspective"
_DISTANCE = 2.0  # of the first centre from the solid, in sizes of it


class ProjectPanel(DerivedPanel):
    """Makes the image of a solid of four dimensions in three; the solid itself is hidden."""

    icon = "solid-project"
    hides_source = True

    def title(self):
        return translate("Osculate", "Project from 4D")

    def label(self):
        return translate("Osculate", "Image of {}").format(self.source.Label)

    def make_fields(self, value):
        low, high = value.box
        centre = [*((low + high) / 2.0)[:3].tolist(),
                  float(high[3] + _DISTANCE * max(high - low))]
        return {
            "how": (translate("Osculate", "Projection"), ChoiceField((
                (PARALLEL, translate("Osculate", "parallel")),
                (PERSPECTIVE, translate("Osculate", "from a point"))))),
            "direction": (translate("Osculate", "Across"), NumbersField(
                (0, 0, 0, 1), _names())),
            "centre": (translate("Osculate", "Centre in mm"), NumbersField(
                [float(f"{x:.3g}") for x in centre], _names())),
        }

    def show_fields(self):
        self.fields.show_row("centre", self.fields["how"].value() == PERSPECTIVE)
        self.fields["direction"].widget.setToolTip(translate(
            "Osculate", "The image lies in the hyperplane through the origin that is "
                        "perpendicular to this direction"))

    def values(self):
        is_perspective = self.fields["how"].value() == PERSPECTIVE
        centre = self.fields["centre"].value() if is_perspective else None
        return [self.value.project(self.fields["direction"].value(), centre)]


def _names():
    return ("x", "y", "z", translate("Osculate", "fourth coordinate"))
