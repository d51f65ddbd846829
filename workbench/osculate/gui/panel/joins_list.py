"""All joins of a wire, a sketch or an edge, worst first."""

from osculate.gui import resources
from osculate.gui.qt import Qt, QtCore, QtWidgets, Signal, translate
from osculate.gui.verdict import look_of, missing_text

_ROWS_SHOWN = 6


class JoinsList(QtWidgets.QWidget):
    """A table of joins; the chosen one is shown in the rest of the panel."""

    chosen = Signal(object)     #: JoinPlace of a row that was clicked
    activated = Signal(object)  #: JoinPlace of a row that was double-clicked

    def __init__(self):
        super().__init__()
        self.summary = QtWidgets.QLabel()
        self.summary.setWordWrap(True)
        self.model = JoinsModel()
        self.view = QtWidgets.QTableView()
        self.view.setModel(self.model)
        self.view.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectionBehavior.SelectRows)
        self.view.setSelectionMode(QtWidgets.QAbstractItemView.SelectionMode.SingleSelection)
        self.view.setAlternatingRowColors(True)
        self.view.setShowGrid(False)
        self.view.setWordWrap(False)
        self.view.setIconSize(QtCore.QSize(24, 20))
        self.view.verticalHeader().hide()
        header = self.view.horizontalHeader()
        header.setSectionResizeMode(0, QtWidgets.QHeaderView.ResizeMode.Fixed)
        header.setSectionResizeMode(1, QtWidgets.QHeaderView.ResizeMode.Stretch)
        header.setSectionResizeMode(2, QtWidgets.QHeaderView.ResizeMode.ResizeToContents)
        header.resizeSection(0, 42)
        self.view.selectionModel().currentRowChanged.connect(self._row_changed)
        self.view.doubleClicked.connect(self._double_clicked)
        self.view.setToolTip(translate("Osculate", "Double-click zooms to the join"))
        layout = QtWidgets.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(3)
        layout.addWidget(self.summary)
        layout.addWidget(self.view)

    def show_joins(self, joins, current):
        """Shows (JoinPlace, JoinReport) pairs, as they are sorted."""
        if joins is not self.model.joins:  # a reset in the middle of a double-click would end it
            self._set_joins(joins)
        self._select(current)

    def _set_joins(self, joins):
        self.model.set_joins(joins)
        self.summary.setText(_summary(joins))
        row_height = self.view.verticalHeader().defaultSectionSize()
        rows = min(len(joins), _ROWS_SHOWN)
        self.view.setFixedHeight(self.view.horizontalHeader().sizeHint().height()
                                 + rows * row_height + 4)

    def _select(self, current):
        for row, (place, _) in enumerate(self.model.joins):
            if place == current:
                selection = self.view.selectionModel()
                blocked = selection.blockSignals(True)
                self.view.selectRow(row)
                selection.blockSignals(blocked)
                self.view.viewport().update()
                return

    def _row_changed(self, current, _previous):
        if current.isValid():
            self.chosen.emit(self.model.joins[current.row()][0])

    def _double_clicked(self, index):
        self.activated.emit(self.model.joins[index.row()][0])


class JoinsModel(QtCore.QAbstractTableModel):
    """Rows: order as an icon, which edges, what is missed."""

    def __init__(self):
        super().__init__()
        self.joins = []

    def set_joins(self, joins):
        self.beginResetModel()
        self.joins = joins
        self.endResetModel()

    def rowCount(self, parent=QtCore.QModelIndex()):
        return 0 if parent.isValid() else len(self.joins)

    def columnCount(self, parent=QtCore.QModelIndex()):
        return 0 if parent.isValid() else 3

    def headerData(self, section, orientation, role=Qt.ItemDataRole.DisplayRole):
        if orientation == Qt.Orientation.Horizontal and role == Qt.ItemDataRole.DisplayRole:
            return ("", translate("Osculate", "Join"), translate("Osculate", "Misses"))[section]
        return None

    def data(self, index, role=Qt.ItemDataRole.DisplayRole):
        place, report = self.joins[index.row()]
        if role == Qt.ItemDataRole.ToolTipRole:
            return f"{place.label()}: {report.headline}"
        if role == Qt.ItemDataRole.DecorationRole and index.column() == 0:
            return resources.icon(look_of(report.order, report.verdicts).icon)
        if role == Qt.ItemDataRole.DisplayRole:
            return ("", place.label(), _missed(report))[index.column()]
        return None


def _missed(report):
    return missing_text(report.order, report.verdicts, report.residuals, short=True)


def _summary(joins):
    """How many joins there are and how many have each order, e.g. "12 joins: 3 G1, 9 G4"."""
    counts = {}
    for _, report in joins:
        name = look_of(report.order, report.verdicts).name
        counts[name] = counts.get(name, 0) + 1
    listed = ", ".join(f"{count} {name}" for name, count in counts.items())
    return translate("Osculate", "{} joins, worst first: {}").format(len(joins), listed)
