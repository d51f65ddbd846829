"""The commands of Bézier solids, one a file."""

from osculate.gui.commands.solids.export_solid import ExportSolid
from osculate.gui.commands.solids.make_solid import MakeSolid
from osculate.gui.commands.solids.solid_from_points import SolidFromPoints
from osculate.gui.commands.solids.solid_to_brep import SolidToBRep

#: In the order of the toolbar and of the menu.
SOLID_COMMANDS = (MakeSolid, SolidFromPoints, SolidToBRep, ExportSolid)
