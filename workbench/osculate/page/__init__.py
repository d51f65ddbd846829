"""An audit as one HTML page. Needs neither FreeCAD nor a screen."""
