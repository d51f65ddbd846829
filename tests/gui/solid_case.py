"""What the tests of Bézier solids have in common."""

import FreeCADGui

from construct_case import ConstructCase
from osculate import solids
from osculate.features import make_bezier_solid
from osculate.features.bezier_solid import is_solid
from osculate.gui.solid_panel.solid_form import SolidForm


class SolidCase(ConstructCase):
    """A document with undo; solids in it; views that are looked at from a corner."""

    form_type = SolidForm

    def solid(self, value=None):
        """A BezierSolid in the document, by default a cone."""
        obj = make_bezier_solid(self.doc, solids.cone(25, 50) if value is None else value)
        self.doc.recompute()
        return obj

    def run_command(self, command, *objects):
        """A command that has no panel, on selected objects."""
        self.select(*((obj, "") for obj in objects))
        FreeCADGui.runCommand(command)
        self.pump()

    def run_on_objects(self, *objects):
        """The command of the case on selected objects; returns the form."""
        return self.run_on(*((obj, "") for obj in objects))

    def fit(self):
        view = self.view()
        view.setAnimationEnabled(False)
        view.viewIsometric()
        view.fitAll()
        self.pump()

    def is_active(self, command):
        self.pump()
        return FreeCADGui.Command.get(command).isActive()

    def as_it_was(self):
        """What of the document counts: to compare before and after."""
        return [(obj.Name, obj.Label, obj.Visibility,
                 obj.Proxy.restore(obj) if is_solid(obj) else None) for obj in self.doc.Objects]
