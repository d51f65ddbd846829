"""All that is drawn of a Bézier solid; what is not shown costs nothing."""

import numpy
from pivy import coin

from osculate.gui.overlays.legend import Legend
from osculate.gui.solid import meshes
from osculate.gui.solid.legend_picture import Scale, legend_picture
from osculate.gui.solid.look import WIREFRAME
from osculate.gui.solid.net_node import NetNode
from osculate.gui.solid.slices_node import SlicesNode
from osculate.gui.solid.surface_node import LinesNode, SurfaceNode, behind_lines

_ORDER = ("edges", "lines", "slices", "faces", "net", "legend")  # in the scene
_PARAMETER_LINE = 0.5  # of the width of an edge
_ROUGHER = 4.0         # bound of the mesh while a point is dragged
_INSIDE = 10           # divisions of the lattice on which Jacobians inside are sampled


class SolidNode:
    """Draws a solid in E3 as a Look says; `node` goes into the scene and stays there."""

    def __init__(self, document_name, object_name):
        self.node = coin.SoSeparator()
        self._names = document_name, object_name
        self._parts = {}

    def show(self, solid, look, is_dragged=False):
        """Draws a solid; roughly while a point is dragged."""
        needs_mesh = look.has_faces or look.has_edges
        bound = meshes.bound_for(solid, look.deviation) * (_ROUGHER if is_dragged else 1.0)
        faces = meshes.faces_of(solid, bound, look.by_jacobian) if needs_mesh else None
        scale = Scale(look.title, *_range(solid, faces)) if look.by_jacobian else None
        largest = scale.size if scale else None
        self._show_edges(solid, look, faces)
        self._show_slices(solid, look, largest)
        self._show_faces(look, faces, largest)
        self._show_net(solid, look)
        if self._needs("legend", look.legend, lambda: Legend(*self._names, legend_picture)):
            self._parts["legend"].show(scale, look.text_points)

    def _show_edges(self, solid, look, faces):
        if self._needs("edges", look.has_edges, LinesNode):
            edges = self._parts["edges"]
            edges.show(meshes.edges_of(solid, faces.divisions) if faces.divisions else [])
            edges.paint(look.line_color, look.line_width)
        if self._needs("lines", look.mode == WIREFRAME, LinesNode):
            lines = self._parts["lines"]
            lines.show(meshes.parameter_lines(solid, faces.divisions) if faces.divisions else [])
            lines.paint(look.line_color, max(_PARAMETER_LINE * look.line_width, 1.0))

    def _show_slices(self, solid, look, largest):
        if self._needs("slices", look.slices > 0, SlicesNode):
            self._parts["slices"].show(solid, look.direction, look.slices, look.color, largest)

    def _show_faces(self, look, faces, largest):
        if not self._needs("faces", look.has_faces, lambda: SurfaceNode(behind_lines())):
            return
        surface = self._parts["faces"]
        surface.show(faces.surfaces)
        if look.by_jacobian:
            surface.paint_jacobians(largest, look.transparency)
        else:
            surface.paint(look.color, look.transparency)

    def _show_net(self, solid, look):
        if self._needs("net", look.net, NetNode):
            net = self._parts["net"]
            net.show(solid, indices=look.indices, weights=look.weights,
                     text_points=look.text_points)
            net.paint(look.net_color, look.point_size, look.is_edited)

    def _needs(self, name, is_wanted, make):
        """Whether a part is wanted; puts it into the scene or takes it out."""
        if is_wanted and name not in self._parts:
            self._parts[name] = make()
            before = sum(other in self._parts for other in _ORDER[:_ORDER.index(name)])
            self.node.insertChild(self._parts[name].node, before)
        elif not is_wanted and name in self._parts:
            part = self._parts.pop(name)
            self.node.removeChild(part.node)
            if isinstance(part, Legend):
                part.remove()
        return is_wanted


def _range(solid, faces):
    """(least, largest) Jacobian on the faces and on a lattice inside."""
    values = [solid.jacobian(meshes.solid_lattice(_INSIDE))]
    if faces is not None:
        values.extend(face.values for face in faces.surfaces)
    values = numpy.concatenate(values)
    values = values[numpy.isfinite(values)]
    return (float(values.min()), float(values.max())) if len(values) else (0.0, 0.0)
