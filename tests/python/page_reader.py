"""Reads a page of an audit as a browser would, strictly."""
import base64
import re
from html.parser import HTMLParser
from xml.etree import ElementTree

VOID = {"meta", "img", "br", "hr", "link", "input"}


class Page(HTMLParser):
    """The elements of a page as a tree of ElementTree; fails where one is not closed."""

    def __init__(self, text):
        super().__init__()
        self.text = text
        self._open = [ElementTree.Element("document")]
        self.feed(text)
        self.close()
        assert len(self._open) == 1, f"never closed: {[item.tag for item in self._open[1:]]}"
        self.root = self._open[0][0]

    def handle_starttag(self, tag, attrs):
        names = [name for name, _ in attrs]
        assert len(names) == len(set(names)), f"{tag} has an attribute twice: {names}"
        item = ElementTree.SubElement(self._open[-1], tag,
                                      {name: value or "" for name, value in attrs})
        if tag not in VOID:
            self._open.append(item)

    def handle_endtag(self, tag):
        assert self._open.pop().tag == tag, f"</{tag}> closes something else"

    def handle_data(self, data):
        item = self._open[-1]
        if len(item):
            item[-1].tail = (item[-1].tail or "") + data
        else:
            item.text = (item.text or "") + data

    def all(self, tag, class_=None):
        return [item for item in self.root.iter(tag)
                if class_ is None or class_ in item.get("class", "").split()]

    def table(self, class_):
        """The texts of the cells of the rows of a table, without those of its head."""
        table, = self.all("table", class_)
        return [[text_of(cell) for cell in row.iter("td")] for row in table.iter("tr")
                if row.find("td") is not None]

    def references(self):
        """What a browser would fetch or open."""
        found = [value for item in self.root.iter() for name, value in item.attrib.items()
                 if name in {"src", "href", "xlink:href", "srcset", "data", "action"}]
        return found + re.findall(r"url\(([^)]*)\)|@import\s+(\S+)", self.text)

    def embedded(self):
        """(kind, bytes) of the pictures that stand in the page as data."""
        sources = [image.get("src") for image in self.all("img")]
        return [(head, base64.b64decode(data, validate=True))
                for head, data in (source.split(",", 1) for source in sources)]


def text_of(item):
    return " ".join(" ".join(item.itertext()).split())


def coordinates(path):
    """(n, 2) absolute places that an SVG path of M, l and h passes."""
    places, here = [], None
    for command, numbers in re.findall(r"([Mlh])([^Mlh]*)", path):
        values = [int(number) for number in numbers.split()]
        if command == "h":
            assert values == [0]
            continue
        for x, y in zip(values[::2], values[1::2]):
            here = (x, y) if command == "M" else (here[0] + x, here[1] + y)
            places.append(here)
    return places
