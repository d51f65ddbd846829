"""HTML and SVG as a tree, so that every text is escaped where the tree is written."""

import re
from xml.etree import ElementTree

#: What XML and HTML do not allow as a character.
_CONTROL = re.compile("[\0-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\ufffe\uffff]")


def tag(name, /, *children, **attributes):
    """An element. Children are elements, texts, and None, which is left out; attributes are written
    with "_" for "-" and a trailing "_" for a name that Python reserves; None leaves them out.
    """
    element = ElementTree.Element(name)
    for key, value in attributes.items():
        if value is not None:
            element.set(key.rstrip("_").replace("_", "-"), clean(value))
    for child in children:
        _append(element, child)
    return element


def clean(text):
    """A text without what cannot be written: parts of a name that is no UTF-8, control characters.
    """
    text = str(text).encode("utf-8", "surrogateescape").decode("utf-8", "replace")
    return _CONTROL.sub("\ufffd", text)


def page_text(root):
    """The text of a page."""
    text = ElementTree.tostring(root, encoding="unicode", method="html")
    return f"<!DOCTYPE html>\n{text}\n"


def _append(element, child):
    if child is None:
        return
    if ElementTree.iselement(child):
        element.append(child)
    elif len(element):
        element[-1].tail = (element[-1].tail or "") + clean(child)
    else:
        element.text = (element.text or "") + clean(child)
