"""The part of Osculate that needs FreeCAD's GUI: workbench, commands, panels, overlays, views."""
