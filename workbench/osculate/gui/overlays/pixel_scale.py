"""Nodes whose unit is a pixel of the screen, whatever the camera.

FreeCAD's own nodes for this (SoShapeScale, SoAutoZoomTranslation) differ between its versions and
measure at the origin of the world; this measures at the node's own place.
"""

from pivy import coin

from osculate.gui.overlays import nodes
from osculate.gui.qt import QtGui

#: Stands for the scaling in Coin's traversal state, which asks which node changed the matrix.
_SCALER = coin.SoScale()


def in_pixels(point, *children):
    """Children at a point, in a system of their own whose unit is a pixel of the screen."""
    scale = coin.SoCallback()
    scale.setCallback(_scale_to_pixels)
    node = nodes.at(point, scale, *children)
    node.renderCaching = coin.SoSeparator.OFF
    return node


def _scale_to_pixels(_data, action):
    if not action.isOfType(coin.SoGLRenderAction.getClassTypeId()):
        return
    state = action.getState()
    point = coin.SoModelMatrixElement.get(state).multVecMatrix(coin.SbVec3f(0, 0, 0))
    size = _pixel_size(coin.SoViewVolumeElement.get(state), point,
                       coin.SoViewportRegionElement.get(state).getViewportSizePixels()[1])
    coin.SoModelMatrixElement.scaleBy(state, _SCALER, coin.SbVec3f(size, size, size))


def _pixel_size(volume, point, pixels):
    """World length of a pixel at a point; `pixels` is the height of the viewport."""
    size = volume.getHeight() / pixels
    if volume.getProjectionType() == coin.SbViewVolume.PERSPECTIVE:
        depth = (point - volume.getProjectionPoint()).dot(volume.getProjectionDirection())
        size *= max(depth, 0.0) / volume.getNearDist()
    return size * QtGui.QGuiApplication.primaryScreen().devicePixelRatio()
