"""A window that shows how far something is, and stops it; only where it takes long."""

import time

import FreeCADGui

from osculate.gui.qt import Qt, QtCore, QtWidgets, translate

_PATIENCE = 0.4  # seconds before the window opens
_STEPS = 1000
_KEYS = (QtCore.QEvent.Type.ShortcutOverride, QtCore.QEvent.Type.KeyPress)


class LongWork(QtCore.QObject):
    """Around something that may take long; gives the function that is told the share done.

    Esc and Cancel stop it. Nothing else can be done in FreeCAD meanwhile.
    """

    _is_any = False  # within another one nothing is shown: the outer one cannot go on
    _is_mine = False

    def __init__(self, title):
        super().__init__()
        self._title = title
        self._dialog = None
        self._is_stopped = False

    def __enter__(self):
        if LongWork._is_any:
            return None
        LongWork._is_any = self._is_mine = True
        self._started = time.monotonic()
        return self._report

    def __exit__(self, *_):
        if not self._is_mine:
            return
        LongWork._is_any = False
        if self._dialog is not None:
            QtWidgets.QApplication.instance().removeEventFilter(self)
            self._dialog.close()
            self._dialog.deleteLater()
            self._dialog = None

    def _report(self, share):
        if self._dialog is None:
            if time.monotonic() - self._started < _PATIENCE:
                return True
            self._open()
        self._dialog.setValue(round(_STEPS * share))
        QtWidgets.QApplication.processEvents()
        return not self._is_stopped

    def _open(self):
        self._dialog = QtWidgets.QProgressDialog(FreeCADGui.getMainWindow())
        self._dialog.setObjectName("OsculateLongWork")
        self._dialog.setWindowTitle("Osculate")
        self._dialog.setLabelText(self._title)
        self._cancel = QtWidgets.QPushButton(translate("Osculate", "Cancel"))
        self._dialog.setCancelButton(self._cancel)
        self._dialog.setRange(0, _STEPS)
        self._dialog.setAutoClose(False)
        self._dialog.setAutoReset(False)
        self._dialog.setMinimumWidth(360)
        self._dialog.setWindowModality(Qt.WindowModality.ApplicationModal)
        self._dialog.canceled.connect(self._stop)
        self._dialog.show()
        # During a recompute FreeCAD keeps keys and mouse to itself: this sees them first.
        QtWidgets.QApplication.instance().installEventFilter(self)

    def _stop(self):
        self._is_stopped = True

    def eventFilter(self, _target, event):
        kind = event.type()
        # Before a key is pressed Qt asks for shortcuts: FreeCAD has one for Esc, as the window has.
        is_stop = ((kind in _KEYS and event.key() == Qt.Key.Key_Escape)
                   or (kind == QtCore.QEvent.Type.MouseButtonRelease
                       and self._is_on_cancel(event)))
        if is_stop:
            self._stop()
        return is_stop

    def _is_on_cancel(self, event):
        place = (event.globalPosition().toPoint() if hasattr(event, "globalPosition")
                 else event.globalPos())
        return self._cancel.rect().contains(self._cancel.mapFromGlobal(place))
