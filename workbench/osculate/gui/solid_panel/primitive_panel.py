"""The task panel of Bézier solid."""

from osculate import BezierTetrahedron
from osculate.gui.solid_panel.make_panel import MakePanel
from osculate.gui.solid_panel.primitive_form import PrimitiveForm


class PrimitivePanel(MakePanel):
    """Makes a solid of a kind, or the several that the kind takes."""

    def __init__(self, document):
        super().__init__(document, PrimitiveForm())

    def values(self):
        made = self.form.kind.make(**self.form.page.values())
        return [made] if isinstance(made, BezierTetrahedron) else made

    def label(self):
        return self.form.kind.title
