"""The handles of a blend: β1 and β2 at each end."""

from osculate.features.blend_curve import SIDES
from osculate.gui.construct import beta_handles

freed = beta_handles.freed


def handles_of(obj, result, colors):
    """The Handles of a BlendCurve and its construction."""
    return [handle for index, (side, color) in enumerate(zip(SIDES, colors))
            for handle in beta_handles.handles_at(obj, result, index, side, color)]


def dragged(result, key, distance):
    """The properties of a BlendCurve when a handle is at a distance in mm from its end."""
    return beta_handles.dragged(result, SIDES.index(key[0]), key, distance)
