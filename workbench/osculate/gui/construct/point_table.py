"""The points of a curve: where each comes from, and its tension."""

from osculate.gui import numbers
from osculate.gui.construct.row_table import RowTable
from osculate.gui.qt import translate


class PointTable(RowTable):
    """A row a point: the vertex, or its coordinates, and its tension."""

    def __init__(self):
        super().__init__((translate("Osculate", "Point"), translate("Osculate", "Tension")), 70)

    def show_points(self, names, tensions, own):
        """Shows names of points, tensions, and which of them are the points' own."""
        self.show_names(names)
        for row, (tension, is_own) in enumerate(zip(tensions, own)):
            item = self.item(row, 1)
            item.setText(numbers.number(tension))
            font = item.font()
            font.setBold(is_own)
            item.setFont(font)
