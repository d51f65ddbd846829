"""Which edges are analysed, at which ends they meet, and the buttons that change this."""

from osculate.gui import resources
from osculate.gui.panel.side_tag import side_tag
from osculate.gui.panel.toggle_button import ToggleButton
from osculate.gui.qt import Qt, QtCore, QtWidgets, Signal, translate

_ARROWS = {"end": "→|", "start": "|←"}  # the first edge arrives at the join ...
_LEAVING_ARROWS = {"start": "|→", "end": "←|"}  # ... and the second leaves it


class EdgesBar(QtWidgets.QWidget):
    """Two rows, an edge each, with its end at the join; buttons for nearest ends and swapping."""

    ends_chosen = Signal(object)  #: a pair of ends, or None for the nearest
    swapped = Signal()

    def __init__(self, side_colors):
        super().__init__()
        self._ends = ("end", "start")
        self.sides = [_SideRow(number, color) for number, color in enumerate(side_colors, start=1)]
        self.sides[0].end_button.clicked.connect(lambda: self._flip(0))
        self.sides[1].end_button.clicked.connect(lambda: self._flip(1))
        self.nearest = _dressed(ToggleButton(), "nearest", translate(
            "Osculate", "Always take the ends that lie nearest"))
        self.nearest.clicked.connect(self._nearest_clicked)
        self.swap = _dressed(QtWidgets.QToolButton(), "swap", translate(
            "Osculate", "Swap the edges: travel the other way"))
        self.swap.clicked.connect(self.swapped)
        self._lay_out()

    def _lay_out(self):
        layout = QtWidgets.QGridLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setHorizontalSpacing(6)
        layout.setVerticalSpacing(3)
        for row, side in enumerate(self.sides):
            layout.addWidget(side.tag, row, 0)
            layout.addWidget(side.name, row, 1)
            layout.addWidget(side.end_button, row, 2)
        layout.addWidget(self.nearest, 0, 3)
        layout.addWidget(self.swap, 1, 3)
        layout.setColumnStretch(1, 1)

    def show_join(self, place, report, can_choose):
        """Shows a JoinPlace and the ends of its report (None: those asked for)."""
        self._ends = report.ends if report else place.ends or ("end", "start")
        for side, link in zip(self.sides, (place.first, place.second)):
            side.name.set_text(link.label())
        self.sides[0].show_end(self._ends[0], _ARROWS)
        self.sides[1].show_end(self._ends[1], _LEAVING_ARROWS)
        self.nearest.setChecked(place.ends is None and can_choose)
        for button in (self.nearest, self.swap, *(side.end_button for side in self.sides)):
            button.setEnabled(can_choose)

    def _flip(self, index):
        ends = list(self._ends)
        ends[index] = "start" if ends[index] == "end" else "end"
        self.ends_chosen.emit(tuple(ends))

    def _nearest_clicked(self, is_nearest):
        self.ends_chosen.emit(None if is_nearest else tuple(self._ends))


class _SideRow:
    """The widgets of one side."""

    def __init__(self, number, color):
        self.tag = side_tag(number, color)
        self.name = ElidedLabel()
        self.end_button = QtWidgets.QToolButton()
        self.end_button.setToolTip(translate("Osculate", "Take the other end of this edge"))
        self.end_button.setMinimumWidth(76)

    def show_end(self, end, arrows):
        word = translate("Osculate", "end") if end == "end" else translate("Osculate", "start")
        self.end_button.setText(f"{word}  {arrows[end]}")


class ElidedLabel(QtWidgets.QLabel):
    """A label that shortens its text in the middle where the panel is narrow."""

    def __init__(self):
        super().__init__()
        self._full = ""
        self.setMinimumWidth(40)
        self.setSizePolicy(QtWidgets.QSizePolicy.Policy.Ignored,
                           QtWidgets.QSizePolicy.Policy.Preferred)

    def set_text(self, text):
        self._full = text
        self.setToolTip(text)
        self._elide()

    def resizeEvent(self, event):
        super().resizeEvent(event)
        self._elide()

    def _elide(self):
        self.setText(self.fontMetrics().elidedText(self._full, Qt.TextElideMode.ElideMiddle,
                                                   self.width()))


def _dressed(button, icon, tip):
    button.setIcon(resources.icon(icon))
    button.setIconSize(QtCore.QSize(16, 16))
    button.setToolTip(tip)
    return button
