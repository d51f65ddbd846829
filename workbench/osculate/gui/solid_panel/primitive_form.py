"""The widgets of Bézier solid: a kind and its parameters."""

from osculate.gui.construct.rows import row_of
from osculate.gui.panel.quiet import ComboBox
from osculate.gui.qt import QtWidgets, translate
from osculate.gui.solid_panel.fields import Fields
from osculate.gui.solid_panel.primitive_kinds import kinds
from osculate.gui.solid_panel.solid_form import SolidForm


class PrimitiveForm(SolidForm):
    """Each kind keeps its own parameters while another one is looked at."""

    def __init__(self):
        self.kinds = kinds()
        self.kind_box = ComboBox()
        self.kind_box.setMaxVisibleItems(len(self.kinds))
        for kind in self.kinds:
            self.kind_box.addItem(kind.title, kind.name)
        self.pages = [Fields(kind.fields()) for kind in self.kinds]
        super().__init__(translate("Osculate", "Bézier solid"), "bezier-solid",
                         row_of(QtWidgets.QLabel(translate("Osculate", "Kind")),
                                (self.kind_box, 1)), *self.pages)
        self.setObjectName("OsculateSolidPanel")
        self._show_page()
        self.kind_box.activated.connect(self._kind_chosen)
        for page in self.pages:
            page.changed.connect(self.edited)

    @property
    def kind(self):
        return self.kinds[self.kind_box.currentIndex()]

    @property
    def page(self):
        """The parameters of the kind."""
        return self.pages[self.kind_box.currentIndex()]

    def _kind_chosen(self, _index):
        self._show_page()
        self.edited.emit()

    def _show_page(self):
        for page in self.pages:
            page.setVisible(page is self.page)
