"""Document objects of Osculate: properties and recomputation, usable without FreeCAD's GUI."""

from osculate.features.join_check import make_join_check

__all__ = ["make_join_check"]
