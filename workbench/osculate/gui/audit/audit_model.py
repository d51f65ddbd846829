"""The joins of an audit as the model of a table.

It sorts and filters by itself, in numpy: a QSortFilterProxyModel would ask Python for two values at
each comparison, some seconds for a hundred thousand rows.
"""

import functools

import numpy

from osculate.audit_rows import RowFilter
from osculate.gui import colors, numbers, resources
from osculate.gui.audit import audit_words
from osculate.gui.qt import Qt, QtCore, QtGui, translate
from osculate.gui.verdict import missing_text

RANK, ORDER, JOIN, MISSES = range(4)
_KEYS = ("rank", "order", "edges", "missed_by")  # of these columns; then residuals follow
_FIRST_RESIDUAL = len(_KEYS)
_ALIGNED = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
_RIGHT = int(getattr(_ALIGNED, "value", _ALIGNED))  # Qt 6 enumerations keep it in `value`


class AuditModel(QtCore.QAbstractTableModel):
    """The rows of an Audited that a filter wants, in the order of a column."""

    def __init__(self):
        super().__init__()
        self.is_dark = False  #: whether it is shown on dark
        self.members = numpy.empty(0, int)  #: what is shown: indices of rows, from top to bottom
        self._audited, self._required = None, 0
        self._filter = RowFilter()
        self._column, self._is_descending = RANK, False

    @property
    def rows(self):
        """The AuditRows, or None."""
        return self._audited and self._audited.rows

    def show(self, audited, required, wanted):
        """Shows the rows of an Audited that a RowFilter wants; those below the order `required`
        stand out.
        """
        self.beginResetModel()
        self._audited, self._required, self._filter = audited, required, wanted
        self._arrange()
        self.endResetModel()

    def sort(self, column, order=Qt.SortOrder.AscendingOrder):
        self.beginResetModel()
        self._column = column
        self._is_descending = order == Qt.SortOrder.DescendingOrder
        self._arrange()
        self.endResetModel()

    def _arrange(self):
        if self.rows is None:
            self.members = numpy.empty(0, int)
            return
        column = min(self._column, self.columnCount() - 1)
        key = (_KEYS[column] if column < _FIRST_RESIDUAL else column - _FIRST_RESIDUAL)
        self.members = self.rows.sorted(self.rows.chosen(self._filter), key, self._is_descending)

    def last_labels(self):
        """What some joins of the edges with the highest numbers are called."""
        if self.rows is None:
            return []
        last = self.rows.sorted(numpy.arange(len(self.rows)), "edges")[-8:]
        return [self._label(index) for index in last]

    def line_of(self, index):
        """The line in which the row of an index stands; None if it is not shown."""
        found = numpy.flatnonzero(self.members == index)
        return int(found[0]) if len(found) else None

    # What Qt asks

    def rowCount(self, parent=QtCore.QModelIndex()):
        return 0 if parent.isValid() else len(self.members)

    def columnCount(self, parent=QtCore.QModelIndex()):
        if parent.isValid():
            return 0
        return _FIRST_RESIDUAL + (self.rows.highest + 1 if self.rows is not None else 0)

    def headerData(self, section, orientation, role=Qt.ItemDataRole.DisplayRole):
        if orientation != Qt.Orientation.Horizontal:
            return None
        if role == Qt.ItemDataRole.DisplayRole:
            return _head(section)
        if role == Qt.ItemDataRole.ToolTipRole:
            return _tip(section)
        return None

    def data(self, index, role=Qt.ItemDataRole.DisplayRole):
        member, column = self.members[index.row()], index.column()
        if role == Qt.ItemDataRole.DisplayRole:
            return self._text(member, column)
        if role == Qt.ItemDataRole.DecorationRole and column == ORDER:
            return _icon(audit_words.look_of_row(self.rows, member).icon)
        if role == Qt.ItemDataRole.TextAlignmentRole and (column == RANK or column > MISSES):
            return _RIGHT
        if role == Qt.ItemDataRole.ForegroundRole and column > MISSES:
            return self._color(member, column - _FIRST_RESIDUAL)
        if role == Qt.ItemDataRole.ToolTipRole:
            return f"{self._label(member)}: {audit_words.look_of_row(self.rows, member).name}"
        return None

    def _text(self, member, column):
        if column == RANK:
            return str(self.rows.rank[member])
        if column == JOIN:
            return self._label(member)
        if column == MISSES:
            return missing_text(int(self.rows.order[member]),
                                audit_words.verdicts_of(self.rows, member),
                                self.rows.residuals[member], short=True)
        if column >= _FIRST_RESIDUAL:
            order = column - _FIRST_RESIDUAL
            return numbers.residual(order, float(self.rows.residuals[member, order]))
        return None

    def _label(self, member):
        return self._audited.model.row_label(self._audited.report.rows[int(member)])

    def _color(self, member, order):
        """Of an order that is missed though it is required."""
        verdict = audit_words.verdicts_of(self.rows, member)[order]
        if order > self._required or verdict == "pass":
            return None
        return QtGui.QBrush(QtGui.QColor(colors.VERDICT_TEXT[verdict][self.is_dark]))


def _head(column):
    if column < _FIRST_RESIDUAL:
        return (translate("Osculate", "No."), "", translate("Osculate", "Join"),
                translate("Osculate", "Misses"))[column]
    return audit_words.residual_name(column - _FIRST_RESIDUAL)


def _tip(column):
    if column < _FIRST_RESIDUAL:
        return (translate("Osculate", "The worst join has number 1; the labels in the 3D view say "
                                      "these numbers"),
                translate("Osculate", "Order of continuity"),
                translate("Osculate", "The edges that meet, or the edge with an inner knot"),
                translate("Osculate", "The next order and what is missed of it; sorted by how many "
                                      "tolerances that is"))[column]
    return translate("Osculate", "Deviation of this order")


@functools.lru_cache(maxsize=None)
def _icon(name):
    return resources.icon(name)
