"""The control points of a solid as a table that can be edited."""

import math

from osculate.features.control_net import COLUMNS, FOURTH, WEIGHT, indices_of, name_of
from osculate.gui import colors, numbers
from osculate.gui.qt import Qt, QtGui, QtWidgets, Signal, translate

_ROWS_SHOWN = 10
_DIGITS = 5
_INDEX = 0  # the column of indices; numbers begin in the next one


class NetTable(QtWidgets.QTableWidget):
    """A row a point: index, coordinates, weight. A cell shows few digits and is edited with all."""

    typed = Signal(int, str, float)  #: row, column of control_net.COLUMNS, the number
    refused = Signal(str)            #: why what was typed is no number
    marked = Signal(object)          #: numbers of the rows that are marked

    def __init__(self):
        super().__init__()
        self._columns, self._degree = (), None
        self.setItemDelegate(_NumberDelegate(self))
        self.setWordWrap(False)
        self.verticalHeader().setVisible(False)
        self.itemSelectionChanged.connect(lambda: self.marked.emit(self.marked_rows()))

    def show_net(self, degree, points, weights, fourth):
        """Shows the lists of a net, as control_net.value_of takes them."""
        columns = COLUMNS if fourth else tuple(name for name in COLUMNS if name != FOURTH)
        if (columns, degree) != (self._columns, self._degree):
            self._build(columns, degree)
        weights = weights or [1.0] * len(points)
        self._rows = [(*point, *fourth[row:row + 1], weights[row])
                      for row, point in enumerate(points)]
        self._show_numbers()

    def _show_numbers(self):
        digits = _DIGITS - (len(self._columns) > 4)  # of four dimensions there is less room
        size = _largest(x for line in self._rows for x in line[:-1])
        sizes = [size] * (len(self._columns) - 1) + [_largest(line[-1] for line in self._rows)]
        for row, line in enumerate(self._rows):
            for column, (number, size) in enumerate(zip(line, sizes), start=1):
                item = self.item(row, column)
                item.setText(numbers.coordinate(number, size, digits))
                item.setBackground(QtGui.QBrush())

    def show_wrong(self, row, column):
        """Marks the number that keeps the net from being one."""
        if column in self._columns:
            color = QtGui.QColor(colors.GAP)
            color.setAlpha(90)
            self.item(row, 1 + self._columns.index(column)).setBackground(color)
            self.scrollToItem(self.item(row, _INDEX))
            self.clearSelection()  # its colour would hide that of the cell

    def marked_rows(self):
        return sorted({index.row() for index in self.selectedIndexes()})

    def number_at(self, row, column):
        """The number in a cell, all its digits."""
        return self._rows[row][column - 1]

    def take(self, row, column, text):
        """What was typed into a cell."""
        name = self._columns[column - 1]
        number = _number(text)
        if number is None:
            self.refused.emit(translate("Osculate", "“{}” is no finite number: {} of point {} "
                                                    "stays as it was.").format(
                text, name, name_of(self._degree, row)))
        elif number != self._rows[row][column - 1]:
            self.typed.emit(row, name, number)

    def _build(self, columns, degree):
        self._columns, self._degree = columns, degree
        names = indices_of(degree)
        self.clear()
        self.setColumnCount(1 + len(columns))
        self.setRowCount(len(names))
        self.setHorizontalHeaderLabels(["i j k l", *map(_head, columns)])
        for row, index in enumerate(names):
            item = QtWidgets.QTableWidgetItem(" ".join(map(str, index)))
            item.setFlags(Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable)
            self.setItem(row, _INDEX, item)
            for column in range(1, 1 + len(columns)):
                item = QtWidgets.QTableWidgetItem()
                item.setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
                self.setItem(row, column, item)
        self._make_widths()
        self._make_height()

    def showEvent(self, event):
        super().showEvent(event)
        self._make_height()  # a style sheet sets that of the rows just before

    def _make_widths(self):
        header = self.horizontalHeader()
        header.setSectionResizeMode(QtWidgets.QHeaderView.ResizeMode.Stretch)
        header.setSectionResizeMode(_INDEX, QtWidgets.QHeaderView.ResizeMode.ResizeToContents)
        header.setMinimumSectionSize(40)

    def _make_height(self):
        rows = min(self.rowCount(), _ROWS_SHOWN) * self.rowHeight(0)
        frame = self.contentsMargins().top() + self.contentsMargins().bottom()
        self.setFixedHeight(self.horizontalHeader().sizeHint().height() + rows + frame + 2)


class _NumberDelegate(QtWidgets.QStyledItemDelegate):
    """Edits a number as text with all its digits."""

    def setEditorData(self, editor, index):
        editor.setText(repr(float(self.parent().number_at(index.row(), index.column()))))
        editor.selectAll()

    def setModelData(self, editor, _model, index):
        self.parent().take(index.row(), index.column(), editor.text())


def _largest(values):
    return max((abs(value) for value in values if math.isfinite(value)), default=0.0)


def _head(column):
    return {WEIGHT: translate("Osculate", "weight"),
            FOURTH: translate("Osculate", "fourth")}.get(column, column)


def _number(text):
    """The finite number that a text is, or None."""
    try:
        number = float(text.strip().replace(",", ".").replace("−", "-"))
    except ValueError:
        return None
    return number if math.isfinite(number) else None
