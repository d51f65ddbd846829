"""Coin nodes that every overlay is made of: lines with a rim, arrow heads, nothing to pick."""

import contextlib
import gc

import numpy
from pivy import coin

_HALO = (1.0, 1.0, 1.0)
_HALO_TRANSPARENCY = 0.45
_HALO_WIDTH = 2.0

#: Bits of SoDrawStyle.linePattern, left to right.
SOLID, DASHED = 0xFFFF, 0xF0F0


def separator(*children):
    node = coin.SoSeparator()
    for child in children:
        node.addChild(child)
    return node


def rgb(name):
    """(r, g, b) in 0..1 of "#rrggbb"."""
    return tuple(int(name[i:i + 2], 16) / 255.0 for i in (1, 3, 5))


def flat_color(color, transparency=0.0):
    """Nodes for a colour that no light changes."""
    material = coin.SoMaterial()
    material.diffuseColor = color
    material.transparency = transparency
    return unlit(), material


def unlit():
    """A node after which no light changes colours."""
    light = coin.SoLightModel()
    light.model = coin.SoLightModel.BASE_COLOR
    return light


def line_style(width, pattern=SOLID):
    style = coin.SoDrawStyle()
    style.lineWidth = width
    style.linePattern = pattern
    return style


def _stroke(line, color, style, transparency=0.0, has_rim=False):
    """The nodes of a line in a colour, over a pale rim or not."""
    parts = [*flat_color(rgb(color), transparency), style, *line]
    if has_rim:
        rim = line_style(style.lineWidth.getValue() + _HALO_WIDTH)
        parts.insert(0, separator(*flat_color(_HALO, _HALO_TRANSPARENCY), rim, *line))
    return separator(*parts)


class Polyline:
    """A line of `width` pixels through points; a solid one has a pale rim, which lifts it off the
    model. `node` goes into the scene.
    """

    def __init__(self, points, color, width, pattern=SOLID):
        self._coordinates = coin.SoCoordinate3()
        self._lines = coin.SoLineSet()
        line = self._coordinates, self._lines
        self.node = _stroke(line, color, line_style(width, pattern), has_rim=pattern == SOLID)
        self.move(points)

    def move(self, points):
        """Leads through other (n, 3) points."""
        points = [tuple(map(float, point)) for point in points]
        self._coordinates.point.setNum(len(points))
        self._coordinates.point.setValues(0, len(points), points)
        self._lines.numVertices.setValue(len(points))  # of 0 points Coin draws nothing


class Polylines:
    """Many lines of one colour through arrays of points, fast to change; `node` goes into the
    scene. A pale rim lifts them off the model.
    """

    def __init__(self, color, width, transparency=0.0, has_rim=False):
        self._coordinates = coin.SoCoordinate3()
        self._lines = coin.SoLineSet()
        line = self._coordinates, self._lines
        self.node = _stroke(line, color, line_style(width), transparency, has_rim)
        self.show(numpy.empty((0, 3)), ())

    def show(self, points, counts):
        """Leads through (n, 3) points, in pieces of so many points each."""
        set_points(self._coordinates, points)
        counts = [int(count) for count in counts] or [0]  # without a number Coin takes all points
        self._lines.numVertices.setNum(len(counts))
        self._lines.numVertices.setValues(0, len(counts), counts)


class IndexedLines:
    """Lines of one colour through some of the points of an SoCoordinate3 that others share; `node`
    goes into the scene after it. A pale rim lifts them off the model.
    """

    def __init__(self, color, width, transparency=0.0, has_rim=False):
        self._lines = coin.SoIndexedLineSet()
        self._indices = None
        self.node = _stroke((self._lines,), color, line_style(width), transparency, has_rim)
        self.show(numpy.empty(0, int))

    def show(self, indices):
        """Leads through the points of these numbers; -1 ends a line."""
        if numpy.array_equal(indices, self._indices):
            return  # the usual case while a curve is dragged
        self._indices = indices
        self._lines.coordIndex.setNum(len(indices))
        self._lines.coordIndex.setValues(0, len(indices), indices.tolist())


def set_points(coordinates, points):
    """Gives an SoCoordinate3 the (n, 3) points of an array."""
    coordinates.point.setNum(len(points))
    with _without_collector():
        coordinates.point.setValues(0, len(points), points.tolist())


@contextlib.contextmanager
def _without_collector():
    """Python's collector would search all objects again and again while many lists are made: that
    takes longer than making them.
    """
    was_enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_enabled:
            gc.enable()


def colored_polyline(points, color, width, pattern=SOLID):
    """A Polyline that stays as it is."""
    return Polyline(points, color, width, pattern).node


def plain_lines(lines, color, width):
    """Lines of `width` pixels without a rim, each through some points."""
    points = [tuple(map(float, point)) for line in lines for point in line]
    coordinates, line_set = coin.SoCoordinate3(), coin.SoLineSet()
    coordinates.point.setValues(0, len(points), points)
    line_set.numVertices.setValues(0, len(lines), [len(line) for line in lines])
    return separator(*flat_color(rgb(color)), line_style(width), coordinates, line_set)


def arrow_head(tip, direction, color, length, radius):
    """A cone that ends at `tip` and points along `direction`."""
    cone = coin.SoCone()
    cone.height = length
    cone.bottomRadius = radius
    transform = coin.SoTransform()
    axis = coin.SbVec3f(*map(float, direction))
    axis.normalize()
    transform.translation = coin.SbVec3f(*map(float, tip)) - axis * (length / 2.0)
    transform.rotation = coin.SbRotation(coin.SbVec3f(0, 1, 0), axis)
    return separator(*flat_color(rgb(color)), transform, cone)


def room(point, reach):
    """Nothing that is seen, `reach` mm around a point on all sides.

    Coin sets the near plane close before the model, and where that is behind the camera a little
    into it: a picture at the foremost point would be cut.
    """
    style, coordinates = coin.SoDrawStyle(), coin.SoCoordinate3()
    style.style = coin.SoDrawStyle.INVISIBLE
    for number, sign in enumerate((-1.0, 1.0)):
        coordinates.point.set1Value(number, *(float(x) + sign * reach for x in point))
    return separator(style, coordinates, coin.SoPointSet())


def at(point, *children):
    """Children moved to a point."""
    translation = coin.SoTranslation()
    translation.translation = tuple(map(float, point))
    return separator(translation, *children)


def untouchable(*children):
    """Children drawn over the model that cannot be picked."""
    annotation = coin.SoAnnotation()
    for child in (unpickable(), *children):
        annotation.addChild(child)
    return annotation


def unpickable():
    """A node after which nothing can be picked."""
    pick = coin.SoPickStyle()
    pick.style = coin.SoPickStyle.UNPICKABLE
    return pick


def without_extent(*children):
    """Children that do not count as part of the model where a view is fitted to it."""
    group = coin.SoType.fromName("SoSkipBoundingGroup").createInstance()
    for child in children:
        group.addChild(child)
    return group
