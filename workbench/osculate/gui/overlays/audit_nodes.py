"""The joins of an audit in the 3D view: a dot each in the colour of its order, and numbers."""

import numpy
from pivy import coin

from osculate.gui import colors
from osculate.gui.overlays import markers, nodes, sprites

#: Widths of dots and of the rims under them, in pixels of the device.
_OUT_OF_TOLERANCE, _WITHIN = (9, 13), (5, 7)
_MOST_DISKS = 200  # of more joins the dots are squares: a disk takes Coin 0.1 ms at each drawing
_HALO = "#ffffff"
_NEARER = 1e-3  # by this share of the depth dots lie before the edges and faces that they are on


def color_key(order):
    """The key of an order in a legend."""
    return "circle", colors.of_order(order), True


class AuditNodes:
    """What is drawn of AuditRows; `node` goes into the scene."""

    labels = 0            #: how many joins have a number
    out_of_tolerance = 0  #: how many there are that should have one

    def __init__(self):
        self.counts = {}  #: order -> how many joins of it are drawn, the worst first
        self.to_world = coin.SoMatrixTransform()
        self._dots, self._numbers = nodes.separator(), nodes.separator()
        self._small_dots = nodes.separator()  # faces before them hide them, not the others
        self.node = nodes.separator(
            self.to_world, nodes.separator(nodes.unpickable(), _nearer(), self._small_dots),
            nodes.untouchable(self._dots, self._numbers))
        self._shown = None  # what was drawn, so that it is not drawn again

    def show(self, rows, below, required, most_labels, text_points):
        """Draws the joins of lower order than `below` (None: all) and numbers of the worst of those
        below `required`.
        """
        wanted = below, required, most_labels, text_points
        if self._shown is not None and self._shown[0] is rows and self._shown[1] == wanted:
            return
        self._shown = rows, wanted
        drawn = rows.worst(below=below)
        self._show_dots(rows, drawn, required)
        amiss = rows.worst(below=required if below is None else min(below, required))
        self.out_of_tolerance, self.labels = len(amiss), min(len(amiss), most_labels)
        self._numbers.removeAllChildren()
        for member in amiss[:self.labels]:
            self._numbers.addChild(nodes.at(rows.point[member], sprites.note(
                str(rows.rank[member]), text_points, colors.of_order(int(rows.order[member])))))

    def clear(self):
        """Draws nothing."""
        self._shown = None
        self.counts = {}
        self.labels = self.out_of_tolerance = 0
        for part in (self._dots, self._small_dots, self._numbers):
            part.removeAllChildren()

    def _show_dots(self, rows, drawn, required):
        self._dots.removeAllChildren()
        self._small_dots.removeAllChildren()
        orders = rows.order[drawn]
        make = _disks if len(drawn) <= _MOST_DISKS else _squares
        self.counts = {int(order): int((orders == order).sum()) for order in numpy.unique(orders)}
        for order in reversed(list(self.counts)):  # the worst over the others
            points = _coordinates(rows.point[drawn[orders == order]])
            is_amiss = order < required
            parent = self._dots if is_amiss else self._small_dots
            dot, rim = _OUT_OF_TOLERANCE if is_amiss else _WITHIN
            parent.addChild(nodes.separator(
                points, _colored(_HALO, make(rim)),
                _colored(colors.of_order(order), make(dot))))


def _nearer():
    depth = coin.SoDepthBuffer()
    depth.function = coin.SoDepthBuffer.LEQUAL
    depth.range = (0.0, 1.0 - _NEARER)
    return depth


def _colored(color, parts):
    return nodes.separator(*nodes.flat_color(nodes.rgb(color)), *parts)


def _coordinates(points):
    coordinates = coin.SoCoordinate3()
    coordinates.point.setValues(0, len(points), points.tolist())
    return coordinates


def _disks(width):
    disks = coin.SoMarkerSet()
    disks.markerIndex = markers.disk(width)
    return (disks,)


def _squares(width):
    style = coin.SoDrawStyle()
    style.pointSize = width
    return style, coin.SoPointSet()
