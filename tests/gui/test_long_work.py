"""The window of an audit that takes long, and stopping it."""

import time
from unittest import mock

import FreeCAD
import FreeCADGui
import Part

import osculate
from construct_case import ConstructCase
from gui_case import QTest
from osculate.features import make_audit
from osculate.gui import long_work
from osculate.gui.audit.audit_form import AuditForm
from osculate.gui.long_work import LongWork
from osculate.gui.qt import Qt, QtCore, QtWidgets


def window():
    """The window that is open, or None."""
    found = FreeCADGui.getMainWindow().findChildren(QtWidgets.QProgressDialog, "OsculateLongWork")
    return next((dialog for dialog in found if dialog.isVisible()), None)


class LongWorkCase(ConstructCase):
    """A polygon of 30,000 edges; the window opens at once."""

    form_type = AuditForm
    command = "Osculate_Audit"

    def setUp(self):
        super().setUp()
        patience = mock.patch.object(long_work, "_PATIENCE", 0.0)
        patience.start()
        self.addCleanup(patience.stop)
        self.saw = 0  # how often the window was seen

    def polygon(self, count=30000):
        obj = self.doc.addObject("Part::Feature", "Polygon")
        obj.Visibility = False
        obj.Shape = Part.makePolygon([FreeCAD.Vector(i, i % 2, 0) for i in range(count + 1)])
        self.doc.recompute()
        return obj

    def when_seen(self, act):
        """Calls `act(window)` once the window is open."""
        timer = QtCore.QTimer()
        timer.setInterval(1)

        def look():
            dialog = window()
            if dialog is not None:
                self.saw += 1
                timer.stop()
                act(dialog)

        timer.timeout.connect(look)
        timer.start()
        self.addCleanup(timer.stop)


class StopTest(LongWorkCase):
    def test_escape_stops_the_command_and_leaves_the_document_as_it_was(self):
        polygon = self.polygon()
        undos = self.doc.UndoCount
        self.when_seen(lambda dialog: QTest.keyClick(dialog, Qt.Key.Key_Escape))
        self.select((polygon, ""))
        FreeCADGui.runCommand(self.command)
        self.wait_for(lambda: self.saw, "the window")
        self.wait_for(lambda: not FreeCADGui.Control.activeDialog(), "the panel to close")
        self.assertEqual((self.names(), self.doc.UndoCount), (["Polygon"], undos))
        self.assertIsNone(window())

    def test_cancel_stops_a_recompute_and_the_last_numbers_stay(self):
        polygon = self.polygon()
        obj = make_audit(self.doc, [polygon], pairs="all")
        self.assertEqual((obj.Status, obj.Joins), ("OK", 29999))
        polygon.Placement.Base.z = 1.0
        self.when_seen(lambda dialog: QTest.mouseClick(
            dialog.findChild(QtWidgets.QPushButton), Qt.MouseButton.LeftButton))
        self.doc.recompute()
        self.assertEqual(self.saw, 1)
        self.assertIn("stopped", obj.Status)
        self.assertFalse(obj.isValid())
        self.assertEqual(obj.Joins, 29999)
        self.doc.recompute()  # it is still to be done
        self.assertEqual((obj.Status, obj.Proxy.was_stopped), ("OK", False))
        self.assertAlmostEqual(obj.WorstPosition.z, 1.0, delta=1e-12)

    def test_what_draws_meanwhile_begins_no_other_audit(self):
        polygon = self.polygon(10000)
        self.when_seen(lambda dialog: None)
        with mock.patch.object(osculate, "audit", wraps=osculate.audit) as audit:
            obj = make_audit(self.doc, [polygon], pairs="all")
            self.pump()
        self.assertEqual((self.saw, audit.call_count, obj.Joins), (1, 1, 9999))
        self.assertEqual(sum(obj.ViewObject.Proxy._joins.counts.values()), 9999)

    def test_the_window_shows_how_far_it_is(self):
        self.when_seen(lambda dialog: self.screenshot("long_work"))
        with LongWork("Auditing Impeller…") as report:
            for step in range(5):
                self.assertIs(report(step / 5), True)
                self.pump()
            self.assertEqual(window().value(), 800)
        self.assertIsNone(window())
        self.assertEqual(self.saw, 1)

    def test_of_short_work_nothing_is_seen(self):
        with mock.patch.object(long_work, "_PATIENCE", 5.0), LongWork("Short") as report:
            self.assertIs(report(0.5), True)
            self.assertIsNone(window())

    def test_within_another_one_nothing_is_told(self):
        with LongWork("Outer") as outer:
            with LongWork("Inner") as inner:
                self.assertIsNone(inner)
            self.assertIs(outer(0.1), True)
        with LongWork("Next") as following:
            self.assertIsNotNone(following)

    def test_keys_are_free_again_afterwards(self):
        with LongWork("Work") as report:
            report(0.1)
            started = time.monotonic()
            QTest.keyClick(window(), Qt.Key.Key_Escape)
            self.assertIs(report(0.2), False)
            self.assertLess(time.monotonic() - started, 5.0)
        box = QtWidgets.QLineEdit()
        box.show()
        QTest.keyClicks(box, "abc")
        self.assertEqual(box.text(), "abc")
        box.close()
