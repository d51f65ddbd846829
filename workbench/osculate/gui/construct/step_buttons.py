"""The buttons that take steps of a panel back and forward."""

from osculate.gui import resources
from osculate.gui.qt import Qt, QtCore, QtWidgets, translate


class StepButtons(QtWidgets.QWidget):
    """Two buttons at the right."""

    def __init__(self):
        super().__init__()
        self.back = flat_button("back", translate("Osculate", "Take the last step back"))
        self.forward = flat_button("forward", translate("Osculate", "Take the step again"))
        layout = QtWidgets.QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addStretch(1)
        layout.addWidget(self.back)
        layout.addWidget(self.forward)

    def show_steps(self, can_go_back, can_go_forward):
        self.back.setEnabled(can_go_back)
        self.forward.setEnabled(can_go_forward)


def flat_button(icon, tip):
    """A small button that does not take the focus from where numbers are typed."""
    button = QtWidgets.QToolButton()
    button.setIcon(resources.icon(icon))
    button.setIconSize(QtCore.QSize(18, 18))
    button.setToolTip(tip)
    button.setAutoRaise(True)
    button.setFocusPolicy(Qt.FocusPolicy.NoFocus)
    return button
