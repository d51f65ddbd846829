"""Where a label goes: the corner around its point that is freest on the screen."""

import math

from pivy import coin

#: (right, up) of the corners, the preferred first.
CORNERS = ((1, 1), (-1, 1), (1, -1), (-1, -1))

#: Direction in which a label lies from its point, degrees above the horizontal: labels are broad.
_SLOPE = 40.0

#: A direction of which less is seen on the screen (it points at the viewer) is not avoided.
_SEEN = 0.25


def in_freest_corner(labels, avoided):
    """One of four labels, made for CORNERS: at each drawing that which is farthest from the
    `avoided` directions, 3-vectors from the point, as the camera sees them.
    """
    avoided = [_unit(direction) for direction in avoided if any(direction)]

    def choose(_data, action):
        if action.isOfType(coin.SoGLRenderAction.getClassTypeId()):
            state = action.getState()
            corner = _freest(_angles_on_screen(avoided, coin.SoViewingMatrixElement.get(state)))
            coin.SoSwitchElement.set(state, switch, corner)

    chooser = coin.SoCallback()
    chooser.setCallback(choose)
    switch = coin.SoSwitch()
    switch.whichChild = coin.SO_SWITCH_INHERIT
    for label in labels:
        switch.addChild(label)
    node = coin.SoSeparator()
    node.renderCaching = coin.SoSeparator.OFF
    node.addChild(chooser)
    node.addChild(switch)
    return node


def _unit(direction):
    vector = coin.SbVec3f(*map(float, direction))
    vector.normalize()
    return vector


def _angles_on_screen(directions, viewing):
    """Angles in degrees, from the right counter-clockwise, of the directions that are seen."""
    for direction in directions:
        x, y, _ = viewing.multDirMatrix(direction).getValue()
        if math.hypot(x, y) > _SEEN:
            yield math.degrees(math.atan2(y, x))


def _freest(angles):
    """Index of the corner whose label is farthest from all angles; the first of equals."""
    angles = list(angles)
    clearances = [min((_apart(_label_angle(corner), angle) for angle in angles), default=180.0)
                  for corner in CORNERS]
    return clearances.index(max(clearances))


def _label_angle(corner):
    right, up = corner
    slope = math.radians(_SLOPE)
    return math.degrees(math.atan2(up * math.sin(slope), right * math.cos(slope)))


def _apart(first, second):
    return abs((first - second + 180.0) % 360.0 - 180.0)
