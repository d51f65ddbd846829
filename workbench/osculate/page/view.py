"""Parallel projections of space onto a picture."""

import math
from typing import NamedTuple

import numpy

#: From where FreeCAD's isometric view looks, and what points up in it.
_ISOMETRIC, _UP = numpy.array([1.0, -1.0, 1.0]) / math.sqrt(3.0), numpy.array([0.0, 0.0, 1.0])

#: Points are taken as plane where they are this flat.
_FLAT = 0.02


class View(NamedTuple):
    """A picture with y down, in whose middle `center` is seen."""

    axes: numpy.ndarray    #: (3, 3): unit vectors to the right, up, and towards the eye
    center: numpy.ndarray  #: (3,): mm
    scale: float           #: units of the picture per mm
    size: tuple            #: width and height

    def project(self, points):
        """(..., 2) places in the picture of (..., 3) points."""
        flat = (numpy.asarray(points) - self.center) @ self.axes[:2].T
        return flat * (self.scale, -self.scale) + 0.5 * numpy.array(self.size)

    def depth(self, points):
        """How near (..., 3) points are to the eye: mm from the plane through the middle."""
        return (numpy.asarray(points) - self.center) @ self.axes[2]

    @property
    def unit(self):
        """The size in mm of a unit of the picture."""
        return 1.0 / self.scale


def fitted(points, width, heights, margin):
    """The View of (n, 3) points that fills a width; its height lies in the range `heights`."""
    axes = _axes(points, _ISOMETRIC)
    flat = points @ axes.T
    least, most = flat.min(axis=0), flat.max(axis=0)
    extent = numpy.maximum(most - least, 1e-9 * max(1.0, float(numpy.abs(flat).max())))
    inner = width - 2.0 * margin, heights[1] - 2.0 * margin
    scale = float(min(inner[0] / extent[0], inner[1] / extent[1]))
    height = min(max(extent[1] * scale + 2.0 * margin, heights[0]), heights[1])
    return View(axes, 0.5 * (least + most) @ axes, scale, (width, round(height)))


def close(points, center, radius, size):
    """The View of a ball of a radius around a point, onto the plane of some points near it."""
    return View(_axes(points, _ISOMETRIC, 0.0), center, 0.5 * min(size) / radius, size)


def _axes(points, eye, flat=_FLAT):
    """Onto the plane of the points, if they have one; else as FreeCAD's isometric view.

    flat: 0 takes the plane that fits best, whatever they are.
    """
    spread = points - points.mean(axis=0)
    _, sizes, directions = numpy.linalg.svd(spread.T @ spread)
    thin, wide = math.sqrt(sizes[2]), math.sqrt(sizes[1])
    is_line = wide <= 1e-6 * math.sqrt(sizes[0])
    if is_line or (flat > 0.0 and thin > flat * wide):
        return _upright(eye if not is_line else _across(directions[0]))
    normal = directions[2]
    return _upright(normal if normal @ eye > 0.0 else -normal)


def _across(direction):
    """Of the main views one across a direction, from above if that can be."""
    views = numpy.array([(0.0, 0.0, 1.0), (0.0, -1.0, 0.0), (1.0, 0.0, 0.0)])
    return next(view for view in views if abs(view @ direction) < 0.9)


def _upright(toward):
    """The axes of a view in which z, or from above y, points up."""
    up = _UP if abs(toward @ _UP) < 0.999 else numpy.array([0.0, 1.0, 0.0])
    right = numpy.cross(up, toward)
    right /= numpy.linalg.norm(right)
    return numpy.array([right, numpy.cross(toward, right), toward])
