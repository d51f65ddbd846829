"""A probe in the 3D view: frame, osculating circle, planes, construction, read-out."""

import math
from dataclasses import dataclass

import numpy
from pivy import coin

from osculate.features.probe import radius_of
from osculate.gui import colors
from osculate.gui.overlays import nodes, sprites
from osculate.gui.overlays.comb_nodes import MARK_LOOKS, Marks
from osculate.gui.overlays.construction_nodes import construction_node
from osculate.gui.overlays.frenet_frame import frames_node
from osculate.gui.overlays.point_marker import PointMarker
from osculate.gui.qt import translate

#: How special points are marked; ends are seen without.
SPECIAL_LOOKS = {kind: MARK_LOOKS[kind] for kind in ("inflection", "vertex", "cusp")}
SPECIAL_LOOKS["join"] = SPECIAL_LOOKS["closing"] = ("square", colors.POLYGON_ENDS, True)
SPECIAL_LOOKS["knot"] = ("square", colors.POLYGON_ENDS, False)

_PATTERNS = nodes.SOLID, nodes.DASHED  # before and after the point, where these differ
_CIRCLE_STEPS = 192
_WHOLE = 0.6         # of the size of the curves: the largest radius of a circle that is drawn whole
_MOST_MARKS = 300    # more would be a carpet
_PLANE = 0.16        # half the side of a plane, as a share of the size of the curves
_TRANSPARENCY = 0.72

#: The property of each plane, the axes that span it, and the colour of the third.
PLANES = (("OsculatingPlane", ("tangent", "normal"), colors.FRAME[2]),
          ("NormalPlane", ("normal", "binormal"), colors.FRAME[0]),
          ("RectifyingPlane", ("tangent", "binormal"), colors.FRAME[1]))


@dataclass(frozen=True)
class ProbeLook:
    """What is drawn of a probe, and how large."""

    frame: bool
    circle: bool
    planes: tuple       #: of the names in PLANES
    construction: bool
    label: tuple        #: (name, text), or None
    marks: bool
    frame_pixels: int
    text_points: int


class ProbeNodes:
    """What is drawn of a ProbeReading; `node` goes into the scene."""

    def __init__(self):
        self.node = nodes.separator()
        self._marks = Marks(SPECIAL_LOOKS)
        self._marked = None  # the probe whose points are marked

    def show(self, probe, reading, look):
        """Draws a ProbeReading of a CurveProbe."""
        self.node.removeAllChildren()
        parts = list(_parts(probe.size, reading, look))
        if look.marks:
            self._mark(probe, reading)
            parts.append(self._marks.node)
        marker = PointMarker(colors.CURSOR, look.text_points)
        marker.show(reading.point, *(look.label or ()), avoided=_avoided(reading))
        for part in (*parts, marker.node):
            self.node.addChild(part)

    def clear(self):
        """Draws nothing."""
        self.node.removeAllChildren()

    def _mark(self, probe, reading):
        """Marks special points, of very many those along the curves that are next to the point."""
        numbers = [number for number, special in enumerate(probe.specials)
                   if special.kind in SPECIAL_LOOKS]
        if len(numbers) > _MOST_MARKS:
            distances = numpy.abs([probe.specials[number].s - reading.s for number in numbers])
            numbers = [numbers[i] for i in numpy.argsort(distances)[:_MOST_MARKS]]
        elif probe is self._marked:
            return
        self._marked = probe
        points = {}
        for number in numbers:
            points.setdefault(probe.specials[number].kind, []).append(probe.special_points[number])
        self._marks.show({kind: numpy.array(rows) for kind, rows in points.items()})


def _parts(size, reading, look):
    geometries = [side.geometry for side in reading.sides]
    for name, axes, color in PLANES:
        if name in look.planes:
            # of both sides the planes would hide each other
            yield from _plane(geometries[-1], axes, color, size, plane_name(name),
                              look.text_points)
    if look.construction:
        yield construction_node(reading.sides[-1].polygons())
    if look.circle:
        for geometry, pattern in zip(geometries[::-1], _PATTERNS):
            yield from _circle(geometry, size, pattern)
    if look.frame:
        yield frames_node(geometries[::-1], look.frame_pixels, look.text_points)


def plane_name(name):
    return {"OsculatingPlane": translate("Osculate", "osculating plane"),
            "NormalPlane": translate("Osculate", "normal plane"),
            "RectifyingPlane": translate("Osculate", "rectifying plane")}[name]


def _avoided(reading):
    """Directions that the label keeps off."""
    axes = [axis for side in reading.sides for axis in
            (side.geometry.tangent, side.geometry.normal, side.geometry.binormal)
            if axis is not None]
    return [*axes, -axes[0]] if axes else []


def is_whole(radius, size):
    """Whether a circle is drawn with its centre: a larger one is an arc near the point."""
    return radius <= _WHOLE * size


def _circle(geometry, size, pattern):
    radius = radius_of(geometry)
    if radius is None or not size:
        return
    half = math.pi if is_whole(radius, size) else math.pi * _WHOLE * size / radius
    angles = numpy.linspace(-half, half, _CIRCLE_STEPS + 1)[:, None]
    # 2 sin²(φ/2) is 1 − cos φ without cancellation in large circles
    points = (geometry.point + radius * numpy.sin(angles) * geometry.tangent
              + 2.0 * radius * numpy.sin(0.5 * angles) ** 2 * geometry.normal)
    yield nodes.colored_polyline(points, colors.CIRCLE, 2.0, pattern)
    if is_whole(radius, size):
        centre = geometry.point + radius * geometry.normal
        yield nodes.colored_polyline([geometry.point, centre], colors.CIRCLE, 1.2, nodes.DASHED)
        yield nodes.at(centre, sprites.symbol("cross", colors.CIRCLE, pattern == nodes.SOLID))


def _plane(geometry, axes, color, size, name, text_points):
    """A translucent square around the point."""
    along, across = (getattr(geometry, axis) for axis in axes)
    if along is None or across is None:
        return
    half = _PLANE * size
    corners = [geometry.point + half * (a * along + b * across)
               for a, b in ((1, 1), (-1, 1), (-1, -1), (1, -1))]
    coordinates, face = coin.SoCoordinate3(), coin.SoFaceSet()
    coordinates.point.setValues(0, 4, [tuple(map(float, corner)) for corner in corners])
    face.numVertices.setValue(4)
    yield nodes.separator(*nodes.flat_color(nodes.rgb(color), _TRANSPARENCY), coordinates, face)
    yield nodes.colored_polyline([*corners, corners[0]], color, 1.4)
    yield nodes.at(corners[0], sprites.note(name, text_points, color))
