"""A table of named rows that the user marks: edges of a chain, points of a curve."""

from osculate.gui.qt import Qt, QtCore, QtWidgets

_ROWS_SHOWN = 6


class RowTable(QtWidgets.QTableWidget):
    """A stretched column of names and narrow ones of the subclass."""

    def __init__(self, heads, width):
        super().__init__(0, len(heads))
        self._names = None
        self.setHorizontalHeaderLabels(heads)
        self.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectionBehavior.SelectRows)
        self.setEditTriggers(QtWidgets.QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setAlternatingRowColors(True)
        self.setShowGrid(False)
        self.setWordWrap(False)
        self.setIconSize(QtCore.QSize(24, 20))
        header = self.horizontalHeader()
        header.setSectionResizeMode(0, QtWidgets.QHeaderView.ResizeMode.Stretch)
        for column in range(1, len(heads)):
            header.setSectionResizeMode(column, QtWidgets.QHeaderView.ResizeMode.Fixed)
            header.resizeSection(column, width)
        self.show_names(())

    def show_names(self, names):
        """Shows a row for each name; marked rows stay marked where the names do."""
        names = list(names)
        if names == self._names:
            return
        self._names = names
        self.setRowCount(len(names))
        for row, name in enumerate(names):
            self.setItem(row, 0, QtWidgets.QTableWidgetItem(name))
            for column in range(1, self.columnCount()):
                item = QtWidgets.QTableWidgetItem()
                item.setTextAlignment(Qt.AlignmentFlag.AlignCenter)
                self.setItem(row, column, item)
        height = self.verticalHeader().defaultSectionSize()
        self.setFixedHeight(self.horizontalHeader().sizeHint().height()
                            + max(1, min(len(names), _ROWS_SHOWN)) * height + 4)

    def marked(self):
        """The numbers of the rows that the user marked, from 0."""
        return sorted({index.row() for index in self.selectedIndexes()})

    def mark(self, row):
        """Marks one row."""
        if 0 <= row < self.rowCount():
            self.selectRow(row)
