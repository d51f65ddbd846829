"""What is plotted: edges of a document as they are now, by links that survive edits."""

from osculate import Curve, curve_plot
from osculate.features.edge_link import LinkError, edges_at, edges_of_object, resolve_all
from osculate.features.edge_overlay import are_same_edges
from osculate.features.feature import FAILURES
from osculate.gui.qt import translate

#: More edges would be a carpet, not a plot.
MOST_EDGES = 500


class PlotSource:
    """Follows the edges that some EdgeLinks lead to."""

    plot = None     #: the CurvePlot; None: there is none
    labels = ()     #: what the user calls each of its curves
    problems = ()   #: why something is not plotted, in sentences

    def __init__(self):
        self.links = ()
        self._made_of = None

    @property
    def document(self):
        """The name of the document, or None."""
        return self.links[0].document if self.links else None

    def take(self, links):
        """From now on follows other links: to edges, faces, or whole objects."""
        self.links = tuple(links)

    def clear(self):
        """Follows nothing."""
        self.links, self._made_of = (), None
        self.plot, self.labels, self.problems = None, (), ()

    def look(self, quantities, options):
        """Looks at the edges as they are now; True if the plot is another one.

        options: order and tolerances, as for curve_plot.
        """
        edges, labels, problems = _named_edges(self.links)
        made_of = edges, (labels, problems, tuple(quantities), options)
        if self._made_of is not None and (
                made_of[1] == self._made_of[1] and are_same_edges(edges, self._made_of[0])):
            return False
        self._made_of = made_of
        self._make(edges, labels, problems, quantities, options)
        return True

    def _make(self, edges, labels, problems, quantities, options):
        curves, names, problems = [], [], list(problems)
        for edge, label in zip(edges, labels):
            try:
                curves.append(Curve.from_edge(edge))
                names.append(label)
            except FAILURES as error:
                problems.append(f"{label}: {error}")
        self.plot = None
        if curves:
            try:
                self.plot = curve_plot(curves, quantities=quantities, **dict(options))
            except FAILURES as error:
                problems.append(str(error))
        self.labels, self.problems = tuple(names), tuple(dict.fromkeys(problems))


def _named_edges(links):
    """(edges, labels, problems): each edge once, and what the user calls it."""
    edges, labels, problems, met = [], [], [], {}
    for link in links:
        try:
            for edge, label in _edges_with_names(link):
                alike = met.setdefault(edge.hashCode(), [])
                if not any(edge.isSame(other) for other in alike):
                    alike.append(edge)
                    edges.append(edge)
                    labels.append(label)
        except LinkError as error:
            problems.append(str(error))
    if len(edges) > MOST_EDGES:
        problems.append(translate("Osculate", "Only {} of {} edges are plotted.")
                        .format(MOST_EDGES, len(edges)))
    return edges[:MOST_EDGES], labels[:MOST_EDGES], problems


def _edges_with_names(link):
    """(edge, label) pairs of an edge, a face, or a whole object."""
    path, _, element = link.sub.rpartition(".")
    if element:
        return [(edge, link.label()) for edge in edges_at(link)]
    links = edges_of_object(link.resolve_object(), path + "." if path else "")
    return [(edge, other.label()) for other, edge in resolve_all(links).items()]
