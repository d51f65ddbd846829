"""From what the user selected to links to edges, or to a sentence that says what to select."""

import FreeCADGui
import numpy
import Part

from osculate import shapes
from osculate.features.edge_link import (
    EdgeLink, LinkError, VertexLink, edges_at, edges_of_object, resolve_all)
from osculate.gui.qt import translate

#: How finely an edge is looked at to find the end nearer to a click, and how far off it the click
#: may be, as a share of its length.
_SAMPLES, _NEARNESS = 64, 0.1


def what_to_select():
    return translate("Osculate", "Select two edges that meet (Ctrl adds the second), the vertex "
                                 "between them, or a whole wire or sketch.")


def selected_links():
    """Links to all selected edges, each once, in the order of selection.

    Edges count as they are, a vertex for the edges that meet there, an object for all its edges.
    Raises LinkError for anything else.
    """
    links = {}
    # Resolve mode 0 keeps the path from the outermost App::Part, and with it all placements.
    for selected in FreeCADGui.Selection.getSelectionEx("*", 0):
        for sub in selected.SubElementNames or ("",):
            links.update(dict.fromkeys(_links_of(selected.Object, plain_path(sub))))
    return list(links)


def selected_sources():
    """EdgeLinks to all that is selected as it is: edges, faces, or whole objects (`sub` names no
    element). Raises LinkError for vertices and for what has no edges.
    """
    links = {}
    for selected in FreeCADGui.Selection.getSelectionEx("*", 0):
        for sub in selected.SubElementNames or ("",):
            link = EdgeLink.of(selected.Object, plain_path(sub))
            edges_at(link)
            links[link] = None
    return list(links)


def plain_path(sub):
    """A path without the topological names that FreeCAD from 1.0 on puts before "Edge1"."""
    return ".".join(name for name in sub.split(".") if not name.startswith((";", "?")))


def _links_of(obj, sub):
    path, _, element = sub.rpartition(".")
    path = path + "." if path else ""
    if not element:
        return edges_of_object(obj, path)
    if element.startswith("Edge"):
        return [EdgeLink.of(obj, sub)]
    if element.startswith("Vertex"):
        return _edges_at_vertex(obj, path, sub)
    raise LinkError(translate("Osculate", "{} is no edge.").format(EdgeLink.of(obj, sub).label())
                    + " " + what_to_select())


def _edges_at_vertex(obj, path, sub):
    vertex = Part.getShape(obj, sub, needSubElement=True)
    edges = resolve_all(edges_of_object(obj, path))
    meeting = [link for link, edge in edges.items()
               if any(vertex.isSame(other) or vertex.Point == other.Point
                      for other in edge.Vertexes)]
    if not meeting:
        raise LinkError(translate("Osculate", "No edge ends at {}.")
                        .format(EdgeLink.of(obj, sub).label()))
    return meeting


def selected_vertices():
    """VertexLinks to all selected vertices, each once; an object counts for all its vertices.

    Raises LinkError for anything else.
    """
    links = {}
    for selected in FreeCADGui.Selection.getSelectionEx("*", 0):
        for sub in selected.SubElementNames or ("",):
            links.update(dict.fromkeys(_vertices_of(selected.Object, plain_path(sub))))
    return list(links)


def _vertices_of(obj, sub):
    path, _, element = sub.rpartition(".")
    path = path + "." if path else ""
    if not element:
        count = len(Part.getShape(obj, path).Vertexes)
        return [VertexLink.of(obj, f"{path}Vertex{number}") for number in range(1, count + 1)]
    if element.startswith("Vertex"):
        return [VertexLink.of(obj, sub)]
    raise LinkError(translate("Osculate", "{} is no vertex.")
                    .format(VertexLink.of(obj, sub).label()))


def selected_point():
    """The last selected vertex as a VertexLink, and the last place that was clicked in the 3D view
    as a vector; each None where there is none.
    """
    link = point = None
    for selected in FreeCADGui.Selection.getSelectionEx("*", 0):
        clicked = [place for place in selected.PickedPoints if any(place)]  # zero stands for none
        point = clicked[-1] if clicked else point
        for sub in map(plain_path, selected.SubElementNames):
            if sub.rpartition(".")[2].startswith("Vertex"):
                link = VertexLink.of(selected.Object, sub)
    return link, point


def end_near_click(edge):
    """"start" or "end" of the edge, whichever is nearer along it to where it was clicked or to the
    vertex that was selected; None if nothing on it was clicked.
    """
    link, point = selected_point()
    point = link.resolve().Point if link else point
    if point is None:
        return None
    curve = shapes.curve_from_edge(edge)
    first, last = curve.parameter_range
    samples = curve.evaluate(numpy.linspace(first, last, _SAMPLES + 1))[:, 0]
    distances = numpy.linalg.norm(samples - tuple(point), axis=1)
    if distances.min() > _NEARNESS * edge.Length:
        return None  # the selection came from the tree or from a script
    return "start" if distances.argmin() < _SAMPLES / 2 else "end"
