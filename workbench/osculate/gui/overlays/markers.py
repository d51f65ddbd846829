"""Disks and squares of any size in pixels for coin.SoMarkerSet, which draws many points at once.

FreeCAD has markers of a few sizes only, and other ones in each version.
"""

import functools

import numpy
from pivy import coin

from osculate.gui.overlays import nodes
from osculate.gui.qt import QtGui

_RIM, _RIM_WIDTH = (1.0, 1.0, 1.0), 1.0


@functools.lru_cache(maxsize=None)
def disk(pixels):
    """The index of a marker: a filled disk that is so many pixels of the device wide."""
    middle, radius = (pixels - 1) / 2.0, pixels / 2.0
    return _marker(pixels, lambda row, column: (
        (row - middle) ** 2 + (column - middle) ** 2 <= radius ** 2))


@functools.lru_cache(maxsize=None)
def square(pixels):
    """The index of a marker: a filled square that is so many pixels of the device wide."""
    return _marker(pixels, lambda row, column: True)


def _marker(pixels, is_filled):
    number = coin.SoMarkerSet.getNumDefinedMarkers()
    picture = "".join("x" if is_filled(row, column) else " "
                      for row in range(pixels) for column in range(pixels))
    coin.SoMarkerSet.addMarker(number, coin.SbVec2s(pixels, pixels), picture, False, True)
    return number


class Points:
    """Many points of one look with a pale rim; `node` goes into the scene."""

    def __init__(self, kind, color, size):
        """kind: `disk` or `square`. size: in points of the screen."""
        density = QtGui.QGuiApplication.primaryScreen().devicePixelRatio()
        self._coordinates = coin.SoCoordinate3()
        self._markers = []
        parts = [nodes.unlit(), self._coordinates]
        for look, width in ((_RIM, size + 2.0 * _RIM_WIDTH), (nodes.rgb(color), size)):
            markers = coin.SoMarkerSet()
            markers.markerIndex = kind(max(round(width * density), 1))
            self._markers.append(markers)
            parts += [*nodes.flat_color(look), markers]
        self.node = nodes.separator(*parts)
        self.show(numpy.empty((0, 3)))

    def show(self, points):
        """Draws (n, 3) points."""
        self._coordinates.point.setNum(len(points))
        self._coordinates.point.setValues(0, len(points), points.tolist())
        for markers in self._markers:
            markers.numPoints = len(points)
