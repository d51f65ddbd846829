"""What FreeCAD learns of Osculate when it starts."""

from functools import partial
from importlib import import_module

from osculate.features import long_work, views
from osculate.features.audit import Audit
from osculate.features.bezier_solid import BezierSolid
from osculate.features.blend_curve import BlendCurve
from osculate.features.control_polygons import ControlPolygons
from osculate.features.curvature_comb import CurvatureComb
from osculate.features.extended_curve import ExtendedCurve
from osculate.features.interpolated_curve import InterpolatedCurve
from osculate.features.join_check import JoinCheck
from osculate.features.joined_curve import JoinedCurve
from osculate.features.matched_curve import MatchedCurve
from osculate.features.probe import Probe
from osculate.features.solid_brep import SolidBRep
from osculate.features.solid_contact import SolidContact
from osculate.gui import resources
from osculate.gui.long_work import LongWork
from osculate.gui.preferences_page import PreferencesPage
from osculate.gui.workbench import OsculateWorkbench


def register(gui):
    """Adds workbench, preferences page, icons, translations and views to FreeCADGui."""
    gui.addLanguagePath(resources.TRANSLATIONS)
    gui.updateLocale()
    gui.addIconPath(resources.ICONS)
    gui.addPreferencePage(PreferencesPage, "Osculate")
    gui.addWorkbench(OsculateWorkbench())
    for kind, view in _VIEWS.items():
        views.register(kind, partial(_give, view))
    long_work.register(LongWork)


#: Proxy class of a document object -> module and class of its view, loaded when it is used.
_VIEWS = {
    JoinCheck: ("osculate.gui.join_check_view", "JoinCheckView"),
    Audit: ("osculate.gui.audit_view", "AuditView"),
    BlendCurve: ("osculate.gui.construct.blend_view", "BlendCurveView"),
    ControlPolygons: ("osculate.gui.polygons_view", "ControlPolygonsView"),
    Probe: ("osculate.gui.probe_view", "ProbeView"),
    CurvatureComb: ("osculate.gui.comb_view", "CurvatureCombView"),
    ExtendedCurve: ("osculate.gui.construct.extend_view", "ExtendedCurveView"),
    MatchedCurve: ("osculate.gui.construct.match_view", "MatchedCurveView"),
    JoinedCurve: ("osculate.gui.construct.joined_view", "JoinedCurveView"),
    InterpolatedCurve: ("osculate.gui.construct.interpolated_view", "InterpolatedCurveView"),
    BezierSolid: ("osculate.gui.solid.solid_view", "SolidView"),
    SolidContact: ("osculate.gui.solid.contact_view", "ContactView"),
    SolidBRep: ("osculate.gui.solid_panel.brep_view", "SolidBRepView"),
}


def _give(view, view_object):
    module, name = view
    kind = getattr(import_module(module), name)
    if not isinstance(view_object.Proxy, kind):
        kind(view_object)
