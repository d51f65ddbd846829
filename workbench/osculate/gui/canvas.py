"""The widgets of a 3D view."""

import FreeCADGui

from osculate.gui.qt import QtWidgets


def widgets_of(view):
    """(QGraphicsView, QOpenGLWidget) of a view: the one has the keys, the other the mouse.

    None where PySide takes the first for a dead one that had the same address.
    """
    # PySide forgets a widget at its end if it met it among the children of another one first; from
    # FreeCAD's graphicsView() alone it would keep it for ever. So both are asked, in this order.
    met = FreeCADGui.getMainWindow().findChildren(QtWidgets.QGraphicsView)
    try:
        graphics = view.graphicsView()
        canvas = next(widget for widget in graphics.findChildren(QtWidgets.QWidget)
                      if widget.inherits("QOpenGLWidget"))
    except RuntimeError:
        return None
    finally:
        del met
    return graphics, canvas
