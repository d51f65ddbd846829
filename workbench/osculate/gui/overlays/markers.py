"""Disks of any size in pixels for coin.SoMarkerSet, which draws many points at once.

FreeCAD has markers of a few sizes only, and other ones in each version.
"""

import functools

from pivy import coin


@functools.lru_cache(maxsize=None)
def disk(pixels):
    """The index of a marker: a filled disk that is so many pixels of the device wide."""
    number = coin.SoMarkerSet.getNumDefinedMarkers()
    coin.SoMarkerSet.addMarker(number, coin.SbVec2s(pixels, pixels), _picture(pixels), False, True)
    return number


def _picture(pixels):
    """One character for each pixel, an "x" where the disk is."""
    middle, radius = (pixels - 1) / 2.0, pixels / 2.0
    return "".join("x" if (row - middle) ** 2 + (column - middle) ** 2 <= radius ** 2 else " "
                   for row in range(pixels) for column in range(pixels))
