"""The widgets that the panels of solids have in common."""

from osculate.gui import resources
from osculate.gui.observers import Later
from osculate.gui.panel.message import Message
from osculate.gui.qt import QtWidgets, Signal
from osculate.gui.solid_panel.facts_label import FactsLabel, all_warnings


class SolidForm(QtWidgets.QWidget):
    """Advice, what is between, trouble, warnings, facts."""

    edited = Signal()  #: a parameter was changed

    def __init__(self, title, icon, *content):
        super().__init__()
        self.setWindowTitle(title)
        self.setWindowIcon(resources.icon(icon))
        self.advice, self.trouble, self.warnings = Message(), Message(), Message()
        self.facts = FactsLabel()
        self._values, self._later = [], Later(self._show_facts, self)
        self.column = QtWidgets.QVBoxLayout(self)
        self.column.setSpacing(8)
        for widget in (self.advice, *content, self.trouble, self.warnings, self.facts):
            self.column.addWidget(widget)
        self.column.addStretch(1)

    def show_trouble(self, sentence):
        """Says why there is no new result; nothing if there is."""
        self.trouble.say(sentence, "error")

    def show_values(self, values):
        """Shows what the BezierTetrahedra are like, soon: at high degrees a drag must not wait."""
        self._values = values
        self._later.start()

    def _show_facts(self):
        self.warnings.say("\n".join(all_warnings(self._values)), "warning")
        self.facts.show_report(self._values)
