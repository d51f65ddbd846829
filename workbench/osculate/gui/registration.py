"""What FreeCAD learns of Osculate when it starts."""

from osculate.features import views
from osculate.features.join_check import JoinCheck
from osculate.gui import resources
from osculate.gui.preferences_page import PreferencesPage
from osculate.gui.workbench import OsculateWorkbench


def register(gui):
    """Adds workbench, preferences page, icons, translations and views to FreeCADGui."""
    gui.addLanguagePath(resources.TRANSLATIONS)
    gui.updateLocale()
    gui.addIconPath(resources.ICONS)
    gui.addPreferencePage(PreferencesPage, "Osculate")
    gui.addWorkbench(OsculateWorkbench())
    views.register(JoinCheck, _view_join_check)


def _view_join_check(view_object):
    from osculate.gui.join_check_view import JoinCheckView  # Coin is loaded when it is used
    if not isinstance(view_object.Proxy, JoinCheckView):
        JoinCheckView(view_object)
