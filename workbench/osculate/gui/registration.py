"""What FreeCAD learns of Osculate when it starts."""

from osculate.gui import resources
from osculate.gui.preferences_page import PreferencesPage
from osculate.gui.workbench import OsculateWorkbench


def register(gui):
    """Adds workbench, preferences page, icons and translations to FreeCADGui."""
    gui.addLanguagePath(resources.TRANSLATIONS)
    gui.updateLocale()
    gui.addIconPath(resources.ICONS)
    gui.addPreferencePage(PreferencesPage, "Osculate")
    gui.addWorkbench(OsculateWorkbench())
