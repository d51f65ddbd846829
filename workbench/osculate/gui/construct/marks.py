"""What a construction marks in the 3D view: the edges it starts from, the joins it makes."""

import numpy

from osculate.features.edge_link import LinkError
from osculate.gui import colors
from osculate.gui.overlays import nodes, sprites
from osculate.gui.overlays.join_overlay import label_node
from osculate.gui.verdict import look_of

_DEFLECTION = 2e-4  # of the lines that mark edges, as a share of the edge's length
_MOST_POINTS = 400
_SPAN_POINTS = 64
_TAG_PLACE = 0.4    # of the number, as a share of the points from the start


def edge_marks(links, side_colors):
    """Nodes of lines over EdgeLinks (None: none yet) in alternating colours, with numbers."""
    marks = []
    for index, link in enumerate(links):
        points = _points(link) if link else ()
        if points:
            color = side_colors[index % len(side_colors)]
            marks.append(nodes.colored_polyline(points, color, 3.0))
            marks.append(nodes.at(points[round(_TAG_PLACE * (len(points) - 1))],
                                  sprites.tag(str(index + 1), color)))
    return marks


def point_marks(points, color):
    """Numbered tags at points."""
    return [nodes.at(point, sprites.tag(str(number), color))
            for number, point in enumerate(points, start=1)]


def _points(link):
    try:
        edge = link.resolve()
        points = edge.discretize(QuasiDeflection=max(_DEFLECTION * edge.Length, 1e-6))
    except (LinkError, RuntimeError, ValueError, TypeError):
        return ()  # the panel says what is wrong with it
    if len(points) > _MOST_POINTS:
        points = edge.discretize(Number=_MOST_POINTS)
    return points


class CurveMark:
    """A line over the curve that is made; `node` stays in the scene while the curve changes."""

    def __init__(self):
        self._line = nodes.Polyline((), colors.MADE, 3.0)
        self.node = self._line.node

    def show(self, curve):
        """Follows a Curve; None: there is none."""
        if curve is None:
            self._line.move(())
            return
        count = min(_SPAN_POINTS * (len(curve.knots) - 1) + 1, _MOST_POINTS)
        self._line.move(curve.evaluate(numpy.linspace(*curve.parameter_range, count))[:, 0])


def join_marks(reports, preferences):
    """A ring at each join in the colour of its order; a label where it misses the order asked."""
    marks = []
    for report in reports:
        point, verdict = report.sides[0].point, (report.order, report.verdicts, report.residuals)
        if report.order >= report.requested_order:
            marks.append(nodes.at(point, sprites.ring(look_of(*verdict[:2]).color)))
        else:
            marks.append(label_node(point, verdict, preferences,
                                    [_surroundings(side) for side in report.sides]))
    return marks


def _surroundings(side):
    return side.tangent, side.normal, side.segment.poles if side.segment else ()


def state_of(reports):
    """What of some reports decides how they are marked."""
    return [(tuple(report.sides[0].point), report.order, report.requested_order)
            for report in reports]
