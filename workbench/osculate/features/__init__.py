"""Document objects of Osculate: properties and recomputation, usable without FreeCAD's GUI."""

from osculate.features.audit import make_audit
from osculate.features.bezier_solid import make_bezier_solid
from osculate.features.blend_curve import make_blend_curve
from osculate.features.control_polygons import make_control_polygons
from osculate.features.curvature_comb import make_curvature_comb
from osculate.features.extended_curve import make_extended_curve
from osculate.features.interpolated_curve import make_interpolated_curve
from osculate.features.join_check import make_join_check
from osculate.features.joined_curve import make_joined_curve
from osculate.features.matched_curve import make_matched_curve
from osculate.features.probe import make_probe
from osculate.features.solid_brep import make_solid_brep
from osculate.features.solid_contact import make_solid_contact

__all__ = ["make_audit", "make_bezier_solid", "make_blend_curve", "make_control_polygons",
           "make_curvature_comb", "make_extended_curve", "make_interpolated_curve",
           "make_join_check", "make_joined_curve", "make_matched_curve", "make_probe",
           "make_solid_brep", "make_solid_contact"]
