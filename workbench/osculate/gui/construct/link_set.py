"""Any number of links that a construction starts from; each click adds one or takes it out."""


class LinkSet:
    """The links in their order; `awaited` is 0 while the selection adds and removes, else None."""

    def __init__(self, least):
        self.links = []
        self.awaited = 0
        self._least = least  # how many make a construction

    @property
    def is_complete(self):
        return len(self.links) >= self._least

    def show_links(self, links):
        """Takes links that are known already."""
        self.links = [link for link in links if link is not None]
        self.awaited = None if self.is_complete else 0

    def await_edge(self, index):
        """Lets the next clicks add and remove (0), or count for nothing (None)."""
        self.awaited = 0 if index is not None or not self.is_complete else None

    def take(self, selected):
        """Takes the selected links; True if there was one. One that is there already goes, several
        at once are added.
        """
        if not selected or self.awaited is None:
            return False
        if len(selected) == 1 and selected[0] in self.links:
            self.links = [link for link in self.links if link != selected[0]]
        else:
            self.links = list(dict.fromkeys((*self.links, *selected)))
        if len(selected) > 1 and self.is_complete:
            self.awaited = None  # a whole chain at once
        return True

    def remove(self, indices):
        """Takes links out by their numbers from 0."""
        self.links = [link for index, link in enumerate(self.links) if index not in indices]

    def move(self, index, step):
        """Moves one link up (-1) or down (1)."""
        target = index + step
        if 0 <= index < len(self.links) and 0 <= target < len(self.links):
            self.links.insert(target, self.links.pop(index))
