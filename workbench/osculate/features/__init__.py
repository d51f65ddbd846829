"""Document objects of Osculate: properties and recomputation, usable without FreeCAD's GUI."""

from osculate.features.blend_curve import make_blend_curve
from osculate.features.extended_curve import make_extended_curve
from osculate.features.interpolated_curve import make_interpolated_curve
from osculate.features.join_check import make_join_check
from osculate.features.joined_curve import make_joined_curve
from osculate.features.matched_curve import make_matched_curve

__all__ = ["make_blend_curve", "make_extended_curve", "make_interpolated_curve", "make_join_check",
           "make_joined_curve", "make_matched_curve"]
