"""Properties of document objects from tables: groups of (name, type, meaning)."""

SHOWN, READ_ONLY, HIDDEN = 0, 1, 2  #: modes of setEditorMode

#: A link to an edge, into any App::Part. Not PropertyXLinkSub: FreeCAD 1.0 crashes where its
#: creation is undone.
LINK = "App::PropertyLinkSubGlobal"


#: Attribute of a property that only changes how an object looks: it is not recomputed.
LOOK = 8


def add_properties(obj, groups, starts):
    """Adds what the object does not have yet.

    groups: (name of the group, rows) pairs; a row is (name, type, meaning), or has the attributes
            of addProperty as well, e.g. LOOK.
    starts: what a property begins with; for an enumeration the list of its choices, for a
            constraint (value, least, most, step).
    """
    for group, rows in groups:
        for name, kind, meaning, *attributes in rows:
            if not hasattr(obj, name):
                obj.addProperty(kind, name, group, meaning, *attributes)
                if name in starts:
                    setattr(obj, name, starts[name])


def names_in(groups):
    """The names of all properties of some groups."""
    return [name for _, rows in groups for name, *_ in rows]


def set_if_changed(obj, name, value):
    """Sets a property unless it has the value: every setting touches the object."""
    if getattr(obj, name) != value:
        setattr(obj, name, value)
