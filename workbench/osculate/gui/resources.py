"""Where the add-on's icons, forms and translations lie."""

import os

import FreeCADGui

ROOT = os.path.normpath(os.path.join(os.path.dirname(__file__), "..", "..", ".."))
RESOURCES = os.path.join(ROOT, "resources")
ICONS = os.path.join(RESOURCES, "icons")
TRANSLATIONS = os.path.join(RESOURCES, "translations")


def icon_path(name):
    """The SVG file of an icon, by its name without ending."""
    return os.path.join(ICONS, name + ".svg")


def icon(name):
    """The icon, drawn by FreeCAD: Qt's own reading of SVG is a plugin that may be missing."""
    return FreeCADGui.getIcon(icon_path(name))


def form_path(name):
    """The .ui file of a form, by its name without ending."""
    return os.path.join(RESOURCES, "ui", name + ".ui")
