"""The interior of a Bézier solid in the 3D view: semi-transparent slices with their rims."""

from pivy import coin

from osculate.gui.overlays import nodes
from osculate.gui.solid import meshes
from osculate.gui.solid.surface_node import LinesNode, SurfaceNode
from osculate.gui.solid.view_properties import AXES, CORNERS

_TRANSPARENCY, _RIM_WIDTH = 0.35, 1.5
_DIVISIONS = 32
_DARKER = 0.55  # of the rim


class SlicesNode:
    """Draws slices; `node` goes into the scene. Each is a node of its own, which Coin sorts."""

    def __init__(self):
        self.node = coin.SoSeparator()

    def show(self, solid, direction, count, color, largest):
        """Draws `count` slices. largest: magnitude of the Jacobian by which they are coloured,
        None for slices in one colour.
        """
        self.node.removeAllChildren()
        for share in (step / (count + 1) for step in range(1, count + 1)):
            self._add(slice_of(solid, direction, share, largest is not None), color, largest)

    def _add(self, piece, color, largest):
        if not len(piece.triangles):
            return
        surface, rim = SurfaceNode(), LinesNode()
        surface.show([piece])
        if largest is None:
            surface.paint(color, _TRANSPARENCY)
        else:
            surface.paint_jacobians(largest, _TRANSPARENCY)
        rim.show_legs(piece.points, meshes.rim_of(piece.triangles))
        rim.paint([_DARKER * channel for channel in color[:3]], _RIM_WIDTH)
        self.node.addChild(nodes.separator(rim.node, surface.node))


def slice_of(solid, direction, share, with_jacobian=False):
    """The slice at a share, 0 to 1, of the range of what is constant on it."""
    if direction in CORNERS:
        return meshes.corner_slice(solid, CORNERS.index(direction), share, _DIVISIONS,
                                   with_jacobian)
    axis = AXES.index(direction)
    low, high = meshes.extent(solid, axis)
    return meshes.plane_slice(solid, axis, low + share * (high - low), _DIVISIONS, with_jacobian)
