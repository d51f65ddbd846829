"""Widgets beside each other."""

from osculate.gui.qt import QtWidgets


def row_of(*widgets):
    """A widget that holds others beside each other; a pair is a widget and its stretch."""
    row = QtWidgets.QWidget()
    layout = QtWidgets.QHBoxLayout(row)
    layout.setContentsMargins(0, 0, 0, 0)
    for widget in widgets:
        layout.addWidget(*widget if isinstance(widget, tuple) else (widget,))
    return row
