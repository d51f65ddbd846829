"""The widgets of the dock Curve plot."""

from osculate import COMB_QUANTITIES
from osculate.combs import SYMBOLS
from osculate.gui import colors, comb_words, preferences, resources
from osculate.gui.panel.message import Message
from osculate.gui.plot.plot_words import words
from osculate.gui.qt import QtCore, QtGui, QtWidgets, Signal, translate
from osculate.plots import PLOT_QUANTITIES

_SHOWN = "PlotQuantities"  # the preference: their names, separated by spaces
_DARK_PAPER = "#2b2e33"    # where a style sheet does not tell


class PlotForm(QtWidgets.QWidget):
    """Shows a CurvePlot; tells what the user wants of it."""

    quantities_changed = Signal()
    follow_toggled = Signal(bool)
    save_requested = Signal()
    pointed = Signal(object)  #: as those of the PlotCanvas
    clicked = Signal(object)
    shown = Signal()
    hidden = Signal()
    canvas = None  #: the PlotCanvas, once there was something to plot

    def __init__(self):
        super().__init__()
        self.setObjectName("OsculateCurvePlot")
        self.boxes = {quantity: self._quantity_box(quantity) for quantity in COMB_QUANTITIES}
        self.follow = QtWidgets.QCheckBox(translate("Osculate", "Follow the selection"))
        self.follow.setChecked(True)
        self.follow.toggled.connect(self.follow_toggled)
        self.lock = QtWidgets.QCheckBox(translate("Osculate", "Lock scale"))
        self.lock.setToolTip(translate("Osculate", "Keeps the scale of the values. Ctrl and the "
                                                   "mouse wheel change it"))
        self.lock.toggled.connect(self._lock_toggled)
        self.whole = self._button(None, translate("Osculate", "All"), translate(
            "Osculate", "Shows the whole length, as a double-click does. The mouse wheel zooms, "
                        "dragging moves"))
        self.whole.clicked.connect(lambda: self.canvas.see_all())
        self.save = self._button("save", translate("Osculate", "Save…"), translate(
            "Osculate", "Save the plot as SVG, PDF or PNG, or its values as CSV"))
        self.save.clicked.connect(self.save_requested)
        self.advice, self.trouble = Message(), Message()
        self.reading = QtWidgets.QLabel()
        self.reading.setWordWrap(True)
        self._lay_out()
        self._enable(False)

    def _quantity_box(self, quantity):
        box = QtWidgets.QCheckBox(SYMBOLS[quantity])
        box.setToolTip(comb_words.title_of(quantity))
        picture = QtGui.QPixmap(QtCore.QSize(12, 12))
        picture.fill(QtGui.QColor(colors.QUANTITIES[quantity]))
        box.setIcon(QtGui.QIcon(picture))
        shown = preferences.parameters().GetString(_SHOWN, " ".join(PLOT_QUANTITIES)).split()
        box.setChecked(quantity in shown)
        box.toggled.connect(self._quantity_toggled)
        return box

    @staticmethod
    def _button(icon, text, tool_tip):
        button = QtWidgets.QToolButton()
        button.setText(text)
        if icon:
            button.setIcon(resources.icon(icon))
            button.setToolButtonStyle(QtCore.Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        button.setToolTip(tool_tip)
        return button

    def _lay_out(self):
        self._tools = QtWidgets.QBoxLayout(QtWidgets.QBoxLayout.Direction.LeftToRight)
        self._tools.setSpacing(6)
        for widgets in (self.boxes.values(), (self.follow, self.lock, self.whole, self.save)):
            row = QtWidgets.QHBoxLayout()
            row.setSpacing(10)
            for widget in widgets:
                row.addWidget(widget)
            row.addStretch(1)
            self._tools.addLayout(row)
        self._layout = QtWidgets.QVBoxLayout(self)
        self._layout.setContentsMargins(6, 4, 6, 4)
        self._layout.setSpacing(4)
        self._layout.addLayout(self._tools)
        self._layout.addWidget(self.advice)
        self._layout.addWidget(self.trouble)
        self._layout.addWidget(self.reading)
        self._layout.addStretch(0)
        self.reading.setSizePolicy(QtWidgets.QSizePolicy.Policy.Ignored,
                                   QtWidgets.QSizePolicy.Policy.Fixed)

    # What is shown

    def quantities(self):
        """Those that the user wants to see."""
        return tuple(quantity for quantity, box in self.boxes.items() if box.isChecked())

    def show_plot(self, plot, keeps_window):
        """Shows a CurvePlot; None: there is none. Raises ImportError without matplotlib."""
        if plot is None:
            if self.canvas is not None:
                self.canvas.hide()
        else:
            self._need_canvas()
            self.canvas.show()
            self.canvas.show_plot(plot, self.quantities(), self.look(), keeps_window)
        self._enable(plot is not None)
        self.read("")

    def _need_canvas(self):
        if self.canvas is None:
            from osculate.gui.plot.plot_canvas import PlotCanvas  # takes a second, or fails
            self.canvas = PlotCanvas()
            self.canvas.pointed.connect(self.pointed)
            self.canvas.clicked.connect(self.clicked)
            self.canvas.locked.connect(lambda: self._check_quietly(self.lock, True))
            self._layout.insertWidget(3, self.canvas, 1)

    def _enable(self, has_plot):
        for widget in (self.lock, self.whole, self.save):
            widget.setEnabled(has_plot)
        self.reading.setVisible(has_plot)

    def read(self, text):
        """Shows what the curve has at the cursor."""
        self.reading.setText(text or translate(
            "Osculate", "Move the mouse along the curve, here or in the 3D view."))

    def look(self):
        """The PlotLook that suits the widgets."""
        from osculate.plot_drawing import PlotLook
        ink = self.palette().color(self.foregroundRole())
        paper = self.palette().color(QtGui.QPalette.ColorRole.Window)
        if ink.lightness() > 128 and paper.lightness() > 128:
            paper = QtGui.QColor(_DARK_PAPER)
        is_dark = paper.lightness() < 128
        field = paper.darker(118) if is_dark else QtGui.QColor("#ffffff")
        size = self.font().pointSizeF()
        return PlotLook(ink=ink.name(), paper=paper.name(), ground=field.name(),
                        text_points=size if size > 0.0 else 9.0, words=words())

    # What the user does, and Qt

    def _quantity_toggled(self):
        if not self.quantities():
            self._check_quietly(self.sender(), True)  # one is left at least
            return
        preferences.parameters().SetString(_SHOWN, " ".join(self.quantities()))
        self.quantities_changed.emit()

    def _lock_toggled(self, is_locked):
        if self.canvas is not None:
            self.canvas.lock(is_locked)

    @staticmethod
    def _check_quietly(box, is_checked):
        blocked = box.blockSignals(True)
        box.setChecked(is_checked)
        box.blockSignals(blocked)

    def resizeEvent(self, event):
        super().resizeEvent(event)
        directions = QtWidgets.QBoxLayout.Direction
        rows = [self._tools.itemAt(index).sizeHint().width() for index in range(2)]
        is_broad = self.width() > sum(rows) + 30
        self._tools.setDirection(directions.LeftToRight if is_broad else directions.TopToBottom)
        lines = 1 if is_broad else 2
        self.reading.setFixedHeight(lines * self.reading.fontMetrics().lineSpacing() + 4)

    def minimumSizeHint(self):
        widest = max(self._tools.itemAt(index).minimumSize().width() for index in range(2))
        return QtCore.QSize(widest + 12, super().minimumSizeHint().height())

    def changeEvent(self, event):
        super().changeEvent(event)
        kinds = QtCore.QEvent.Type
        if event.type() in (kinds.PaletteChange, kinds.StyleChange) and self.isVisible():
            self._look_again()

    def _look_again(self):
        if self.canvas is not None and self.canvas.plot is not None:
            self.show_plot(self.canvas.plot, True)

    def showEvent(self, event):
        super().showEvent(event)
        self.shown.emit()

    def hideEvent(self, event):
        super().hideEvent(event)
        self.hidden.emit()
