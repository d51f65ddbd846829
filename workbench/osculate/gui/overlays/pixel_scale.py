"""Nodes whose unit is a pixel of the screen, whatever the camera.

FreeCAD's own nodes for this (SoShapeScale, SoAutoZoomTranslation) differ between its versions and
measure at the origin of the world; this measures at the node's own place.
"""

from pivy import coin

from osculate.gui.overlays import nodes
from osculate.gui.qt import QtGui

#: Stands for the scaling in Coin's traversal state, which asks which node changed the matrix.
_SCALER = coin.SoScale()


#: Sine of the angle to the line of sight below which a direction has no side on the screen.
_END_ON = 1e-3

#: What remains of the depth of such children; the rest would reach out of the near and far plane,
#: which Coin sets close around the model.
_DEPTH = 1e-3


def in_pixels(point, *children):
    """Children at a point, in a system of their own whose unit is a pixel of the screen.

    They are flattened towards the screen and do not count where a view is fitted.
    """
    scale = coin.SoCallback()
    scale.setCallback(_scale_to_pixels)
    node = nodes.at(point, scale, *children)
    node.renderCaching = coin.SoSeparator.OFF
    return nodes.without_extent(node)


def beside(line, pixels, *children):
    """Children moved sideways, as they are seen on the screen, from a line.

    `line()` says at each drawing a point, where `pixels` are measured, and the direction; to its
    left if they are positive.
    """
    def move(_data, action):
        if action.isOfType(coin.SoGLRenderAction.getClassTypeId()):
            state = action.getState()
            offset = sideways(coin.SoViewVolumeElement.get(state), *line(), pixels,
                              coin.SoViewportRegionElement.get(state).getViewportSizePixels()[1])
            coin.SoModelMatrixElement.translateBy(state, _SCALER, offset)

    mover = coin.SoCallback()
    mover.setCallback(move)
    node = nodes.separator(mover, *children)
    node.renderCaching = coin.SoSeparator.OFF
    return node


def sideways(volume, point, direction, pixels, height):
    """The offset in the world that `beside` makes; zero where the direction points at the viewer.

    volume: the camera's SbViewVolume. height: of the viewport, in pixels of the device.
    """
    across = coin.SbVec3f(*map(float, direction)).cross(volume.getProjectionDirection())
    if across.length() < _END_ON:
        return coin.SbVec3f(0, 0, 0)
    across.normalize()
    return across * (pixels * _pixel_size(volume, coin.SbVec3f(*map(float, point)), height))


def _scale_to_pixels(_data, action):
    if not action.isOfType(coin.SoGLRenderAction.getClassTypeId()):
        return
    state = action.getState()
    point = coin.SoModelMatrixElement.get(state).multVecMatrix(coin.SbVec3f(0, 0, 0))
    volume = coin.SoViewVolumeElement.get(state)
    size = _pixel_size(volume, point,
                       coin.SoViewportRegionElement.get(state).getViewportSizePixels()[1])
    to_view = coin.SbRotation(coin.SbVec3f(0, 0, 1), volume.getProjectionDirection())
    coin.SoModelMatrixElement.rotateBy(state, _SCALER, to_view)
    coin.SoModelMatrixElement.scaleBy(state, _SCALER, coin.SbVec3f(size, size, _DEPTH * size))
    coin.SoModelMatrixElement.rotateBy(state, _SCALER, to_view.inverse())


def _pixel_size(volume, point, pixels):
    """World length of a pixel at a point; `pixels` is the height of the viewport."""
    size = volume.getHeight() / pixels
    if volume.getProjectionType() == coin.SbViewVolume.PERSPECTIVE:
        depth = (point - volume.getProjectionPoint()).dot(volume.getProjectionDirection())
        size *= max(depth, 0.0) / volume.getNearDist()
    return size * QtGui.QGuiApplication.primaryScreen().devicePixelRatio()
