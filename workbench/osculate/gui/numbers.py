"""Numbers for a person under the name that the GUI knows them by."""

from osculate.number_text import MISSING, coordinate, number, quantity, residual

__all__ = ["MISSING", "coordinate", "number", "quantity", "residual"]
