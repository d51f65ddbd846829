"""The widgets that all constructions have, around those of one of them."""

from osculate.gui import resources
from osculate.gui.construct.energy_table import EnergyTable
from osculate.gui.construct.join_verdicts import JoinVerdicts
from osculate.gui.construct.step_buttons import StepButtons
from osculate.gui.panel.message import Message
from osculate.gui.qt import QtWidgets, Signal


class ConstructForm(QtWidgets.QWidget):
    """Advice, what a subclass adds, trouble, warnings, verdicts, energies, steps.

    A subclass makes its widgets in `content()` and shows an object in `show_object`; what the user
    changes it tells by `edited`.
    """

    #: Properties to set, as a dict, and whether this ends a step (False while a slider moves).
    edited = Signal(object, bool)
    settled = Signal()                #: ends the step that began with edits
    edge_awaited = Signal(object)     #: index of the edge that the next click gives, None: no edge

    def __init__(self, title, icon, preferences):
        super().__init__()
        self.setWindowTitle(title)
        self.setWindowIcon(resources.icon(icon))
        self.preferences = preferences
        self.advice = Message()
        self.trouble = Message()
        self.warnings = Message()
        self.verdicts = JoinVerdicts()
        self.energies = EnergyTable()
        steps = StepButtons()
        self.back, self.forward, self.show_steps = steps.back, steps.forward, steps.show_steps
        layout = QtWidgets.QVBoxLayout(self)
        layout.setSpacing(8)
        for widget in (self.advice, *self.content(), self.trouble, self.warnings, self.verdicts,
                       self.energies):
            layout.addWidget(widget)
        layout.addWidget(steps)
        layout.addStretch(1)
        self.show_parts(has_object=False)
        self.show_outcome(None, "", (None, None))

    def content(self):
        """The widgets of the subclass, from top to bottom."""
        raise NotImplementedError

    def show_edges(self, choice):
        """Shows an EdgeChoice."""

    def show_object(self, obj, result):
        """Shows the properties of the object; `result` is its construction, or None."""
        raise NotImplementedError

    def show_parts(self, has_object):
        """Shows the widgets that change the object only where there is one."""
        raise NotImplementedError

    def reports(self, result):
        """The JoinReports of a construction whose verdicts are shown."""
        return result.reports

    def show_outcome(self, result, error, energies):
        """Shows what came out, or why nothing did."""
        self.trouble.say(error, "error")
        self.warnings.say("\n".join(result.warnings) if result else "", "warning")
        self.verdicts.setVisible(result is not None and bool(self.reports(result)))
        self.energies.setVisible(result is not None)
        if result is not None:
            self.verdicts.show_reports(self.reports(result))
            self.energies.show_energies(*energies)
