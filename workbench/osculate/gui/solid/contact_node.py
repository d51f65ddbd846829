"""What is drawn of the contact of two Bézier solids: the shared face and the layers that match."""

import numpy
from pivy import coin

from osculate.features.control_net import indices_of
from osculate.gui import colors, numbers
from osculate.gui.overlays import nodes, sprites
from osculate.gui.overlays.markers import disk
from osculate.gui.overlays.placement import CORNERS, in_freest_corner
from osculate.gui.qt import QtGui, translate
from osculate.gui.solid import meshes
from osculate.gui.solid.net_node import legs_of
from osculate.gui.solid.surface_node import (
    LinesNode, SurfaceNode, fill, rows, through_everything)
from osculate.gui.solid.value import in_space, size_of

_DIVISIONS = 24
_FACE_TRANSPARENCY, _RIM_WIDTH, _LEG_WIDTH, _GAP_WIDTH = 0.55, 3.5, 1.5, 2.0
_POINT_SIZE = 10
_ROUNDING = 1e-13  # share of the size within which a deviation is that of double coordinates


def contact_node(first, second, report, text_points):
    """Everything of the ContactReport of two BezierTetrahedra, over the model."""
    solids = [in_space(solid.elevated(report.degree - solid.degree))
              if solid.degree < report.degree else in_space(solid) for solid in (first, second)]
    color = colors.of_order(report.order)
    shown = list(zip(solids, report.faces))
    parts = [_face(solid, face, color) for solid, face in (shown[:1] if report.meets else shown)]
    if report.meets:
        for solid, face in shown:
            parts.extend(_layers(solid, face, report.order, text_points))
    else:
        parts.append(_gaps(shown, report.corners))
    parts.append(_label(shown, report, color, text_points))
    return nodes.untouchable(through_everything(), *parts)


def layers_of(degree, face, order):
    """[the numbers of the control points of layer 0, of layer 1, …] over a face: the layers that
    the contact of an order rests on, and the next one.
    """
    layers = [[] for _ in range(min(order + 1, degree) + 1)]
    for number, index in enumerate(indices_of(degree)):
        if index[face] < len(layers):
            layers[index[face]].append(number)
    return layers


def color_of_layer(layer, order):
    """The colour of the points of a layer: of its order, grey where it does not match."""
    return colors.of_order(layer) if layer <= order else colors.ERROR


def description(report, size):
    """What the label says beside the order; `size` of the solids in mm."""
    if not report.meets:
        return numbers.quantity(report.gap_mm, "mm", 3)
    residuals, order = report.residuals_mm, report.order
    deviation = max(residuals[:order + 1])
    texts = [translate("Osculate", "deviation {}").format(
        numbers.quantity(deviation, "mm", 3) if deviation > _ROUNDING * size else "≈ 0")]
    if order + 1 < len(residuals):
        texts.append(translate("Osculate", "C{} misses by {}").format(
            order + 1, numbers.quantity(residuals[order + 1], "mm", 3)))
    if report.overlaps:
        texts.append(translate("Osculate", "both on the same side"))
    return " · ".join(texts)


def name_of(report):
    """The order as it is written."""
    return f"C{report.order}" if report.meets else translate("Osculate", "Gap")


def _face(solid, face, color):
    """A face in a colour, with a rim."""
    surface, rim = SurfaceNode(), LinesNode()
    piece = meshes.corner_slice(solid, face, 0.0, _DIVISIONS)
    surface.show([piece])
    surface.paint(nodes.rgb(color), _FACE_TRANSPARENCY)
    rim.show_legs(piece.points, meshes.rim_of(piece.triangles))
    rim.paint(nodes.rgb(color), _RIM_WIDTH)
    return nodes.separator(surface.node, rim.node)


def _layers(solid, face, order, text_points):
    """The points of the layers over a face, the legs between them, the name of each layer."""
    layers = layers_of(solid.degree, face, order)
    for layer, group in reversed(list(enumerate(layers))):
        color = color_of_layer(layer, order)
        below = set(layers[layer - 1]) if layer else ()
        legs = [leg for leg in legs_of(solid.degree)
                if any(end in below for end in leg) and any(end in group for end in leg)]
        lines = LinesNode()
        lines.show_legs(solid.points, legs)
        lines.paint(nodes.rgb(color), _LEG_WIDTH,
                    pattern=nodes.SOLID if layer <= order else nodes.DASHED)
        yield nodes.separator(lines.node, _points(solid.points[group], color))
        if layer:
            tag = sprites.note(f"C{layer}", text_points, color)
            yield nodes.without_extent(nodes.at(_middle(solid.points[group]), tag))


def _points(points, color):
    coordinates, markers = coin.SoCoordinate3(), coin.SoMarkerSet()
    fill(coordinates.point, rows([points]))
    density = QtGui.QGuiApplication.primaryScreen().devicePixelRatio()
    markers.markerIndex = disk(round(_POINT_SIZE * density))
    return nodes.separator(*nodes.flat_color(nodes.rgb(color)), coordinates, markers)


def _gaps(shown, corners):
    """Lines between the corners that are nearest to each other, of faces that do not meet."""
    (first, face), (second, _) = shown
    own = numpy.eye(4)
    places = [(first.evaluate(own[a]), second.evaluate(own[b]))
              for a, b in enumerate(corners) if a != face]
    return nodes.separator(*(nodes.colored_polyline(pair, colors.GAP, _GAP_WIDTH, nodes.DASHED)
                             for pair in places if numpy.isfinite(pair).all()))


def _label(shown, report, color, text_points):
    """The order and how exact it is, at the middle of the face and away from the apexes."""
    third = numpy.full(4, 1.0 / 3.0)
    middles = []
    for solid, face in shown:
        third_of_face = numpy.where(numpy.arange(4) == face, 0.0, third)
        middles.append(solid.evaluate(third_of_face))
    middle = numpy.mean([place for place in middles if numpy.isfinite(place).all()] or [[0.0] * 3],
                        axis=0)
    aways = [solid.points.mean(axis=0) - middle for solid, _ in shown]
    text = description(report, max(size_of(solid) for solid, _ in shown))
    labels = [sprites.callout(name_of(report), text, color, text_points, corner)
              for corner in CORNERS]
    return nodes.at(middle, in_freest_corner(labels, aways))


def _middle(points):
    """The point nearest to the middle of some."""
    return points[numpy.linalg.norm(points - points.mean(axis=0), axis=1).argmin()]
