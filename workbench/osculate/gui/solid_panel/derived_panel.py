"""The base of panels that make solids of one that is there."""

from osculate.gui.solid_panel.fields import Fields
from osculate.gui.solid_panel.make_panel import MakePanel
from osculate.gui.solid_panel.solid_form import SolidForm


class DerivedPanel(MakePanel):
    """Makes BezierSolids of a `source` and some fields."""

    icon = ""  #: of resources/icons, without ending

    def __init__(self, source):
        value = source.Proxy.restore(source)
        if value is None:
            raise ValueError(f"{source.Label}: {source.Proxy.error}")
        self.value = value
        self.fields = Fields(self.make_fields(value))
        form = SolidForm(self.title(), self.icon, self.fields)
        form.fields = self.fields
        self.fields.changed.connect(form.edited)
        super().__init__(source.Document, form, source)

    # What a subclass does

    def title(self):
        """The name of what is done, in the user's language."""
        raise NotImplementedError

    def make_fields(self, value):
        """{key: (label, field)} for a BezierTetrahedron."""
        raise NotImplementedError

    def show_fields(self):
        """Shows those fields that count now."""

    # What all do

    def update(self):
        self.show_fields()
        super().update()
