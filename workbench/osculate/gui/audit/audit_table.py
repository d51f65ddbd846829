"""The table of the joins of an audit."""

from osculate.gui.audit.audit_model import JOIN, MISSES, ORDER, RANK, AuditModel
from osculate.gui.qt import Qt, QtCore, QtWidgets, Signal

_WIDTHS = {RANK: 48, ORDER: 32, MISSES: 100}
_RESIDUAL_WIDTH = 76
_JOIN_WIDTHS, _MARGIN = (90, 140), 12  # least and most
_LEAST_HEIGHT, _LINE = 190, 22


class AuditTable(QtWidgets.QTableView):
    """Joins in lines; a click on a head sorts by it."""

    chosen = Signal(int)   #: the index of the row that became current by mouse or key
    wanted = Signal(int)   #: of one that was double-clicked

    def __init__(self):
        super().__init__()
        self.rows_shown = AuditModel()
        self.setModel(self.rows_shown)
        self.setSelectionBehavior(self.SelectionBehavior.SelectRows)
        self.setSelectionMode(self.SelectionMode.SingleSelection)
        self.setAlternatingRowColors(True)
        self.setShowGrid(False)
        self.setWordWrap(False)
        self.setIconSize(QtCore.QSize(22, 18))
        self.setMinimumHeight(_LEAST_HEIGHT)
        self.setHorizontalScrollMode(self.ScrollMode.ScrollPerPixel)
        lines = self.verticalHeader()
        lines.hide()
        lines.setSectionResizeMode(QtWidgets.QHeaderView.ResizeMode.Fixed)  # or Qt asks every line
        lines.setDefaultSectionSize(_LINE)
        self.setSortingEnabled(True)
        self.sortByColumn(RANK, Qt.SortOrder.AscendingOrder)
        self.selectionModel().currentRowChanged.connect(self._line_changed)
        self.rows_shown.modelReset.connect(self._keep_current)
        self.doubleClicked.connect(lambda index: self.wanted.emit(
            int(self.rows_shown.members[index.row()])))
        self._current = None
        self._columns = 0

    @property
    def current(self):
        """The index of the current row, or None; also while a filter hides it."""
        return self._current

    def show_rows(self, audited, required, wanted):
        """Shows the rows of an Audited that a RowFilter wants."""
        self.rows_shown.is_dark = self.palette().color(self.foregroundRole()).lightness() > 128
        self.rows_shown.show(audited, required, wanted)
        if self.rows_shown.columnCount() != self._columns:
            self._columns = self.rows_shown.columnCount()
            for column in range(self._columns):
                self.setColumnWidth(column, _WIDTHS.get(column, _RESIDUAL_WIDTH))
            label = max(self.rows_shown.last_labels(), key=len, default="")
            width = self.fontMetrics().horizontalAdvance(label) + _MARGIN
            self.setColumnWidth(JOIN, min(max(width, _JOIN_WIDTHS[0]), _JOIN_WIDTHS[1]))

    def show_current(self, index):
        """Makes the row of an index the current one without telling anyone; None for none."""
        self._current = index
        self._keep_current()

    def _keep_current(self):
        line = None if self._current is None else self.rows_shown.line_of(self._current)
        if line is None:
            return
        blocked = self.selectionModel().blockSignals(True)
        self.selectRow(line)
        self.selectionModel().blockSignals(blocked)
        self.scrollTo(self.rows_shown.index(line, RANK))
        self.viewport().update()

    def _line_changed(self, current, _previous):
        if current.isValid():
            self._current = int(self.rows_shown.members[current.row()])
            self.chosen.emit(self._current)
