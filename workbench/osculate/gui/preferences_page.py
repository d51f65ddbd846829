"""The page of Osculate in FreeCAD's preferences."""

import FreeCADGui

from osculate.features.tolerance_choice import PRESETS
from osculate.gui import preferences, resources
from osculate.gui.qt import QtGui


class PreferencesPage:
    """FreeCAD shows `form`, and calls loadSettings and saveSettings."""

    def __init__(self, _parent=None):
        self.form = FreeCADGui.PySideUic.loadUi(resources.form_path("preferences"))
        self.form.setWindowIcon(resources.icon("osculate"))
        self.form.preset.addItems(PRESETS)
        self._colors = [_ColorButton(self.form.firstColor), _ColorButton(self.form.secondColor)]

    def loadSettings(self):
        self._show(preferences.load())

    def saveSettings(self):
        form = self.form
        preferences.save(preferences.Preferences(
            preset=form.preset.currentText(), order=form.order.value(),
            follow_selection=form.followSelection.isChecked(),
            show_frames=form.showFrames.isChecked(), show_polygons=form.showPolygons.isChecked(),
            frame_pixels=form.framePixels.value(), label_points=form.labelPoints.value(),
            side_colors=tuple(button.color for button in self._colors)))

    def _show(self, shown):
        form = self.form
        form.preset.setCurrentText(shown.preset)
        form.order.setValue(shown.order)
        form.followSelection.setChecked(shown.follow_selection)
        form.showFrames.setChecked(shown.show_frames)
        form.showPolygons.setChecked(shown.show_polygons)
        form.framePixels.setValue(shown.frame_pixels)
        form.labelPoints.setValue(shown.label_points)
        for button, color in zip(self._colors, shown.side_colors):
            button.color = color


class _ColorButton:
    """FreeCAD's colour button, with its colour as "#rrggbb"."""

    def __init__(self, widget):
        self._widget = widget

    @property
    def color(self):
        return self._widget.property("color").name()

    @color.setter
    def color(self, name):
        self._widget.setProperty("color", QtGui.QColor(name))
