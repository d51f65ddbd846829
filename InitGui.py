"""Registers the workbench Osculate; exec'd by FreeCAD without __file__, after Init.py."""

import FreeCADGui

from osculate.gui import registration

registration.register(FreeCADGui)
