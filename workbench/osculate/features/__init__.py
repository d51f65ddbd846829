"""Document objects of Osculate: properties and recomputation, usable without FreeCAD's GUI."""

from osculate.features.blend_curve import make_blend_curve
from osculate.features.join_check import make_join_check

__all__ = ["make_blend_curve", "make_join_check"]
