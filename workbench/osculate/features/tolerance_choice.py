"""Tolerances as a document or a panel holds them: the name of a preset, or five own values."""

from dataclasses import astuple, dataclass

from osculate import Tolerances

#: Names of the presets, in the order in which they are offered.
PRESETS = tuple(preset.name for preset in Tolerances.presets())
CUSTOM = "custom"

_FIELDS = ("gap_mm", "angle_deg", "curvature", "third", "fourth")


@dataclass(frozen=True)
class ToleranceValues:
    """The tolerances of the orders 0 to 4: mm, degrees, then dimensionless."""

    gap_mm: float
    angle_deg: float
    curvature: float
    third: float
    fourth: float


def values_of(preset):
    """The ToleranceValues of a preset. Raises ValueError for an unknown name."""
    tolerances = Tolerances.preset(preset)
    return ToleranceValues(*(getattr(tolerances, field) for field in _FIELDS))


def tolerances_of(preset, values=None):
    """Tolerances from a preset's name, or from `values` if that is CUSTOM.

    Raises ValueError for an unknown preset and for values that are not finite and positive.
    """
    if preset == CUSTOM:
        return Tolerances(**dict(zip(_FIELDS, astuple(values))))
    return Tolerances.preset(preset)
