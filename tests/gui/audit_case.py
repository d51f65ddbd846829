"""What the tests of the object Audit and its panel have in common."""

import FreeCADGui

import samples
from construct_case import ConstructCase
from osculate.gui.audit.audit_form import AuditForm


class AuditCase(ConstructCase):
    """A sketch with a corner, a gap of 0.02 mm and joins that are G1."""

    form_type = AuditForm
    command = "Osculate_Audit"

    def setUp(self):
        super().setUp()
        self.profile = samples.profile(self.doc)
        self.fit()

    def drawn(self, name, color):
        """How many pixels of a colour the 3D view has."""
        return self.count_pixels(self.image(name), color, 8)

    @staticmethod
    def texts(form, column):
        """What a column of the table says."""
        model = form.table.rows_shown
        return [model.data(model.index(line, column)) for line in range(model.rowCount())]

    def click_row(self, form, line):
        form.table.selectRow(line)
        self.pump()

    def selected(self):
        return [(entry.ObjectName, *entry.SubElementNames)
                for entry in FreeCADGui.Selection.getSelectionEx()]
