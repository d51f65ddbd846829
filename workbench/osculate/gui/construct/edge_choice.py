"""Which edges a construction starts from, and which of them the next click in the view gives."""


class EdgeChoice:
    """A fixed number of edges; `awaited` is the index of that which the selection gives next, or
    None while the selection counts for nothing.
    """

    def __init__(self, count):
        self.links = [None] * count
        self.awaited = 0

    @property
    def is_complete(self):
        return None not in self.links

    def show_links(self, links):
        """Takes links that are known already."""
        self.links = list(links)
        self._await_next()

    def await_edge(self, index):
        """Makes the next click give edge `index`; None: no edge."""
        self.awaited = index
        if index is None and not self.is_complete:
            self._await_next()

    def take(self, selected):
        """Takes the selected links; True if an edge was chosen."""
        if not selected or self.awaited is None:
            return False
        if not any(self.links):
            count = min(len(selected), len(self.links))
            self.links[:count] = selected[:count]
        else:
            self.links[self.awaited] = selected[-1]
        self._await_next()
        return True

    def _await_next(self):
        self.awaited = None if self.is_complete else self.links.index(None)
