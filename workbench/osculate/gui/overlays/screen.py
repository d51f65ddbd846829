"""Between the model and the pixels of one 3D view."""

import math

import numpy
from pivy import coin

from osculate.gui.overlays.pixel_scale import sideways

#: Sine of the angle to the line of sight below which nothing can be dragged along a line.
_END_ON = 0.05


class Screen:
    """What a view shows at the moment. Pixels are those of the device, from the lower left."""

    def __init__(self, view):
        self._width, self._height = view.getSize()
        self._volume = view.getCameraNode().getViewVolume(self._width / self._height)
        self._matrix = self._volume.getMatrix()  # to -1 .. 1 in width, height and depth

    def pixel_of(self, point):
        """(x, y) of a point of the model."""
        x, y, _ = self._matrix.multVecMatrix(_vector(point)).getValue()
        return (x + 1.0) / 2.0 * self._width, (y + 1.0) / 2.0 * self._height

    def pixels_of(self, points):
        """(n, 2) pixels of (n, 3) points of the model; NaN for those behind the viewer."""
        matrix = numpy.array(self._matrix.getValue())
        seen = numpy.column_stack((points, numpy.ones(len(points)))) @ matrix
        seen[seen[:, 3] <= 0.0] = numpy.nan
        return (seen[:, :2] / seen[:, 3:] + 1.0) / 2.0 * (self._width, self._height)

    def beside(self, point, direction, pixels):
        """The point of the model that pixel_scale.beside moves a point to."""
        return tuple(_vector(point) + sideways(self._volume, point, direction, pixels,
                                               self._height))

    def along(self, origin, direction, pixel):
        """How far from `origin` on a line the model is seen under a pixel, in mm.

        None where the line points at the viewer, or is behind.
        """
        near, far = self._sight(pixel)
        sight = far - near
        sight.normalize()
        direction = _vector(direction)
        cosine = sight.dot(direction)
        if 1.0 - cosine * cosine < _END_ON ** 2:
            return None
        # The point of the line that is nearest to the line of sight.
        between = near - _vector(origin)
        distance = (between.dot(direction) - cosine * between.dot(sight)) / (1.0 - cosine * cosine)
        return distance if math.isfinite(distance) else None

    def beneath(self, pixel, point):
        """The point of the model that is seen under a pixel, as far from the viewer as `point`.

        None where the sight does not reach so far, as behind the camera.
        """
        near, far = self._sight(pixel)
        sight = far - near
        across = self._volume.getProjectionDirection()
        slope = sight.dot(across)
        if slope <= 0.0:
            return None
        return tuple(near + sight * ((_vector(point) - near).dot(across) / slope))

    def _sight(self, pixel):
        """The points of the near and the far plane under a pixel."""
        x, y = (2.0 * place / size - 1.0 for place, size in zip(pixel, (self._width, self._height)))
        to_model = self._matrix.inverse()
        return tuple(to_model.multVecMatrix(coin.SbVec3f(x, y, depth)) for depth in (-1.0, 1.0))


def _vector(point):
    return coin.SbVec3f(*map(float, point))
