"""matplotlib's canvas for the Qt that FreeCAD brings; importing it takes a second, or fails."""

import sys
from contextlib import contextmanager

from osculate.gui.qt import QtCore

_OURS = QtCore.QObject.__module__.partition(".")[0]  # "PySide2" or "PySide6"
_BINDINGS = ("PyQt6", "PySide6", "PyQt5", "PySide2")  # in the order in which matplotlib looks


@contextmanager
def ours_alone():
    """Hides other bindings that some add-on imported: matplotlib takes the first that it finds."""
    names = [f"{binding}.QtCore" for binding in _BINDINGS if binding != _OURS]
    hidden = {name: sys.modules.pop(name) for name in names if name in sys.modules}
    try:
        yield
    finally:
        sys.modules.update(hidden)


try:
    with ours_alone():
        from matplotlib.backends.backend_qtagg import FigureCanvasQTAgg
        from matplotlib.backends.qt_compat import QT_API
except Exception as error:  # a broken installation raises RuntimeError, among others
    raise ImportError("curve plots are drawn with matplotlib 3.5 or newer, which does not load "
                      f"(Debian: python3-matplotlib; pip install matplotlib): {error}",
                      name="matplotlib") from error
if QT_API != _OURS:
    raise ImportError(f"matplotlib was loaded with {QT_API} before, but FreeCAD has {_OURS}; start "
                      "FreeCAD again and open the curve plot first", name="matplotlib")

__all__ = ["FigureCanvasQTAgg", "ours_alone"]
