"""The mouse that moves the point of a Probe."""

import FreeCADGui

from gui_case import QTest
from handle_case import MouseUser
from osculate.gui.overlays.screen import Screen
from osculate.gui.qt import Qt, QtCore, QtGui, QtWidgets
from probe_case import ProbeCase


class MouseTest(MouseUser, ProbeCase):
    def setUp(self):
        super().setUp()
        self.form_ = self.run_on((self.wave, "Edge1"))
        self.probe = self.doc.Probe
        self.go_to(0.2)
        self.fit()

    def go_to(self, share):
        self.type_number(self.form_.position.box, str(100.0 * share))

    def pixel(self, share):
        """Where in the canvas a point of the curve is."""
        path = self.probe.Proxy.probe
        x, y = Screen(self.view()).pixel_of(path.at(share * path.length).point)
        return QtCore.QPoint(round(x), self.canvas.height() - 1 - round(y))

    def test_the_point_is_dragged_along_the_curve(self):
        self.press_at(self.pixel(0.2))
        for share in (0.25, 0.4):
            self.move_to(self.pixel(share))
        self.assertAlmostEqual(self.probe.Position, 0.4, delta=0.01)
        self.let_go_at(self.pixel(0.4))
        self.finish("Ok")
        self.assertAlmostEqual(self.probe.Position, 0.4, delta=0.01)
        self.assertAlmostEqual(self.probe.ArcLength.Value,
                               self.probe.Position * self.probe.TotalLength.Value, delta=1e-6)

    def test_escape_takes_a_drag_back(self):
        self.press_at(self.pixel(0.2))
        self.move_to(self.pixel(0.35))
        QTest.keyClick(self.canvas.parent(), Qt.Key.Key_Escape)
        self.pump()
        self.assertAlmostEqual(self.probe.Position, 0.2, delta=1e-9)
        self.let_go_at(self.pixel(0.35))
        self.finish("Ok")

    def test_drags_snap_to_special_points(self):
        target = self.pixel(0.5) + QtCore.QPoint(4, 3)
        for snaps in (True, False):
            self.go_to(0.4)
            self.form_.snap.setChecked(snaps)
            self.press_at(self.pixel(0.4))
            self.move_to(target)
            self.let_go_at(target)
            self.assertEqual(self.probe.At, ["inflection"] if snaps else [], snaps)
        self.finish("Ok")

    def test_follows_the_mouse_until_a_click(self):
        self.click(self.form_.follow)
        for share in (0.3, 0.62):
            self.move_to(self.pixel(share) + QtCore.QPoint(0, 10), Qt.MouseButton.NoButton)
        self.assertAlmostEqual(self.probe.Position, 0.62, delta=0.03)
        self.press_at(self.pixel(0.62))
        self.let_go_at(self.pixel(0.62))
        self.assertFalse(self.form_.follow.isChecked())
        self.move_to(self.pixel(0.9), Qt.MouseButton.NoButton)
        self.assertAlmostEqual(self.probe.Position, 0.62, delta=0.01)
        self.finish("Ok")
        self.assertAlmostEqual(self.probe.ArcLength.Value / self.probe.TotalLength.Value, 0.62,
                               delta=0.01)

    def test_the_panel_may_end_while_the_point_follows(self):
        self.click(self.form_.follow)
        self.move_to(self.pixel(0.3), Qt.MouseButton.NoButton)
        self.finish("Ok")
        self.assertNotAlmostEqual(self.probe.Position, 0.2, delta=0.05)
        self.assertAlmostEqual(self.probe.ArcLength.Value,
                               self.probe.Position * self.probe.TotalLength.Value, delta=1e-6)
        self.form_ = self.edit(self.probe)
        self.click(self.form_.follow)
        self.move_to(self.pixel(0.6), Qt.MouseButton.NoButton)
        FreeCADGui.Control.closeDialog()  # without a button, as FreeCAD may
        self.pump()
        self.assertAlmostEqual(self.probe.Position, 0.6, delta=0.03)

    def test_a_double_click_brings_the_point(self):
        self.click(self.form_.snap)  # there is a vertex nearby
        event = QtGui.QMouseEvent(
            QtCore.QEvent.Type.MouseButtonDblClick, QtCore.QPointF(self.pixel(0.8)),
            QtCore.QPointF(self.canvas.mapToGlobal(self.pixel(0.8))), Qt.MouseButton.LeftButton,
            Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier)
        QtWidgets.QApplication.sendEvent(self.canvas, event)
        self.pump()
        self.assertAlmostEqual(self.probe.Position, 0.8, delta=0.01)
        self.finish("Ok")
