"""What of a Bézier solid is drawn, and how."""

from dataclasses import dataclass
from typing import Tuple

SHADED_WITH_EDGES, SHADED, WIREFRAME, NET_ONLY = MODES = (
    "Shaded with edges", "Shaded", "Wireframe", "Net only")

_FACES_OVER_SLICES = 0.85  # the least transparency of faces, where slices are to be seen behind


@dataclass(frozen=True)
class Look:
    """The view properties that matter for a display mode."""

    mode: str
    color: Tuple[float, float, float]
    transparency: float        #: 0 to 1, of the faces
    line_color: Tuple[float, float, float]
    line_width: float
    deviation: float           #: mm, 0 for one by the solid's size
    by_jacobian: bool
    legend: bool
    net: bool
    indices: bool
    weights: bool
    net_color: Tuple[float, float, float]
    point_size: float
    slices: int                #: 0 for none
    direction: str             #: of the slices, of view_properties
    is_edited: bool            #: points in front of everything
    text_points: int
    title: str                 #: of the legend

    @property
    def has_faces(self):
        return self.mode in (SHADED, SHADED_WITH_EDGES)

    @property
    def has_edges(self):
        return self.mode in (SHADED_WITH_EDGES, WIREFRAME)


def look_of(vobj, mode, is_edited, text_points):
    """The Look of a view object whose view_properties are complete."""
    has_slices = vobj.ShowSlices and mode != NET_ONLY
    by_jacobian = vobj.ColorByJacobian and (has_slices or mode in (SHADED, SHADED_WITH_EDGES))
    transparency = vobj.Transparency / 100.0
    return Look(
        mode=mode, color=vobj.ShapeColor[:3],
        transparency=max(transparency, _FACES_OVER_SLICES) if has_slices else transparency,
        line_color=vobj.LineColor[:3], line_width=vobj.LineWidth, deviation=vobj.Deviation.Value,
        by_jacobian=by_jacobian, legend=by_jacobian and vobj.Visibility,
        net=vobj.ShowNet or is_edited or mode == NET_ONLY,
        indices=vobj.ShowIndices, weights=vobj.ShowWeights,
        net_color=vobj.NetColor[:3], point_size=vobj.PointSize,
        slices=vobj.Slices if has_slices else 0, direction=vobj.SliceDirection,
        is_edited=is_edited, text_points=text_points, title=vobj.Object.Label)
