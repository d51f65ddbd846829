"""The task panel of Check contact."""

from osculate.features.solid_contact import DEFAULT_TOLERANCE_MM, make_object
from osculate.gui.qt import QtWidgets, translate
from osculate.gui.solid_panel.contact_label import ContactLabel
from osculate.gui.solid_panel.fields import Fields, NumberField
from osculate.gui.solid_panel.session_panel import SessionPanel
from osculate.gui.solid_panel.solid_form import SolidForm

_LEAST_TOLERANCE_MM = 1e-12


class ContactPanel(SessionPanel):
    """Edits a SolidContact, or makes one of two solids."""

    def __init__(self, document, obj=None, solids=()):
        title = (translate("Osculate", "Edit {}").format(obj.Label) if obj
                 else translate("Osculate", "Check contact"))
        self.solids, self.label = QtWidgets.QLabel(), ContactLabel()
        self.solids.setWordWrap(True)
        self.tolerance = NumberField(DEFAULT_TOLERANCE_MM, " mm", _LEAST_TOLERANCE_MM)
        fields = Fields({"tolerance": (translate("Osculate", "Tolerance"), self.tolerance)})
        form = SolidForm(title, "solid-contact", self.solids, fields, self.label)
        form.label, form.tolerance = self.label, self.tolerance
        form.facts.hide()
        super().__init__(document, form, title, obj)
        fields.changed.connect(lambda: self.session.do(Tolerance=self.tolerance.value()))
        if obj is None:
            self.session.create(make_object, First=solids[0], Second=solids[1])
        self.show()

    def show_object(self, obj):
        names = [solid.Label if solid else "–" for solid in (obj.First, obj.Second)]
        self.solids.setText(translate("Osculate", "{} and {}").format(*names))
        self.tolerance.box.show_value(obj.Tolerance.Value)
        report = self.session.result
        self.label.setVisible(report is not None)
        if report is not None:
            self.label.show_report(report)
