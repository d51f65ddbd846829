"""A handle in the 3D view: a knob that is dragged along a line."""

import functools
import math
from dataclasses import dataclass
from typing import Tuple

from pivy import coin

from osculate.gui.overlays import nodes, sprites
from osculate.gui.overlays.pixel_scale import beside

#: Pixels beside its line at which a handle is drawn that would cover another one.
BESIDE = 26.0
_REACH = 15.0  # pixels around a knob in which the mouse takes it


@dataclass(frozen=True)
class Handle:
    """A knob at `distance` mm from `origin` in `direction` (a unit vector)."""

    key: Tuple            #: what it stands for
    origin: Tuple[float, float, float]
    direction: Tuple[float, float, float]
    distance: float
    foot: float           #: the distance at which its stem begins
    text: str             #: in the knob, one or two characters
    caption: str          #: shown while the mouse is at it
    color: str            #: "#rrggbb"
    is_fixed: bool        #: filled; a hollow one is chosen by the computer
    is_beside: bool = False  #: drawn beside its line

    @property
    def aside(self):
        """Pixels beside its line."""
        return BESIDE if self.is_beside else 0.0

    @property
    def tip(self):
        """The place of the knob, if it is not beside."""
        return self.at(self.distance)

    def at(self, distance):
        """The point of the line at a distance."""
        return tuple(o + distance * d for o, d in zip(self.origin, self.direction))

    def pixels_from(self, screen, pixel, density):
        """How far the knob is from a pixel of a Screen, in pixels; `density`: device pixels each.

        None if it is out of the mouse's reach.
        """
        seen = screen.beside(self.tip, self.direction, self.aside * density)
        x, y = screen.pixel_of(seen)
        distance = math.hypot(x - pixel[0], y - pixel[1]) / density
        return distance if distance <= _REACH else None


class HandleNode:
    """What is drawn of a handle; `node` goes into the scene and stays there while it is dragged."""

    def __init__(self, handle, text_points):
        self._text_points = text_points
        self._handle = handle
        self._stem = nodes.Polyline([handle.at(handle.foot), handle.tip], handle.color, 2.0)
        self._foot_place, self._tip_place = coin.SoTranslation(), coin.SoTranslation()
        self._knob = nodes.separator(self._tip_place)
        parts = [self._stem.node, self._knob]
        if handle.is_beside:
            parts.insert(1, nodes.separator(self._foot_place, _foot(handle.color)))
            parts = [beside(lambda: (self._handle.tip, self._handle.direction), handle.aside,
                            *parts)]
        self.node = nodes.without_extent(*parts)

    def show(self, handle, is_hot):
        """Shows another state of the handle; the mouse is at a hot one."""
        self._handle = handle
        foot, tip = handle.at(handle.foot), handle.tip
        self._stem.move([foot, tip])
        self._foot_place.translation, self._tip_place.translation = foot, tip
        self._knob.removeAllChildren()
        self._knob.addChild(self._tip_place)
        self._knob.addChild(_knob(handle.text, handle.color, handle.is_fixed, is_hot,
                                  not handle.is_beside))
        if is_hot:
            self._knob.addChild(sprites.caption(handle.caption, handle.color, self._text_points))


@functools.lru_cache(maxsize=None)
def _knob(*look):
    return _kept(sprites.knob(*look))


@functools.lru_cache(maxsize=None)
def _foot(color):
    return _kept(sprites.dot(color))


def _kept(node):
    """A node that lives on when no scene has it: Python's reference alone is none for Coin."""
    node.ref()
    return node
