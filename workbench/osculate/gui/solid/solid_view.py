"""How a BezierSolid is seen: faces, edges, control net, slices; its points dragged in edit mode."""

import FreeCAD

from osculate.features.control_net import name_of
from osculate.gui import numbers, preferences, resources
from osculate.gui.editable_view import EditableView
from osculate.gui.qt import QtCore, QtGui
from osculate.gui.solid import view_properties
from osculate.gui.solid.look import MODES, SHADED_WITH_EDGES, look_of
from osculate.gui.solid.net_node import weight_of
from osculate.gui.solid.point_edit import PointEdit
from osculate.gui.solid.point_handles import PointHandles
from osculate.gui.solid.solid_node import SolidNode
from osculate.gui.solid.value import in_space, value_of

_MODE = "Solid"  # the only one of Coin's switch; what a mode shows is decided in SolidNode
_INPUTS = ("Points", "Weights", "FourthCoordinates")


class SolidView(EditableView):
    """View provider proxy of a BezierSolid; documents name this class."""

    _mode = SHADED_WITH_EDGES
    _handles = _edit = None  # while the object is edited
    _solid = None    # what is drawn, in E3
    _is_late = False  # it is to be drawn when everything is loaded

    def attach(self, vobj):
        super().attach(vobj)
        self._node = SolidNode(vobj.Object.Document.Name, vobj.Object.Name)
        vobj.addDisplayMode(self._node.node, _MODE)
        view_properties.complete(vobj)
        self._draw()

    # What FreeCAD asks and tells

    def getDisplayModes(self, _vobj):
        return list(MODES)

    def getDefaultDisplayMode(self):
        return SHADED_WITH_EDGES

    def setDisplayMode(self, mode):
        self._mode = mode if mode in MODES else SHADED_WITH_EDGES
        self._draw()
        return _MODE

    def getIcon(self):
        return resources.icon_path("bezier-solid")

    def updateData(self, _obj, prop):
        if prop in _INPUTS or (prop == "Label" and self._object.ViewObject.ColorByJacobian):
            self._draw()

    def onChanged(self, vobj, prop):
        if prop in (*view_properties.NAMES, "Visibility") and view_properties.are_complete(vobj):
            self._draw()

    # Editing

    def make_panel(self, obj):
        from osculate.gui.solid_panel.net_panel import NetPanel
        return NetPanel(obj.Document, obj)

    def editing_changed(self):
        if self._panel is not None:
            self.start_dragging(self._panel.session)
        else:
            self.stop_dragging()

    def start_dragging(self, session):
        """From now on the control points can be dragged, each drag a step of a Session."""
        self._edit = PointEdit(session)  # Qt alone does not keep it
        self._handles = PointHandles(self._object.Document.Name)
        self._node.node.addChild(self._handles.node)
        self._handles.moved.connect(self._edit.move)
        for signal, end in ((self._handles.let_loose, self._edit.finish),
                            (self._handles.taken_back, self._edit.cancel)):
            signal.connect(end)
            signal.connect(self._draw)  # finely again
        self._handles.hovered.connect(self._show_handles)
        self._draw()

    def stop_dragging(self):
        """Leaves no handle."""
        self._end_handles()
        self._draw()

    def _end_handles(self):
        if self._handles is not None:
            self._node.node.removeChild(self._handles.node)
            self._handles.remove()
            self._handles = self._edit = None

    # Drawing

    def finishRestoring(self):
        """FreeCAD has loaded everything: what waited for it is drawn."""
        self._is_late = False
        self._draw()

    def _draw_late(self):
        """Once for all the properties of a document that is loaded."""
        if FreeCAD.isRestoring():
            QtCore.QTimer.singleShot(0, self._draw_late)
        elif self._is_late:
            self.finishRestoring()

    def _draw(self):
        if FreeCAD.isRestoring():
            if not self._is_late:
                self._is_late = True
                self._draw_late()
            return
        try:
            vobj = self._object.ViewObject
        except ReferenceError:
            return  # it was deleted meanwhile
        if vobj is None or not view_properties.are_complete(vobj):
            return
        solid = value_of(self._object)
        if solid is None:
            return
        self._solid = in_space(solid)
        look = look_of(vobj, self._mode, self._handles is not None,
                       preferences.load().label_points)
        self._node.show(self._solid, look,
                        self._handles is not None and self._handles.is_dragging)
        self._show_handles()

    def _show_handles(self):
        if self._handles is not None and self._solid is not None:
            color = QtGui.QColor.fromRgbF(*self._object.ViewObject.NetColor[:3]).name()
            self._handles.show(self._solid.points, color, self._caption)

    def _caption(self, place):
        """(text, size) of what is said of the control point at the mouse."""
        point = ", ".join(numbers.number(float(x)) for x in self._solid.points[place])
        text = f"{name_of(self._solid.degree, place)}   ({point}) mm"
        if self._solid.is_rational:
            text += f"   w = {numbers.number(weight_of(self._solid, place))}"
        return text, preferences.load().label_points
