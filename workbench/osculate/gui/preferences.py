"""The user's preferences of Osculate, under BaseApp/Preferences/Mod/Osculate."""

from dataclasses import dataclass
from typing import Tuple

import FreeCAD

from osculate.gui import colors

PATH = "User parameter:BaseApp/Preferences/Mod/Osculate"


@dataclass(frozen=True)
class Preferences:
    """Defaults of the analysis and looks of the overlay."""

    preset: str = "osculate"
    order: int = 4
    follow_selection: bool = True
    show_frames: bool = True
    show_polygons: bool = True
    frame_pixels: int = 70
    label_points: int = 11
    side_colors: Tuple[str, str] = colors.SIDES


_DEFAULTS = Preferences()


def parameters():
    return FreeCAD.ParamGet(PATH)


def load():
    """The Preferences as the user set them."""
    group = parameters()
    return Preferences(
        preset=group.GetString("Preset", _DEFAULTS.preset),
        order=group.GetInt("Order", _DEFAULTS.order),
        follow_selection=group.GetBool("FollowSelection", _DEFAULTS.follow_selection),
        show_frames=group.GetBool("ShowFrames", _DEFAULTS.show_frames),
        show_polygons=group.GetBool("ShowPolygons", _DEFAULTS.show_polygons),
        frame_pixels=group.GetInt("FramePixels", _DEFAULTS.frame_pixels),
        label_points=group.GetInt("LabelPoints", _DEFAULTS.label_points),
        side_colors=(group.GetString("FirstColor", _DEFAULTS.side_colors[0]),
                     group.GetString("SecondColor", _DEFAULTS.side_colors[1])),
    )


def save(preferences):
    """Keeps Preferences."""
    group = parameters()
    group.SetString("Preset", preferences.preset)
    group.SetInt("Order", preferences.order)
    group.SetBool("FollowSelection", preferences.follow_selection)
    group.SetBool("ShowFrames", preferences.show_frames)
    group.SetBool("ShowPolygons", preferences.show_polygons)
    group.SetInt("FramePixels", preferences.frame_pixels)
    group.SetInt("LabelPoints", preferences.label_points)
    group.SetString("FirstColor", preferences.side_colors[0])
    group.SetString("SecondColor", preferences.side_colors[1])
